#include "adapt/transfer/locate.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <Eigen/LU>
#include <algorithm>
#include <optional>
#include <utility>

#include "adapt/shape/segment_tree.hpp"
#include "base/errors.hpp"
#include "fem/element.hpp"
#include "mesh/quadratic_edge.hpp"

namespace reye::adapt {

namespace {

using SimpleKernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<SimpleKernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<SimpleKernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<SimpleKernel, Primitive>>;  // CGAL 5.5 knows it in space only: z = 0

using NodePositions =
    Eigen::Matrix<double, mesh::most_cell_nodes, 2>;  ///< positions of the nodes of a cell, unused rows zero
using LocalTriangle = std::array<int, 3>;             ///< nodes of a cell

/// A sub-triangle in the tree: its cell and the nodes it is made of.
struct SubTriangle {
  int cell;
  LocalTriangle nodes;
};

constexpr double of_its_size = 1e-14;  ///< a triangle is flat below it, a point on a node

double doubled_area(const NodePositions& X, const LocalTriangle& t) {
  return base::cross(Vec2(X.row(t[1]) - X.row(t[0])), Vec2(X.row(t[2]) - X.row(t[0])));
}

/// The cut of a cell whose poorer triangle has the larger signed area: that of a concave quadrilateral runs through
/// its reflex corner, so that the two triangles cover just the cell. Cells of second order are cut along their mid
/// nodes.
std::vector<LocalTriangle> cut(mesh::CellKind kind, const NodePositions& X) {
  if (kind == mesh::CellKind::tri3) return {{0, 1, 2}};
  if (kind == mesh::CellKind::tri6) return {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
  if (kind == mesh::CellKind::quad8) return {{0, 4, 7}, {4, 1, 5}, {5, 2, 6}, {7, 6, 3}, {4, 5, 6}, {4, 6, 7}};
  const std::vector<LocalTriangle> one{{0, 1, 2}, {0, 2, 3}}, other{{0, 1, 3}, {1, 2, 3}};
  const auto poorer = [&](const auto& c) { return std::min(doubled_area(X, c[0]), doubled_area(X, c[1])); };
  return poorer(one) >= poorer(other) ? one : other;
}

/// A triangle without area has no nearest point that can be computed; the others cover its place.
bool flat(const NodePositions& X, const LocalTriangle& t) {
  double longest = 0.0;
  for (int k = 0; k < 3; ++k) longest = std::max(longest, (X.row(t[(k + 1) % 3]) - X.row(t[k])).squaredNorm());
  return !(std::abs(doubled_area(X, t)) > of_its_size * longest);
}

Eigen::Vector3d barycentric(const NodePositions& X, const LocalTriangle& t, const Vec2& p) {
  const Vec2 a = X.row(t[0]), b = X.row(t[1]), c = X.row(t[2]);
  const double area = base::cross(b - a, c - a);
  Eigen::Vector3d w(0.0, base::cross(p - a, c - a) / area, base::cross(b - a, p - a) / area);
  w[0] = 1.0 - w[1] - w[2];
  w = w.cwiseMax(0.0);
  return w / w.sum();
}

/// The point itself, or the rim of the reference cell where it lies outside by round-off; nothing when by more.
std::optional<Vec2> on_reference_cell(mesh::CellKind kind, const Vec2& xi) {
  constexpr double rim = 1e-9;
  if (mesh::corners(kind) == 4) {
    if (xi.cwiseAbs().maxCoeff() > 1.0 + rim) return std::nullopt;
    return Vec2(xi.cwiseMax(-1.0).cwiseMin(1.0));
  }
  Eigen::Vector3d w(1.0 - xi.x() - xi.y(), xi.x(), xi.y());
  if (w.minCoeff() < -rim) return std::nullopt;
  w = w.cwiseMax(0.0);
  return Vec2(w.tail<2>() / w.sum());
}

/// Newton for x(xi) = p in a cell of n nodes (quad4: 4, second order: 8); nothing when it does not end in the
/// reference cell with det J > 0.
template <int n>
std::optional<Vec2> inverse(mesh::CellKind kind, const NodePositions& X, const Vec2& p, Vec2 xi) {
  constexpr int most_steps = 30;
  constexpr double end = 1e-13, enough = 1e-9;
  const Eigen::RowVector2d origin = X.topRows<n>().colwise().mean();  // small numbers about it: round-off of the cell
  const Eigen::Matrix<double, n, 2> Y = X.topRows<n>().rowwise() - origin;
  const Vec2 q = p - origin.transpose();
  const auto jacobian = [&] {  // dx_i / dxi_j
    const Eigen::Matrix<double, n, 2> gradients = fem::shape_gradients(kind, xi).topRows<n>();
    return Eigen::Matrix2d(Y.transpose().lazyProduct(gradients));
  };
  double last = 0.0;
  for (int k = 0; k < most_steps; ++k) {
    const Eigen::Matrix<double, n, 1> N = fem::shape_functions(kind, xi).head<n>();
    const Vec2 rest = q - Y.transpose().lazyProduct(N);
    const Vec2 step = Eigen::Matrix2d(jacobian().inverse()) * rest;
    last = step.norm();
    if (!std::isfinite(last)) return std::nullopt;
    xi += last > 1.0 ? Vec2(step / last) : step;
    if (last <= end) break;
  }
  if (last > enough || !(jacobian().determinant() > 0.0)) return std::nullopt;
  return on_reference_cell(kind, xi);
}

/// Starts of Newton in a folded or curved cell: the centre, and half way to each corner.
template <int n>
std::optional<Vec2> inverse_from_anywhere(mesh::CellKind kind, const NodePositions& X, const Vec2& p) {
  const Vec2 centre = mesh::corners(kind) == 3 ? Vec2(1.0 / 3.0, 1.0 / 3.0) : Vec2(0.0, 0.0);
  auto xi = inverse<n>(kind, X, p, centre);
  for (int a = 0; a < mesh::corners(kind) && !xi; ++a)
    xi = inverse<n>(kind, X, p, 0.5 * (centre + mesh::reference_node(kind, a)));
  return xi;
}

/// The point of an edge of a cell of second order nearest to p, as reference coordinates of the cell. Newton for
/// (x(t) - p) . x'(t) = 0 from the foot on the chord, clamped to the edge.
Vec2 nearest_on_edge(mesh::CellKind kind, const NodePositions& X, int k, const Vec2& p) {
  const int n = mesh::corners(kind), next = (k + 1) % n;
  const mesh::QuadraticEdge edge{X.row(k), X.row(n + k), X.row(next)};
  const Vec2 chord = edge.last - edge.first, bend = edge.first + edge.last - 2.0 * edge.mid;
  double t = std::clamp(2.0 * (p - edge.first).dot(chord) / chord.squaredNorm() - 1.0, -1.0, 1.0);
  for (int step = 0; step < 20; ++step) {
    const Vec2 tangent = edge.tangent(t), off = edge.at(t) - p;
    const double slope = std::max(tangent.squaredNorm() + off.dot(bend), 0.1 * tangent.squaredNorm());
    const double to = std::clamp(t - off.dot(tangent) / slope, -1.0, 1.0);
    if (std::abs(to - t) < 1e-15) break;
    t = to;
  }
  return 0.5 * (1.0 - t) * mesh::reference_node(kind, k) + 0.5 * (1.0 + t) * mesh::reference_node(kind, next);
}

}  // namespace

struct Locator::Impl {
  mesh::CellKind kind;
  Points X;
  std::vector<mesh::Cell> cells;
  SegmentTree nodes;
  double on_a_node;                          ///< [mm]
  std::vector<std::vector<int>> neighbours;  ///< cells at each node
  std::vector<SubTriangle> parts;
  Triangles triangles;  ///< of the parts
  Tree tree;

  explicit Impl(const mesh::Mesh& mesh)
      : kind(mesh.kind), X(mesh.X), cells(mesh.cells), nodes(mesh.X), neighbours(mesh.X.size()) {
    double largest = 0.0;
    for (const Vec2& x : X) largest = std::max(largest, x.cwiseAbs().maxCoeff());
    on_a_node = of_its_size * largest;
    for (int cell = 0; cell < static_cast<int>(cells.size()); ++cell) add(cell);
    if (triangles.empty()) throw base::MeshError("a mesh whose cells have no area cannot be searched");
    tree.insert(triangles.begin(), triangles.end());
    tree.build();
    tree.accelerate_distance_queries();
  }

  int node_count() const { return mesh::nodes_per_cell(kind); }

  NodePositions nodes_of(int cell) const {
    NodePositions result = NodePositions::Zero();
    for (int a = 0; a < node_count(); ++a) result.row(a) = X[cells[cell][a]];
    return result;
  }

  void add(int cell) {
    for (int a = 0; a < node_count(); ++a) neighbours[cells[cell][a]].push_back(cell);
    const NodePositions C = nodes_of(cell);
    const auto point = [&](int a) { return SimpleKernel::Point_3(C(a, 0), C(a, 1), 0.0); };
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
    return {cell, mesh::reference_node(kind, a), mesh::NodeValues::Unit(a), 0.0};
  }

  Place in_part(const SubTriangle& part, const Vec2& q) const {
    Place place{part.cell};
    const Eigen::Vector3d w = barycentric(nodes_of(part.cell), part.nodes, q);
    for (int k = 0; k < 3; ++k) {
      place.weights[part.nodes[k]] = w[k];
      place.xi += w[k] * mesh::reference_node(kind, part.nodes[k]);
    }
    return place;
  }

  /// In a sound mesh the first try succeeds; the others are for folded cells and their surroundings.
  Place in_quad(const SubTriangle& part, const Vec2& q) const {
    const Place rough = in_part(part, q);
    if (const auto xi = inverse<4>(kind, nodes_of(part.cell), q, rough.xi)) return at(part.cell, *xi);
    if (const auto xi = inverse_from_anywhere<4>(kind, nodes_of(part.cell), q)) return at(part.cell, *xi);
    for (int a = 0; a < 4; ++a)
      for (int cell : neighbours[cells[part.cell][a]])
        if (const auto xi = inverse_from_anywhere<4>(kind, nodes_of(cell), q)) return at(cell, *xi);
    return rough;
  }

  /// Second order: curves run beside the triangles, so p itself is looked for, in the cell and its neighbours; outside
  /// of them all, the nearest point of their edges.
  Place in_curved(const SubTriangle& part, const Vec2& p, const Vec2& q) const {
    if (const auto xi = inverse<8>(kind, nodes_of(part.cell), p, in_part(part, q).xi)) return at(part.cell, *xi);
    std::vector<int> around{part.cell};
    for (int a : part.nodes)
      for (int cell : neighbours[cells[part.cell][a]]) around.push_back(cell);
    for (int cell : around)
      if (const auto xi = inverse_from_anywhere<8>(kind, nodes_of(cell), p)) return at(cell, *xi);
    Place best;
    best.distance = std::numeric_limits<double>::infinity();
    for (int cell : around)
      for (int k = 0; k < mesh::corners(kind); ++k) {
        const NodePositions C = nodes_of(cell);
        Place place = at(cell, nearest_on_edge(kind, C, k, p));
        place.distance = (C.transpose() * place.weights - p).norm();
        if (place.distance < best.distance) best = place;
      }
    return best;
  }

  Place find(const Vec2& p) const {
    if (const auto node = nodes.nearest(p, {}, on_a_node); node.segment >= 0 && !neighbours[node.segment].empty())
      return on_node(node.segment);
    // Without a hint on purpose: one that is far off disables the pruning of the tree.
    const auto [closest, id] = tree.closest_point_and_primitive(SimpleKernel::Point_3(p.x(), p.y(), 0.0));
    const SubTriangle& part = parts[id - triangles.begin()];
    const Vec2 q(closest.x(), closest.y());
    if (mesh::order(kind) == 2) return in_curved(part, p, q);
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

}  // namespace reye::adapt
