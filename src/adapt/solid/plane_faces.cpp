#include "adapt/solid/plane_faces.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "adapt/solid/harmonic.hpp"
#include "adapt/solid/skin_strip.hpp"
#include "mesh/solid/solid_measure.hpp"

namespace reye::adapt {

namespace {

using base::Triplet;

/// Round-off of a position [mm].
double slack_of(const mesh::SolidMesh& born) {
  const auto box = mesh::bounding_box(born.X);
  double largest = 0.0;
  for (double x : box) largest = std::max(largest, std::abs(x));
  return 1e-12 * largest;
}

/// The facets of each group.
std::map<int, std::vector<int>> groups_of(const std::vector<mesh::Facet>& skin) {
  std::map<int, std::vector<int>> groups;
  for (int f = 0; f < static_cast<int>(skin.size()); ++f) groups[skin[f].group].push_back(f);
  return groups;
}

class PlaneFaces {
 public:
  PlaneFaces(mesh::SolidMesh& mesh, const mesh::SolidMesh& born, const std::set<int>& worn)
      : mesh_(mesh), born_(born), slack_(slack_of(born)) {
    for (const auto& [group, facets] : groups_of(born.skin))
      if (!worn.contains(group) && slides(facets)) sliding_.insert(group);
  }

  void slide() {
    if (sliding_.empty()) return;
    motion_.resize(mesh_.X.size());
    for (std::size_t j = 0; j < motion_.size(); ++j) motion_[j] = mesh_.X[j] - born_.X[j];
    find_groups_at_nodes();
    settle(edge_energy(), 2);
    settle(face_energy(), 1);
    follow_middles();
  }

 private:
  /// Whether facets are plane, in the plane they were born in, and have a node that has moved.
  bool slides(const std::vector<int>& facets) const {
    const mesh::Facet& first = born_.skin[facets.front()];
    const Vec3 n = mesh::facet_normal(born_.X, first), o = born_.X[first.nodes[0]];
    bool moved = false;
    for (int f : facets)
      for (int a = 0; a < born_.skin[f].count(); ++a) {
        const int node = born_.skin[f].nodes[a];
        if (std::abs(n.dot(born_.X[node] - o)) > 100.0 * slack_) return false;
        if (std::abs(n.dot(mesh_.X[node] - born_.X[node])) > slack_) return false;
        moved = moved || mesh_.X[node] != born_.X[node];
      }
    return moved;
  }

  void find_groups_at_nodes() {
    groups_at_.resize(mesh_.X.size());
    for (const mesh::Facet& facet : born_.skin)
      for (int a = 0; a < mesh::facet_corners(facet.kind); ++a) groups_at_[facet.nodes[a]].insert(facet.group);
  }

  /// Of a node whose facets all slide, the number of its groups; else 0.
  int freedom(int node) const {
    const auto& groups = groups_at_[node];
    const bool free = std::all_of(groups.begin(), groups.end(), [&](int group) { return sliding_.contains(group); });
    return free ? static_cast<int>(groups.size()) : 0;
  }

  void add_element(const std::vector<int>& nodes, const base::Matrix& k) {
    for (std::size_t a = 0; a < nodes.size(); ++a)
      for (std::size_t b = 0; b < nodes.size(); ++b)
        energy_.emplace_back(nodes[a], nodes[b], k(static_cast<int>(a), static_cast<int>(b)));
  }

  /// Of the edges between two sliding faces: 1/length each.
  const std::vector<Triplet>& edge_energy() {
    energy_.clear();
    std::map<std::pair<int, int>, int> group_of;  // directed edge
    for (const mesh::Facet& facet : born_.skin)
      for (int e = 0, n = mesh::facet_corners(facet.kind); sliding_.contains(facet.group) && e < n; ++e)
        group_of[{facet.nodes[e], facet.nodes[(e + 1) % n]}] = facet.group;
    for (const auto& [edge, group] : group_of) {
      const auto other = group_of.find({edge.second, edge.first});
      if (edge.first > edge.second || other == group_of.end() || other->second == group) continue;
      const double k = 1.0 / (born_.X[edge.first] - born_.X[edge.second]).norm();
      add_element({edge.first, edge.second}, base::Matrix{{k, -k}, {-k, k}});
    }
    return energy_;
  }

  /// Of the sliding faces: 1/area int grad N_a . grad N_b dA, by their corners.
  const std::vector<Triplet>& face_energy() {
    energy_.clear();
    for (const mesh::Facet& facet : born_.skin) {
      if (!sliding_.contains(facet.group)) continue;
      const int n = mesh::facet_corners(facet.kind);
      const auto kind = n == 4 ? mesh::FacetKind::quad4 : mesh::FacetKind::tri3;
      const Eigen::Matrix3Xd x = points_of(born_.X, facet).leftCols(n);
      base::Matrix k = base::Matrix::Zero(n, n);
      double area = 0.0;
      for (const auto& [xi, weight] : mesh::area_rule(kind)) {
        const Eigen::MatrixX2d dN = mesh::shape_gradients(kind, xi).topRows(n);
        const Eigen::Matrix<double, 3, 2> J = x * dN;
        const Eigen::Matrix2d metric = J.transpose() * J;
        const double dA = weight * std::sqrt(metric.determinant());
        k += dA * dN * metric.inverse() * dN.transpose();
        area += dA;
      }
      add_element({facet.nodes.begin(), facet.nodes.begin() + n}, k / area);
    }
    return energy_;
  }

  void settle(const std::vector<Triplet>& energy, int groups) {
    std::vector<char> free(mesh_.X.size(), 0);
    for (const Triplet& entry : energy) free[entry.row()] = freedom(entry.row()) == groups;
    HarmonicExtension(free, std::vector<double>(free.size(), 1.0), energy).extend(motion_);
    for (std::size_t node = 0; node < free.size(); ++node)
      if (free[node]) mesh_.X[node] = born_.X[node] + motion_[node];
  }

  /// Mid nodes of edges of sliding faces alone move by the mean of the ends.
  void follow_middles() {
    std::map<int, std::pair<int, std::array<int, 2>>> found;
    for (const mesh::Facet& facet : born_.skin)
      for (int e = 0; facet.kind == mesh::FacetKind::tri6 && sliding_.contains(facet.group) && e < 3; ++e) {
        const auto [a, b] = mesh::edge_of(facet.kind, e);
        auto& [count, ends] = found[facet.nodes[3 + e]];
        ++count;
        ends = {facet.nodes[a], facet.nodes[b]};
      }
    for (const auto& [node, edge] : found)
      if (edge.first == 2) mesh_.X[node] = born_.X[node] + 0.5 * (motion_[edge.second[0]] + motion_[edge.second[1]]);
  }

  mesh::SolidMesh& mesh_;
  const mesh::SolidMesh& born_;
  double slack_;
  std::set<int> sliding_;
  Points3 motion_;
  std::vector<std::set<int>> groups_at_;
  std::vector<Triplet> energy_;
};

}  // namespace

void slide_plane_faces(mesh::SolidMesh& mesh, const mesh::SolidMesh& born, const std::set<int>& worn) {
  PlaneFaces(mesh, born, worn).slide();
}

}  // namespace reye::adapt
