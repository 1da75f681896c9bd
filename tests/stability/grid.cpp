#include "stability/grid.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <random>
#include <vector>

namespace reye::test {

namespace {

struct Point {
  double x = 0.0, y = 0.0;
};

/// Which side of a block meets the other one.
enum class Meets { below, above };

int order_of(Element e) { return e == Element::quad8 || e == Element::tri6 ? 2 : 1; }

/// Share t in [-1, 1] of half a width, crowded about zero.
double crowded(double t, double power) { return std::copysign(std::pow(std::abs(t), power), t); }

/// The nodes of one block as a lattice with `order` steps per element.
class Lattice {
 public:
  Lattice(const Block& block, Meets meets, unsigned seed)
      : b_(block), meets_(meets), order_(order_of(block.element)), random_(seed), shift_(corner_shifts()) {}

  int columns() const { return order_ * b_.nx + 1; }
  int rows() const { return order_ * b_.ny + 1; }

  Point at(int i, int j) {
    Point p = regular(i, j);
    const Point s = shift(i, j);
    return {p.x + s.x, p.y + s.y};
  }

 private:
  /// The share of a place between corners: the mean of those beside it, so that mid nodes are in the middle.
  template <class Share>
  double between(int k, Share share) const {
    return 0.5 * (share(k / order_ * order_) + share((k + order_ - 1) / order_ * order_));
  }

  /// Where node (i, j) lies on the undisturbed block; j counts from below.
  Point regular(int i, int j) const {
    const double half = 0.5 * (b_.x1 - b_.x0);
    const double x = half * between(i, [&](int k) { return crowded(2.0 * k / (columns() - 1) - 1.0, b_.grade_x); });
    const double away = between(j, [&](int k) {  // from the contact edge, share of the height
      const double t = static_cast<double>(k) / (rows() - 1);
      return std::pow(meets_ == Meets::below ? t : 1.0 - t, b_.grade_y);
    });
    const double crown = b_.crown_mm > 0.0 ? b_.crown_mm - std::sqrt(b_.crown_mm * b_.crown_mm - x * x) : 0.0;
    const double y = crown + (b_.height - crown) * away;
    return {b_.x0 + half + x, meets_ == Meets::below ? b_.y0 + y : b_.y0 + b_.height - y};
  }

  double draw() { return 2.0 * (static_cast<double>(random_()) / static_cast<double>(std::mt19937::max())) - 1.0; }

  std::vector<Point> corner_shifts() {
    std::vector<Point> shifts;
    const double width = b_.x1 - b_.x0;
    for (int j = 0; j <= b_.ny; ++j)
      for (int i = 0; i <= b_.nx; ++i) {
        const bool inner = i > 0 && i < b_.nx && j > 0 && j < b_.ny;
        const Point low = regular(order_ * (i - (i > 0)), order_ * (j - (j > 0)));
        const Point high = regular(order_ * (i + (i == 0)), order_ * (j + (j == 0)));
        const double by = inner ? b_.distort : 0.0;
        const double dx = by * (high.x - low.x) + b_.noise * width, dy = by * (high.y - low.y) + b_.noise * width;
        shifts.push_back({dx * draw(), dy * draw()});
      }
    return shifts;
  }

  /// Of a node between corners: the mean of those beside it.
  Point shift(int i, int j) const {
    const auto corner = [&](int a, int b) { return shift_[static_cast<std::size_t>(b * (b_.nx + 1) + a)]; };
    const Point p = corner(i / order_, j / order_);
    const Point q = corner((i + order_ - 1) / order_, (j + order_ - 1) / order_);
    return {0.5 * (p.x + q.x), 0.5 * (p.y + q.y)};
  }

  const Block& b_;
  Meets meets_;
  int order_;
  std::mt19937 random_;
  std::vector<Point> shift_;
};

/// The lines of a gmsh file. Entities: curve 1 below, 2 above, surface 3.
class File {
 public:
  File(const Block& block, Meets meets, unsigned seed, double length) : length_(length) {
    Lattice lattice(block, meets, seed);
    const int o = order_of(block.element);
    const auto node = [&](int i, int j) { return tag(lattice, i, j); };
    for (int j = 0; j < o * block.ny; j += o)
      for (int i = 0; i < o * block.nx; i += o) {
        const std::array<std::array<int, 2>, 4> c{{{i, j}, {i + o, j}, {i + o, j + o}, {i, j + o}}};
        const auto cell = [&](int type, const std::vector<int>& corners) {
          std::vector<int> nodes;
          for (int k : corners) nodes.push_back(node(c[k][0], c[k][1]));
          for (std::size_t k = 0; o == 2 && k < corners.size(); ++k) {
            const auto &a = c[corners[k]], &b = c[corners[(k + 1) % corners.size()]];
            nodes.push_back(node((a[0] + b[0]) / 2, (a[1] + b[1]) / 2));
          }
          element(type, 3, nodes);
        };
        switch (block.element) {
          case Element::quad4:
            cell(3, {0, 1, 2, 3});
            break;
          case Element::quad8:
            cell(16, {0, 1, 2, 3});
            break;
          case Element::tri3:
            cell(2, {0, 1, 2}), cell(2, {0, 2, 3});
            break;
          case Element::tri6:
            cell(9, {0, 1, 2}), cell(9, {0, 2, 3});
            break;
        }
      }
    for (const auto& [curve, j] : {std::pair{1, 0}, std::pair{2, o * block.ny}})
      for (int i = 0; i < o * block.nx; i += o) {
        std::vector<int> nodes{node(i, j), node(i + o, j)};
        if (o == 2) nodes.push_back(node(i + 1, j));
        element(o == 2 ? 8 : 1, curve, nodes);
      }
  }

  std::string text(const std::string& name) const {
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n1 1 \"" + name + "_bottom\"\n1 2 \"" + name +
           "_top\"\n2 3 \"" + name + "\"\n$EndPhysicalNames\n$Nodes\n" + std::to_string(node_count_) + "\n" + nodes_ +
           "$EndNodes\n$Elements\n" + std::to_string(element_count_) + "\n" + elements_ + "$EndElements\n";
  }

 private:
  int tag(Lattice& lattice, int i, int j) {
    const auto [found, fresh] = placed_.try_emplace({i, j}, node_count_ + 1);
    if (fresh) {
      const Point p = lattice.at(i, j);
      char line[96];
      std::snprintf(line, sizeof line, "%d %.17g %.17g 0\n", ++node_count_, length_ * p.x, length_ * p.y);
      nodes_ += line;
    }
    return found->second;
  }

  void element(int type, int entity, const std::vector<int>& nodes) {
    elements_ += std::to_string(++element_count_) + ' ' + std::to_string(type) + " 2 " + std::to_string(entity) + ' ' +
                 std::to_string(entity);
    for (int n : nodes) elements_ += ' ' + std::to_string(n);
    elements_ += '\n';
  }

  double length_;
  std::map<std::array<int, 2>, int> placed_;
  int node_count_ = 0, element_count_ = 0;
  std::string nodes_, elements_;
};

}  // namespace

std::string slider_file(const Blocks& blocks, double length) {
  return File(blocks.slider, Meets::below, blocks.seed, length).text("slider");
}

std::string base_file(const Blocks& blocks, double length) {
  return File(blocks.base, Meets::above, blocks.seed + 1000, length).text("base");
}

}  // namespace reye::test
