#include "adapt/solid/plane_faces.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "adapt/solid/harmonic.hpp"
#include "adapt/solid/meeting_planes.hpp"
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
      if (!worn.contains(group) && slides(facets))
        sliding_[group] = unit_on_axis(mesh::area_vector(born.X, born.skin[facets.front()]));
    if (!sliding_.empty()) find_groups_at_nodes();
    for (const mesh::Facet& facet : born.skin)
      if (!sliding_.contains(facet.group) && !worn.contains(facet.group)) still_.insert(facet.group);
    std::erase_if(still_, [&](int group) {
      return std::ranges::any_of(born.skin,
                                 [&](const mesh::Facet& facet) { return facet.group == group && moved_inside(facet); });
    });
  }

  void slide() {
    if (sliding_.empty()) return;
    motion_.resize(mesh_.X.size());
    for (std::size_t j = 0; j < motion_.size(); ++j) motion_[j] = mesh_.X[j] - born_.X[j];
    edge_energy();
    find_straight();
    settle(energy_, 2);
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

  /// Whether a node inside the group of a facet has moved.
  bool moved_inside(const mesh::Facet& facet) const {
    return std::any_of(facet.nodes.begin(), facet.nodes.begin() + mesh::facet_corners(facet.kind), [&](int node) {
      return groups_at_.size() > static_cast<std::size_t>(node) && groups_at_[node].size() == 1 &&
             mesh_.X[node] != born_.X[node];
    });
  }

  /// 1 of a node inside a face that slides, 2 of one on a straight edge of it, which has another such face or one that
  /// stays on its other side; else 0.
  int freedom(int node) const {
    const auto& groups = groups_at_[node];
    const auto count = [&](const auto& of) {
      return std::count_if(groups.begin(), groups.end(), [&](int group) { return of.contains(group); });
    };
    if (groups.size() == 1 && count(sliding_) == 1) return 1;
    return groups.size() == 2 && count(sliding_) > 0 && count(sliding_) + count(still_) == 2 && straight_[node] ? 2 : 0;
  }

  /// Nodes at which two edges of `energy_` meet in one line.
  void find_straight() {
    std::map<int, std::set<int>> beside;
    for (const Triplet& entry : energy_)
      if (entry.row() != entry.col()) beside[entry.row()].insert(entry.col());
    straight_.assign(mesh_.X.size(), 0);
    for (const auto& [node, others] : beside) {
      if (others.size() != 2) continue;
      const Vec3 a = born_.X[*others.begin()] - born_.X[node], b = born_.X[*others.rbegin()] - born_.X[node];
      straight_[node] = a.dot(b) < 0.0 && a.cross(b).norm() <= 1e-9 * a.norm() * b.norm();
    }
  }

  void add_element(const std::vector<int>& nodes, const base::Matrix& k) {
    for (std::size_t a = 0; a < nodes.size(); ++a)
      for (std::size_t b = 0; b < nodes.size(); ++b)
        energy_.emplace_back(nodes[a], nodes[b], k(static_cast<int>(a), static_cast<int>(b)));
  }

  /// Of the edges of sliding faces beside others that slide or stay: 1/length each.
  void edge_energy() {
    energy_.clear();
    std::map<std::pair<int, int>, int> group_of;  // directed edge
    for (const mesh::Facet& facet : born_.skin)
      for (int e = 0, n = mesh::facet_corners(facet.kind);
           (sliding_.contains(facet.group) || still_.contains(facet.group)) && e < n; ++e)
        group_of[{facet.nodes[e], facet.nodes[(e + 1) % n]}] = facet.group;
    for (const auto& [edge, group] : group_of) {
      const auto other = group_of.find({edge.second, edge.first});
      if (edge.first > edge.second || other == group_of.end() || other->second == group) continue;
      if (!sliding_.contains(group) && !sliding_.contains(other->second)) continue;
      const double k = 1.0 / (born_.X[edge.first] - born_.X[edge.second]).norm();
      add_element({edge.first, edge.second}, base::Matrix{{k, -k}, {-k, k}});
    }
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
        const Eigen::Matrix<double, 3, 2> J = x.lazyProduct(dN);
        const Eigen::Matrix2d metric = J.transpose() * J;
        const double dA = weight * std::sqrt(metric.determinant());
        const Eigen::MatrixX2d raised = dN.lazyProduct(Eigen::Matrix2d(metric.inverse()));
        k += dA * raised.lazyProduct(dN.transpose());
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
    for (std::size_t node = 0; node < free.size(); ++node) {
      if (!free[node]) continue;
      for (int group : groups_at_[node])
        if (const auto plane = sliding_.find(group); plane != sliding_.end())
          motion_[node] -= plane->second.dot(motion_[node]) * plane->second;
      mesh_.X[node] = born_.X[node] + motion_[node];
    }
  }

  /// Mid nodes inside sliding faces, and of straight edges of theirs, move by the mean of the ends.
  void follow_middles() {
    struct Edge {
      int sliding = 0, still = 0;
      std::array<int, 2> ends{};
    };
    std::map<int, Edge> edges;
    for (const mesh::Facet& facet : born_.skin)
      for (int e = 0; facet.kind == mesh::FacetKind::tri6 && e < 3; ++e) {
        const auto [a, b] = mesh::edge_of(facet.kind, e);
        Edge& edge = edges[facet.nodes[3 + e]];
        edge.sliding += sliding_.contains(facet.group);
        edge.still += still_.contains(facet.group);
        edge.ends = {facet.nodes[a], facet.nodes[b]};
      }
    for (const auto& [node, edge] : edges) {
      const auto& [a, b] = edge.ends;
      const Vec3 bulge = born_.X[node] - 0.5 * (born_.X[a] + born_.X[b]);
      const bool straight = bulge.norm() <= 1e-9 * (born_.X[a] - born_.X[b]).norm();
      if (edge.sliding == 2 || (edge.sliding == 1 && edge.still == 1 && straight))
        mesh_.X[node] = born_.X[node] + 0.5 * (motion_[a] + motion_[b]);
    }
  }

  mesh::SolidMesh& mesh_;
  const mesh::SolidMesh& born_;
  double slack_;
  std::map<int, Vec3> sliding_;  ///< plane faces that follow, with their normals
  std::set<int> still_;          ///< faces that neither wear nor follow
  std::vector<char> straight_;
  Points3 motion_;
  std::vector<std::set<int>> groups_at_;
  std::vector<Triplet> energy_;
};

}  // namespace

void slide_plane_faces(mesh::SolidMesh& mesh, const mesh::SolidMesh& born, const std::set<int>& worn) {
  PlaneFaces(mesh, born, worn).slide();
}

}  // namespace reye::adapt
