#include "adapt/solid/skin_step.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "adapt/solid/meeting_planes.hpp"

namespace reye::adapt {

namespace {

/// A smooth part of the skin at a node: facets of one group, or of several that are tangent there.
struct SmoothPart {
  std::vector<int> groups;
  Vec3 area = Vec3::Zero();       ///< sum of its facets' `area_shares`
  Vec3 worn_area = Vec3::Zero();  ///< and of the worn ones
  double volume = 0.0;            ///< that it loses

  bool holds(int group) const { return std::find(groups.begin(), groups.end(), group) != groups.end(); }
  /// The worn facets decide where it goes, all that it moves count for how far.
  RecedingPlane plane() const {
    if (volume == 0.0) return {area.normalized(), 0.0};
    const Vec3 normal = worn_area.normalized();
    return {normal, volume / normal.dot(area)};
  }
};

void join_smooth(std::vector<SmoothPart>& parts) {
  for (std::size_t a = 0; a < parts.size(); ++a)
    for (std::size_t b = a + 1; b < parts.size();) {
      if (!(parts[a].area.normalized().dot(parts[b].area.normalized()) > std::cos(smooth_joint_angle))) {
        ++b;
        continue;
      }
      parts[a].groups.insert(parts[a].groups.end(), parts[b].groups.begin(), parts[b].groups.end());
      parts[a].area += parts[b].area;
      parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(b));
      b = a + 1;
    }
}

class Stepper {
 public:
  Stepper(const mesh::SolidMesh& mesh, const Points3& X, const FacetsAtNodes& facets_at, const WornSkin& worn)
      : mesh_(mesh), X_(X), facets_at_(facets_at), worn_(worn) {
    for (int f : worn.touched) shares_[f] = area_shares(mesh.skin[f].kind, points_of(X, mesh.skin[f]));
  }

  Points3 steps(double share) {
    Points3 step(X_.size(), Vec3::Zero());
    for (const WornSkinNode& node : worn_.nodes)
      if (!node.middle) {
        const auto parts = parts_of(node.node, &node, share);
        step[node.node] = where_planes_meet(planes_of(parts));
        remember(node.node, parts);
      }
    for (const MovingMiddle& middle : worn_.middles) step[middle.node] = middle_step(middle, step, share);
    return step;
  }

 private:
  Vec3 share_of(int f, int node) const {
    const auto& nodes = mesh_.skin[f].nodes;
    return shares_.at(f).col(std::find(nodes.begin(), nodes.end(), node) - nodes.begin());
  }

  std::vector<SmoothPart> parts_of(int node, const WornSkinNode* worn, double share) const {
    std::vector<SmoothPart> parts;
    for (int f : facets_at_[node]) {
      const int group = mesh_.skin[f].group;
      auto part = std::find_if(parts.begin(), parts.end(), [&](const SmoothPart& p) { return p.holds(group); });
      if (part == parts.end()) part = parts.insert(part, SmoothPart{{group}});
      part->area += share_of(f, node);
    }
    join_smooth(parts);
    for (const FaceLoss& loss : worn ? worn->losses : std::vector<FaceLoss>{}) spread(node, loss, share, parts);
    return parts;
  }

  /// What a node loses on a face is shared by the smooth parts on which the face lies, in proportion to their areas.
  void spread(int node, const FaceLoss& loss, double share, std::vector<SmoothPart>& parts) const {
    double sum = 0.0;
    for (int f : loss.facets) sum += share_of(f, node).norm();
    for (int f : loss.facets) {
      const Vec3 area = share_of(f, node);
      auto& part =
          *std::find_if(parts.begin(), parts.end(), [&](const SmoothPart& p) { return p.holds(mesh_.skin[f].group); });
      part.worn_area += area;
      part.volume += share * loss.volume * area.norm() / sum;
    }
  }

  static std::vector<RecedingPlane> planes_of(const std::vector<SmoothPart>& parts) {
    std::vector<RecedingPlane> planes;
    for (const SmoothPart& part : parts) planes.push_back(part.plane());
    return planes;
  }

  void remember(int node, const std::vector<SmoothPart>& parts) {
    for (const SmoothPart& part : parts)
      for (int group : part.groups) depths_[{node, group}] = part.plane().depth;
  }

  double depth(int node, int group) const {
    const auto found = depths_.find({node, group});
    return found == depths_.end() ? 0.0 : found->second;
  }

  Vec3 middle_step(const MovingMiddle& middle, const Points3& step, double share) const {
    const auto& [i, j] = middle.ends;
    std::vector<RecedingPlane> planes;
    for (const SmoothPart& part : parts_of(middle.node, middle.worn < 0 ? nullptr : &worn_.nodes[middle.worn], share)) {
      Vec3 normal = Vec3::Zero();
      double ends = 0.0;
      int count = 0;
      for (int f : middle.facets)
        if (part.holds(mesh_.skin[f].group)) {
          normal += share_of(f, middle.node).normalized();
          ends += depth(i, mesh_.skin[f].group) + depth(j, mesh_.skin[f].group);
          ++count;
        }
      planes.push_back({normal.normalized(), 0.25 * ends / count + 0.5 * part.plane().depth});
    }
    return where_planes_meet(planes, 0.5 * (step[i] + step[j]));
  }

  const mesh::SolidMesh& mesh_;
  const Points3& X_;
  const FacetsAtNodes& facets_at_;
  const WornSkin& worn_;
  std::map<int, FacetPoints> shares_;             ///< of touched facets
  std::map<std::pair<int, int>, double> depths_;  ///< of corners that move, by node and group
};

}  // namespace

Points3 skin_steps(const mesh::SolidMesh& mesh, const Points3& X, const FacetsAtNodes& facets_at, const WornSkin& worn,
                   double share) {
  return Stepper(mesh, X, facets_at, worn).steps(share);
}

}  // namespace reye::adapt
