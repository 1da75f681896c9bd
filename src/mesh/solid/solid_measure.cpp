#include "mesh/solid/solid_measure.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "base/errors.hpp"
#include "base/formatted.hpp"

namespace reye::mesh {

namespace {

/// Sum over the quadrature points of a facet of f(x, n dA).
template <class Sum, class F>
Sum over_facet(const Points3& X, const Facet& facet, Sum sum, F f) {
  const auto x = corners_of(X, facet);
  for (const auto& [xi, weight] : area_rule(facet.kind))
    sum += f(Vec3(x * shape_functions(facet.kind, xi)), Vec3(weight * normal_at(X, facet, xi)));
  return sum;
}

}  // namespace

Eigen::Matrix<double, 3, most_facet_nodes> corners_of(const Points3& X, const Facet& facet) {
  Eigen::Matrix<double, 3, most_facet_nodes> x = Eigen::Matrix<double, 3, most_facet_nodes>::Zero();
  for (int a = 0; a < facet.count(); ++a) x.col(a) = X[facet.nodes[a]];
  return x;
}

Eigen::Matrix<double, 3, most_solid_nodes> corners_of(const Points3& X, SolidKind kind, const SolidCell& cell) {
  Eigen::Matrix<double, 3, most_solid_nodes> x = Eigen::Matrix<double, 3, most_solid_nodes>::Zero();
  for (int a = 0; a < solid_nodes(kind); ++a) x.col(a) = X[cell[a]];
  return x;
}

Vec3 normal_at(const Points3& X, const Facet& facet, const Vec2& xi) {
  const Eigen::Matrix<double, 3, 2> e = corners_of(X, facet) * shape_gradients(facet.kind, xi);
  return e.col(0).cross(e.col(1));
}

Vec3 area_vector(const Points3& X, const Facet& facet) {
  return over_facet(X, facet, Vec3(Vec3::Zero()), [](const Vec3&, const Vec3& n) { return n; });
}

Vec3 facet_normal(const Points3& X, const Facet& facet) { return area_vector(X, facet).normalized(); }

double facet_area(const Points3& X, const Facet& facet) {
  return over_facet(X, facet, 0.0, [](const Vec3&, const Vec3& n) { return n.norm(); });
}

std::vector<Facet> facets_of(const SolidMesh& mesh, const std::string& face) {
  const auto found = mesh.faces.find(face);
  if (found == mesh.faces.end()) throw base::MeshError("the solid has no face " + base::quoted(face));
  std::vector<Facet> facets;
  for (int f : found->second) facets.push_back(mesh.skin[f]);
  return facets;
}

std::vector<int> nodes_of(const std::vector<Facet>& facets) {
  std::vector<int> nodes;
  for (const Facet& facet : facets) nodes.insert(nodes.end(), facet.nodes.begin(), facet.nodes.begin() + facet.count());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

double area(const Points3& X, const std::vector<Facet>& facets) {
  double sum = 0.0;
  for (const Facet& facet : facets) sum += facet_area(X, facet);
  return sum;
}

Vec3 area_centroid(const Points3& X, const std::vector<Facet>& facets) {
  Vec3 sum = Vec3::Zero();
  for (const Facet& facet : facets)
    sum = over_facet(X, facet, sum, [](const Vec3& x, const Vec3& n) { return Vec3(x * n.norm()); });
  return sum / area(X, facets);
}

// About a point of the body, so that no digits are lost where it lies far from the origin.

double volume(const SolidMesh& mesh) {
  const Vec3 c = box_centre(mesh.X);
  double sum = 0.0;
  for (const Facet& facet : mesh.skin)
    sum = over_facet(mesh.X, facet, sum, [&](const Vec3& x, const Vec3& n) { return (x - c).dot(n) / 3.0; });
  return sum;
}

Vec3 volume_centroid(const SolidMesh& mesh) {
  const Vec3 c = box_centre(mesh.X);
  Vec3 sum = Vec3::Zero();
  for (const Facet& facet : mesh.skin)
    sum = over_facet(mesh.X, facet, sum,
                     [&](const Vec3& x, const Vec3& n) { return Vec3(0.5 * (x - c).cwiseAbs2().cwiseProduct(n)); });
  return c + sum / volume(mesh);
}

std::array<double, 6> bounding_box(const Points3& X) {
  Vec3 low = X.front(), high = X.front();
  for (const Vec3& x : X) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  return {low.x(), low.y(), low.z(), high.x(), high.y(), high.z()};
}

Vec3 box_centre(const Points3& X) {
  const auto b = bounding_box(X);
  return 0.5 * Vec3(b[0] + b[3], b[1] + b[4], b[2] + b[5]);
}

double box_diagonal(const Points3& X) {
  const auto b = bounding_box(X);
  return Vec3(b[3] - b[0], b[4] - b[1], b[5] - b[2]).norm();
}

std::vector<NodeNormal> node_normals(const Points3& X, const std::vector<Facet>& facets) {
  std::map<std::pair<int, int>, Vec3> sums;
  for (const Facet& facet : facets) {
    const double size = facet_area(X, facet);
    for (int a = 0; a < facet.count(); ++a) {
      auto& sum = sums.try_emplace({facet.nodes[a], facet.group}, Vec3::Zero()).first->second;
      sum += size * normal_at(X, facet, reference_node(facet.kind, a)).normalized();
    }
  }
  std::vector<NodeNormal> normals;
  for (const auto& [key, sum] : sums) normals.push_back({key.first, key.second, sum.normalized()});
  return normals;
}

}  // namespace reye::mesh
