#include "adapt/locate.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <Eigen/LU>
#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "base/errors.hpp"
#include "fem/element.hpp"

namespace reye::adapt {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;  // CGAL 5.5 knows it in space only: z = 0

using Corners = Eigen::Matrix<double, 4, 2>;
using LocalTriangle = std::array<int, 3>;  ///< corners of a cell

/// A sub-triangle in the tree: its cell and the corners it is made of.
struct Part {
  int cell;
  LocalTriangle corners;
};

constexpr double round_off = 1e-14;

double doubled_area(const Corners& X, const LocalTriangle& t) {
  return base::cross(Vec2(X.row(t[1]) - X.row(t[0])), Vec2(X.row(t[2]) - X.row(t[0])));
}

/// The cut of a cell whose poorer triangle has the larger signed area: that of a concave quadrilateral runs through
/// its reflex corner, so that the two triangles cover just the cell.
std::vector<LocalTriangle> cut(mesh::CellKind kind, const Corners& X) {
  if (kind == mesh::CellKind::tri3) return {{0, 1, 2}};
  const std::vector<LocalTriangle> one{{0, 1, 2}, {0, 2, 3}}, other{{0, 1, 3}, {1, 2, 3}};
  const auto poorer = [&](const auto& c) { return std::min(doubled_area(X, c[0]), doubled_area(X, c[1])); };
  return poorer(one) >= poorer(other) ? one : other;
}

/// A triangle without area has no nearest point that can be computed; the others cover its place.
bool flat(const Corners& X, const LocalTriangle& t) {
  double longest = 0.0;
  for (int k = 0; k < 3; ++k) longest = std::max(longest, (X.row(t[(k + 1) % 3]) - X.row(t[k])).squaredNorm());
  return !(std::abs(doubled_area(X, t)) > round_off * longest);
}

Eigen::Vector3d barycentric(const Corners& X, const LocalTriangle& t, const Vec2& p) {
  const Vec2 a = X.row(t[0]), b = X.row(t[1]), c = X.row(t[2]);
  const double area = base::cross(b - a, c - a);
  Eigen::Vector3d w(0.0, base::cross(p - a, c - a) / area, base::cross(b - a, p - a) / area);
  w[0] = 1.0 - w[1] - w[2];
  w = w.cwiseMax(0.0);
  return w / w.sum();
}

Vec2 reference_corner(mesh::CellKind kind, int a) {
  static const std::array<Vec2, 4> triangle{Vec2{0, 0}, {1, 0}, {0, 1}, {0, 0}},
      square{Vec2{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  return kind == mesh::CellKind::tri3 ? triangle[a] : square[a];
}

/// Newton for x(xi) = p in a bilinear cell; nothing when it does not end in the square with det J > 0.
std::optional<Vec2> inverse(const Corners& X, const Vec2& p, Vec2 xi) {
  constexpr auto kind = mesh::CellKind::quad4;
  constexpr int most_steps = 30;
  constexpr double end = 1e-13, rim = 1e-9;  // the rim is for points on an edge: what exceeds 1 is round-off
  const Eigen::RowVector2d origin = X.colwise().mean();  // small numbers about it: round-off of the cell's size
  const Corners Y = X.rowwise() - origin;
  const Vec2 q = p - origin.transpose();
  double last = 0.0;
  for (int k = 0; k < most_steps; ++k) {
    const Eigen::Matrix2d Jt = (fem::shape_gradients(kind, xi).topRows<4>().transpose() * Y).transpose();  // dx_i / dxi_j
    const Vec2 step = Jt.inverse() * (q - Y.transpose() * fem::shape_functions(kind, xi).head<4>());
    last = step.norm();
    if (!std::isfinite(last)) return std::nullopt;
    xi += last > 1.0 ? Vec2(step / last) : step;
    if (last <= end) break;
  }
  const double det = (fem::shape_gradients(kind, xi).topRows<4>().transpose() * Y).determinant();
  if (last > rim || xi.cwiseAbs().maxCoeff() > 1.0 + rim || !(det > 0.0)) return std::nullopt;
  return Vec2(xi.cwiseMax(-1.0).cwiseMin(1.0));
}

/// Starts of Newton in a folded cell: the centre, and half way to each corner.
std::optional<Vec2> inverse_from_anywhere(const Corners& X, const Vec2& p) {
  auto xi = inverse(X, p, Vec2::Zero());
  for (int a = 0; a < 4 && !xi; ++a) xi = inverse(X, p, 0.5 * reference_corner(mesh::CellKind::quad4, a));
  return xi;
}

}  // namespace

struct Locator::Impl {
  mesh::CellKind kind;
  Points X;
  std::vector<mesh::Cell> cells;
  SegmentTree nodes;
  double on_a_node;                          ///< [mm]
  std::vector<std::vector<int>> neighbours;  ///< cells at each node
  std::vector<Part> parts;
  Triangles triangles;  ///< of the parts
  Tree tree;

  explicit Impl(const mesh::Mesh& mesh)
      : kind(mesh.kind), X(mesh.X), cells(mesh.cells), nodes(mesh.X), neighbours(mesh.X.size()) {
    double largest = 0.0;
    for (const Vec2& x : X) largest = std::max(largest, x.cwiseAbs().maxCoeff());
    on_a_node = round_off * largest;
    for (int cell = 0; cell < static_cast<int>(cells.size()); ++cell) add(cell);
    if (triangles.empty()) throw base::MeshError("a mesh whose cells have no area cannot be searched");
    tree.insert(triangles.begin(), triangles.end());
    tree.build();
    tree.accelerate_distance_queries();
  }

  int corner_count() const { return mesh::nodes_per_cell(kind); }

  Corners corners(int cell) const {
    Corners result = Corners::Zero();
    for (int a = 0; a < corner_count(); ++a) result.row(a) = X[cells[cell][a]];
    return result;
  }

  void add(int cell) {
    for (int a = 0; a < corner_count(); ++a) neighbours[cells[cell][a]].push_back(cell);
    const Corners C = corners(cell);
    const auto point = [&](int a) { return Kernel::Point_3(C(a, 0), C(a, 1), 0.0); };
    for (const auto& t : cut(kind, C)) {
      if (flat(C, t)) continue;
      parts.push_back({cell, t});
      triangles.emplace_back(point(t[0]), point(t[1]), point(t[2]));
    }
  }

  Place at(int cell, const Vec2& xi) const { return {cell, xi, fem::shape_functions(kind, xi), 0.0}; }

  Place on_node(int node) const {
    const int cell = neighbours[node].front();
    const int a = static_cast<int>(std::find(cells[cell].begin(), cells[cell].end(), node) - cells[cell].begin());
    return {cell, reference_corner(kind, a), mesh::NodeValues::Unit(a), 0.0};
  }

  Place in_part(const Part& part, const Vec2& q) const {
    Place place{part.cell};
    const Eigen::Vector3d w = barycentric(corners(part.cell), part.corners, q);
    for (int k = 0; k < 3; ++k) {
      place.weights[part.corners[k]] = w[k];
      place.xi += w[k] * reference_corner(kind, part.corners[k]);
    }
    return place;
  }

  /// In a sound mesh the first try succeeds; the others are for folded cells and their surroundings.
  Place in_quad(const Part& part, const Vec2& q) const {
    const Place rough = in_part(part, q);
    if (const auto xi = inverse(corners(part.cell), q, rough.xi)) return at(part.cell, *xi);
    if (const auto xi = inverse_from_anywhere(corners(part.cell), q)) return at(part.cell, *xi);
    for (int a = 0; a < 4; ++a)
      for (int cell : neighbours[cells[part.cell][a]])
        if (const auto xi = inverse_from_anywhere(corners(cell), q)) return at(cell, *xi);
    return rough;
  }

  Place find(const Vec2& p) const {
    if (const auto node = nodes.nearest(p, {}, on_a_node); node.segment >= 0 && !neighbours[node.segment].empty())
      return on_node(node.segment);
    // Without a hint on purpose: one that is far off disables the pruning of the tree.
    const auto [closest, id] = tree.closest_point_and_primitive(Kernel::Point_3(p.x(), p.y(), 0.0));
    const Part& part = parts[id - triangles.begin()];
    const Vec2 q(closest.x(), closest.y());
    Place place = kind == mesh::CellKind::tri3 ? in_part(part, q) : in_quad(part, q);
    place.distance = (p - q).norm();
    return place;
  }
};

Locator::Locator(const mesh::Mesh& mesh) : impl_(std::make_unique<const Impl>(mesh)) {}
Locator::~Locator() = default;
Locator::Locator(Locator&&) noexcept = default;
Locator& Locator::operator=(Locator&&) noexcept = default;
Locator::Place Locator::find(const Vec2& p) const { return impl_->find(p); }

namespace {

std::vector<SegmentTree::Segment> as_segments(const Points& points) {
  std::vector<SegmentTree::Segment> segments;
  for (const Vec2& x : points) segments.push_back({x, x});
  return segments;
}

SegmentTree::Foot foot(const SegmentTree::Segment& segment, int number, const Vec2& p) {
  const Vec2 e = segment[1] - segment[0];
  const double square = e.squaredNorm();
  const double s = square > 0.0 ? std::clamp(e.dot(p - segment[0]) / square, 0.0, 1.0) : 0.0;
  const Vec2 at = s < 0.5 ? Vec2(segment[0] + s * e) : Vec2(segment[1] - (1.0 - s) * e);  // both ends to the bit
  return {number, s, (p - at).norm()};
}

}  // namespace

SegmentTree::SegmentTree(std::vector<Segment> segments) : segments_(std::move(segments)), order_(segments_.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  if (!order_.empty()) build(0, static_cast<int>(order_.size()));
}

SegmentTree::SegmentTree(const Points& points) : SegmentTree(as_segments(points)) {}

int SegmentTree::build(int begin, int end) {
  constexpr int leaf = 4;
  Box box{segments_[order_[begin]][0], segments_[order_[begin]][0], begin, end};
  for (int i = begin; i < end; ++i)
    for (const Vec2& x : segments_[order_[i]]) {
      box.low = box.low.min(x.array());
      box.high = box.high.max(x.array());
    }
  const int self = static_cast<int>(boxes_.size());
  boxes_.push_back(box);
  if (end - begin <= leaf) return self;
  const int along = box.high[0] - box.low[0] >= box.high[1] - box.low[1] ? 0 : 1, middle = (begin + end) / 2;
  const auto key = [&](int k) { return std::pair{segments_[k][0][along] + segments_[k][1][along], k}; };
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](int i, int j) { return key(i) < key(j); });
  const int left = build(begin, middle), right = build(middle, end);
  boxes_[self].left = left;
  boxes_[self].right = right;
  return self;
}

SegmentTree::Foot SegmentTree::nearest(const Vec2& p, const std::function<bool(int)>& wanted, double within) const {
  Foot best;
  const auto away = [&](int b) {
    return (boxes_[b].low - p.array()).max(p.array() - boxes_[b].high).max(0.0).matrix().norm();
  };
  const auto bound = [&] { return std::min(within, best.distance); };
  std::vector<std::pair<double, int>> open;
  if (!boxes_.empty()) open.emplace_back(away(0), 0);
  while (!open.empty()) {
    const auto [distance, b] = open.back();
    open.pop_back();
    if (distance > bound()) continue;
    const Box& box = boxes_[b];
    if (box.left >= 0) {
      std::pair near{away(box.left), box.left}, far{away(box.right), box.right};
      if (far < near) std::swap(near, far);
      open.push_back(far);
      open.push_back(near);
      continue;
    }
    for (int i = box.begin; i < box.end; ++i) {
      if (wanted && !wanted(order_[i])) continue;
      const Foot f = foot(segments_[order_[i]], order_[i], p);
      if (f.distance <= within && std::pair{f.distance, f.segment} < std::pair{best.distance, best.segment}) best = f;
    }
  }
  return best;
}

}  // namespace reye::adapt
