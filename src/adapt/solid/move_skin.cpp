#include "adapt/solid/move_skin.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "adapt/shape/exact_factor.hpp"
#include "base/formatted.hpp"

namespace reye::adapt {

namespace {

constexpr double most_advance = 0.2, most_correction = 1e-2;
constexpr int most_parts = 1024;

/// Where along its chord a mid node may be.
constexpr double nearest_middle = 0.4, farthest_middle = 0.6;

struct SkinMotion {
  const mesh::SolidMesh& mesh;
  const FacetsAtNodes& facets_at;
  const WornSkin& worn;
  std::vector<mesh::Facet> facets;  ///< the touched ones
};

/// Keeps mid nodes away from the ends of their edges.
void centre_middles(const SkinMotion& m, const Points3& X, Points3& step) {
  for (const MovingMiddle& middle : m.worn.middles) {
    const auto& [i, j] = middle.ends;
    const Vec3 first = X[i] + step[i], chord = X[j] + step[j] - first;
    const double s = (X[middle.node] + step[middle.node] - first).dot(chord) / chord.squaredNorm();
    step[middle.node] += (std::clamp(s, nearest_middle, farthest_middle) - s) * chord;
  }
}

/// The node that goes farthest, against the smallest height of its facets.
struct Advance {
  int node = -1;
  double ratio = most_advance;
};

/// -1 where every node keeps within the limit.
Advance too_long_step(const SkinMotion& m, const Points3& X, const Points3& step) {
  Advance worst;
  for (const mesh::Facet& facet : m.facets) {
    const double height = smallest_height(facet.kind, points_of(X, facet));
    for (int a = 0; a < facet.count(); ++a) {
      const double ratio = step[facet.nodes[a]].norm() / height;
      if (!(ratio <= worst.ratio)) worst = {facet.nodes[a], ratio};
    }
  }
  return worst;
}

std::string cannot_follow(const Vec3& at, double ratio) {
  const std::string place =
      base::formatted("the surface cannot follow the wear at (%.6g, %.6g, %.6g) mm: even in %d parts of the step ",
                      at.x(), at.y(), at.z(), most_parts);
  if (!std::isfinite(ratio)) return place + "no factor near 1 gives the strip its volume";
  return place +
         base::formatted("a node advances %.3g times the height of its facet, more than %g", ratio, most_advance);
}

/// One part of the motion in place; empty failure when it kept within the limits.
void move_skin_part(const SkinMotion& m, int parts, MovedSkin& moved) {
  const double share = 1.0 / parts;
  Points3 step = skin_steps(m.mesh, moved.X, m.facets_at, m.worn, share);
  const Advance worst = too_long_step(m, moved.X, step);
  if (worst.node >= 0) {
    moved.failure = cannot_follow(moved.X[worst.node], worst.ratio);
    return;
  }
  centre_middles(m, moved.X, step);
  const double theta =
      exact_factor(share * m.worn.volume, [&](double factor) { return strip_volume(moved.X, m.facets, step, factor); });
  if (!(std::abs(theta - 1.0) <= most_correction)) {
    moved.failure = cannot_follow(moved.X[m.worn.nodes.front().node], std::numeric_limits<double>::quiet_NaN());
    return;
  }
  if (std::abs(theta - 1.0) > std::abs(moved.theta - 1.0)) moved.theta = theta;
  for (const WornSkinNode& node : m.worn.nodes)
    if (!node.middle) moved.X[node.node] += theta * step[node.node];
  for (const MovingMiddle& middle : m.worn.middles) moved.X[middle.node] += theta * step[middle.node];
}

MovedSkin move_skin_in(const SkinMotion& m, int parts) {
  MovedSkin moved{m.mesh.X, 1.0, parts, {}};
  for (int part = 0; part < parts && moved.failure.empty(); ++part) move_skin_part(m, parts, moved);
  return moved;
}

}  // namespace

MovedSkin move_skin(const mesh::SolidMesh& mesh, const FacetsAtNodes& facets_at, const WornSkin& worn) {
  SkinMotion motion{mesh, facets_at, worn, {}};
  for (int f : worn.touched) motion.facets.push_back(mesh.skin[f]);
  MovedSkin moved = move_skin_in(motion, 1);
  for (int parts = 2; !moved.failure.empty() && parts <= most_parts; parts *= 2) moved = move_skin_in(motion, parts);
  return moved;
}

}  // namespace reye::adapt
