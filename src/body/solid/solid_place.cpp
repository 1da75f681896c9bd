#include "body/solid/solid_place.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "algebra/decompose.hpp"
#include "algebra/product.hpp"
#include "body/columns.hpp"
#include "mesh/solid/facet_control_points.hpp"
#include "mesh/solid/solid_measure.hpp"

namespace reye::body {

const Motion& motion_of(const SolidSupport& support, int m) {
  return m < 3 ? support.along[m] : m < normal_motion ? support.about[m - 3] : support.normal;
}

SolidPlace place_support(const mesh::SolidMesh& mesh, const SolidSupport& support) {
  SolidPlace place;
  place.facets = support.face.empty() ? mesh.skin : mesh::facets_of(mesh, support.face);
  place.nodes = mesh::nodes_of(place.facets);
  place.centre = support.centre_mm ? *support.centre_mm : mesh::area_centroid(mesh.X, place.facets);
  return place;
}

std::vector<mesh::Facet> contact_facets(const SolidInput& input) {
  std::vector<mesh::Facet> facets;
  for (const auto& face : input.contact_faces)
    for (const auto& facet : mesh::facets_of(*input.mesh, face)) facets.push_back(facet);
  return facets;
}

Points3 contact_points(const SolidInput& input) { return mesh::control_points(contact_facets(input), input.mesh->X); }

std::map<int, NodeDemands> node_demands(const SolidInput& input, const std::vector<SolidPlace>& places) {
  const auto imposed = [](const Motion& m) { return m.drive == Drive::fixed || m.drive == Drive::moved; };
  std::map<int, NodeDemands> nodes;
  for (int s = 0; s < static_cast<int>(places.size()); ++s) {
    const SolidSupport& support = input.supports[s];
    for (int node : places[s].nodes) {
      NodeDemands& demands = nodes[node];
      if (support.rigid) demands.rigid.push_back(s);
      for (int m = 0; m < 3 && !support.rigid; ++m)
        if (imposed(support.along[m])) demands.by_node.push_back({s, m, support.axes.col(m)});
    }
    if (support.rigid || !imposed(support.normal)) continue;
    for (const auto& [node, group, normal] : mesh::node_normals(input.mesh->X, places[s].facets))
      nodes[node].by_node.push_back({s, normal_motion, normal});
  }
  return nodes;
}

std::vector<int> independent(const std::vector<SolidDemand>& demands) {
  std::vector<int> chosen;
  std::vector<Vec3> basis;
  for (int k = 0; k < static_cast<int>(demands.size()) && basis.size() < 3; ++k) {
    Vec3 rest = demands[k].direction;
    for (const Vec3& b : basis) rest -= b.dot(rest) * b;
    if (rest.norm() < parallel * demands[k].direction.norm()) continue;
    chosen.push_back(k);
    basis.push_back(rest.normalized());
  }
  return chosen;
}

Matrix dual_directions(const Matrix& d) {
  return d.cols() == 0 ? d
                       : Matrix(algebra::solve_symmetric(algebra::transposed_product(d, d), d.transpose()).transpose());
}

Matrix orthogonal_directions(const Matrix& d) {
  const Matrix projector = Matrix::Identity(3, 3) - algebra::product_transposed(dual_directions(d), d);
  std::vector<Vec3> basis;
  std::array<int, 3> axes{0, 1, 2};  // those that stick out most come first; equal ones in their order
  std::stable_sort(axes.begin(), axes.end(), [&](int i, int j) { return projector(i, i) > projector(j, j) + 1e-12; });
  for (int axis : axes) {
    Vec3 rest = projector.col(axis);
    for (const Vec3& b : basis) rest -= b.dot(rest) * b;
    if (static_cast<Eigen::Index>(basis.size()) < 3 - d.cols() && rest.norm() > 0.1) basis.push_back(rest.normalized());
  }
  Matrix result(3, static_cast<Eigen::Index>(basis.size()));
  for (size_t k = 0; k < basis.size(); ++k) result.col(static_cast<Eigen::Index>(k)) = basis[k];
  return result;
}

std::vector<base::Issue> place_issues(const SolidInput& input) {
  std::vector<base::Issue> issues;
  const auto look_up = [&](const std::string& key, const std::string& face, bool may_be_empty) {
    if (face.empty() && may_be_empty) return;
    if (!input.mesh->faces.contains(face)) issues.push_back({key, face, "names no face of body \"" + input.name + '"'});
  };
  for (const auto& support : input.supports) look_up("support." + support.name + ".face", support.face, input.rigid);
  for (const auto& load : input.loads) {
    const bool on_body = load.force_N_per_mm3.norm() > 0.0;
    look_up("load." + load.name + ".face", load.face, on_body);
    if (on_body && !load.face.empty())
      issues.push_back({"load." + load.name + ".face", load.face, "a force per volume acts on a body, not on a face"});
  }
  for (const auto& face : input.contact_faces) look_up("contact face", face, false);
  return issues;
}

}  // namespace reye::body
