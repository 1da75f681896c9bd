#pragma once
#include <Eigen/Geometry>
#include <functional>

#include "adapt/solid/solid_step.hpp"
#include "support/solid_blocks.hpp"

/// Losses of faces for the tests of the shape step of solids.
namespace reye::support {

using DepthAt = std::function<double(const Vec3&)>;

/// int N_j dA over the facets of a face, in the order of its nodes, by a rule of this file alone: 6 x 6 points of
/// Gauss, folded onto triangles. On tri6 N_j are Bernstein functions.
inline std::vector<double> nodal_areas(const mesh::SolidMesh& m, const std::string& face) {
  constexpr double g[6][2]{{-0.932469514203152, 0.171324492379170}, {-0.661209386466265, 0.360761573048139},
                           {-0.238619186083197, 0.467913934572691}, {0.238619186083197, 0.467913934572691},
                           {0.661209386466265, 0.360761573048139},  {0.932469514203152, 0.171324492379170}};
  const auto facets = mesh::facets_of(m, face);
  std::vector<double> by_node(m.X.size(), 0.0), result;
  for (const auto& facet : facets)
    for (const auto& [x, wx] : g)
      for (const auto& [y, wy] : g) {
        const bool square = facet.kind == mesh::FacetKind::quad4;
        const double r = square ? x : 0.5 * (1 + x), s = square ? y : (1 - r) * 0.5 * (1 + y), q = 1 - r - s;
        const double weight = wx * wy * (square ? 1.0 : 0.25 * (1 - r)) * mesh::normal_at(m.X, facet, {r, s}).norm();
        const double N[3][6]{
            {q, r, s},
            {(1 - r) * (1 - s) / 4, (1 + r) * (1 - s) / 4, (1 + r) * (1 + s) / 4, (1 - r) * (1 + s) / 4},
            {q * q, r * r, s * s, 2 * q * r, 2 * r * s, 2 * s * q}};
        for (int a = 0; a < facet.count(); ++a) by_node[facet.nodes[a]] += weight * N[static_cast<int>(facet.kind)][a];
      }
  for (int node : mesh::nodes_of(facets)) result.push_back(by_node[node]);
  return result;
}

/// The loss of a face worn by depth(x) at each node.
inline adapt::WornFace worn_by(const mesh::SolidMesh& m, const std::string& face, const DepthAt& depth) {
  adapt::WornFace worn{face, nodal_areas(m, face)};
  const auto nodes = mesh::nodes_of(mesh::facets_of(m, face));
  for (std::size_t k = 0; k < nodes.size(); ++k) worn.removed[k] *= depth(m.X[nodes[k]]);
  return worn;
}

inline double sum(const std::vector<adapt::WornFace>& worn) {
  double total = 0.0;
  for (const auto& face : worn)
    for (double v : face.removed) total += v;
  return total;
}

/// Volume within the skin, in long double, so that the difference of two bodies still has the digits of a strip.
inline long double content(const mesh::SolidMesh& m) {
  using Point = Eigen::Matrix<long double, 3, 1>;
  long double total = 0.0L;
  for (const auto& facet : m.skin)
    for (const auto& [xi, weight] : mesh::area_rule(facet.kind)) {
      const auto N = mesh::shape_functions(facet.kind, xi);
      const auto dN = mesh::shape_gradients(facet.kind, xi);
      Point x = Point::Zero(), r = x, s = x;
      for (int a = 0; a < facet.count(); ++a) {
        const Point p = m.X[facet.nodes[a]].cast<long double>();
        x += N[a] * p, r += dN(a, 0) * p, s += dN(a, 1) * p;
      }
      total += weight * x.dot(r.cross(s)) / 3.0L;
    }
  return total;
}

inline double lost(const mesh::SolidMesh& before, const mesh::SolidMesh& after) {
  return static_cast<double>(content(before) - content(after));
}

/// A ball of radius r about the origin from a cube of n^3 hexahedra or their tetrahedra, mid nodes on the sphere; all
/// of its skin is the face "ball".
inline mesh::SolidMesh ball(mesh::SolidKind kind, int n, double r) {
  mesh::SolidMesh m = block(kind, {n, n, n}, Vec3(2, 2, 2), [&](const Vec3& X) {
    const Vec3 p = X - Vec3::Ones();
    const double largest = p.cwiseAbs().maxCoeff();
    return largest > 0.0 ? Vec3(r * largest * p.normalized()) : Vec3(p);
  });
  m.faces.clear();
  for (auto& facet : m.skin) facet.group = 0;
  for (int f = 0; f < static_cast<int>(m.skin.size()); ++f) m.faces["ball"].push_back(f);
  return m;
}

/// The skin of a mesh alone, its nodes numbered again.
inline mesh::SolidMesh skin_alone(mesh::SolidMesh m) {
  const auto nodes = mesh::nodes_of(m.skin);
  std::vector<int> number(m.X.size(), -1);
  base::Points3 X;
  for (int node : nodes) {
    number[node] = static_cast<int>(X.size());
    X.push_back(m.X[node]);
  }
  for (auto& facet : m.skin)
    for (int a = 0; a < facet.count(); ++a) facet.nodes[a] = number[facet.nodes[a]];
  m.X = X;
  m.cells.clear();
  return m;
}

using SolidPtr = std::shared_ptr<const mesh::SolidMesh>;
inline SolidPtr shared(mesh::SolidMesh m) { return std::make_shared<const mesh::SolidMesh>(std::move(m)); }

}  // namespace reye::support
