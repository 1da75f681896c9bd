#include "body/solid/solid_pivot.hpp"

#include <algorithm>
#include <cmath>

#include "body/imposed.hpp"
#include "body/solid/rigid_modes.hpp"
#include "mesh/solid/solid_measure.hpp"

namespace reye::body {

namespace {

/// Supports of one body by what they do to its motion as a whole.
struct Guides {
  std::vector<int> rigid;         ///< rigid ones that name a motion
  std::vector<int> planes;        ///< by node, held still along one direction
  Vec3 direction = Vec3::Zero();  ///< of all planes
  int oblique = -1;               ///< one by node that holds otherwise
};

bool moves_rigidly(const SolidSupport& support) {
  for (int m = 0; m < normal_motion; ++m)
    if (motion_of(support, m).drive != Drive::free) return true;
  return false;
}

/// Whether two directions are the same line to round-off of a drawing.
bool same_line(const Vec3& a, const Vec3& b) { return a.cross(b).norm() < 1e-6 * a.norm() * b.norm(); }

Guides guides_of(const SolidInput& input) {
  Guides guides;
  std::vector<SolidPlace> places;
  for (const auto& support : input.supports) places.push_back(place_support(*input.mesh, support));
  std::vector<char> by_node(places.size(), 0), oblique(places.size(), 0);
  for (const auto& [node, demands] : node_demands(input, places))
    for (const auto& [s, m, d] : demands.by_node) {
      by_node[s] = 1;
      if (guides.direction.isZero(0.0)) guides.direction = d;
      if (!same_line(d, guides.direction) || !keeps_still(motion_of(input.supports[s], m))) oblique[s] = 1;
    }
  for (int s = 0; s < static_cast<int>(places.size()); ++s) {
    if (input.supports[s].rigid && moves_rigidly(input.supports[s])) guides.rigid.push_back(s);
    if (by_node[s]) guides.planes.push_back(s);
    if (oblique[s]) guides.oblique = s;
  }
  return guides;
}

Vec3 free_centre(const SolidInput& input) {
  return input.centre_mm ? *input.centre_mm : mesh::box_centre(input.mesh->X);
}

SolidPivot pivot_of_support(const SolidInput& input, int s) {
  const SolidSupport& support = input.supports[s];
  SolidPivot pivot{s, place_support(*input.mesh, support).centre, support.axes, {}};
  for (int m = 0; m < normal_motion; ++m) pivot.motions[m] = motion_of(support, m);
  return pivot;
}

bool rotates(const SolidPivot& pivot) {
  return !std::all_of(pivot.motions.begin() + 3, pivot.motions.end(), keeps_still);
}

/// The rotation about a plane's normal, and motion along the plane.
SolidPivot pivot_of_planes(const SolidInput& input, const Vec3& normal) {
  SolidPivot pivot;
  pivot.centre = free_centre(input);
  pivot.axes << normal.unitOrthogonal(), normal.cross(normal.unitOrthogonal()), normal;
  for (int m : {2, 3, 4}) pivot.motions[m].drive = Drive::fixed;
  return pivot;
}

/// The rigid support whose rotation is driven, else the first.
int leading(const SolidInput& input, const std::vector<int>& rigid) {
  for (const int s : rigid)
    for (const auto& motion : input.supports[s].about)
      if (drives(motion) && nonzero(motion)) return s;
  return rigid.front();
}

/// The only axis about which a pivot rotates, or -1.
int sole_axis(const SolidPivot& pivot) {
  int axis = -1;
  for (int k = 0; k < 3; ++k)
    if (!keeps_still(pivot.motions[3 + k])) axis = axis < 0 ? k : 3;
  return axis < 3 ? axis : -1;
}

/// Whether a support holds the same whichever way the body is turned about the pivot's axis, as a second bearing of a
/// shaft does: its centre on the axis, along and about which it leaves the body free, and across which it holds all
/// directions alike.
bool is_bearing(const SolidInput& input, const SolidPivot& pivot, int s) {
  const int k = sole_axis(pivot);
  if (k < 0 || !keeps_still(pivot.motions[(k + 1) % 3]) || !keeps_still(pivot.motions[(k + 2) % 3])) return false;
  const SolidSupport& support = input.supports[s];
  const Vec3 axis = pivot.axes.col(k), off = place_support(*input.mesh, support).centre - pivot.centre;
  if (off.cross(axis).norm() > 1e-6 * mesh::box_diagonal(input.mesh->X)) return false;
  for (int j = 0; j < 3; ++j) {
    if (!same_line(support.axes.col(j), axis)) continue;
    const auto free = [](const Motion& motion) { return motion.drive == Drive::free; };
    const auto alike = [&](const std::array<Motion, 3>& motions) {
      const Motion &one = motions[(j + 1) % 3], &other = motions[(j + 2) % 3];
      return (free(one) && free(other)) || (keeps_still(one) && keeps_still(other));
    };
    const bool along = free(support.along[j]) || (keeps_still(support.along[j]) && keeps_still(pivot.motions[k]));
    return along && free(support.about[j]) && alike(support.along) && alike(support.about);
  }
  return false;
}

/// Whether a plane stays where it is while the pivot moves.
bool keeps_plane(const SolidPivot& pivot, const Vec3& normal) {
  for (int k = 0; k < 3; ++k) {
    const bool along = same_line(pivot.axes.col(k), normal);
    if (!keeps_still(pivot.motions[3 + k]) && !along) return false;
    if (!keeps_still(pivot.motions[k]) && std::abs(pivot.axes.col(k).dot(normal)) > 1e-6) return false;
  }
  return true;
}

/// Whether a rotation is driven, loaded or left free by all supports at small angles.
bool may_turn(const SolidInput& input) {
  std::vector<SolidPlace> places;
  for (const auto& support : input.supports) places.push_back(place_support(*input.mesh, support));
  for (const auto& support : input.supports)
    for (const auto& motion : support.about)
      if (support.rigid && nonzero(motion) && drives(motion)) return true;
  const Modes modes =
      free_modes(held_rows(input, places, free_centre(input), false), mesh::box_diagonal(input.mesh->X));
  return modes.bottomRows<3>().norm() > 1e-9;
}

struct Examined {
  std::optional<SolidPivot> pivot;
  int obstacle = -1;
};

Examined examine_solid(const SolidInput& input) {
  const Guides guides = guides_of(input);
  const bool plane = !guides.planes.empty();
  if (guides.rigid.empty() && !plane && input.contact_faces.empty()) return {};
  SolidPivot pivot;
  pivot.centre = free_centre(input);
  if (!guides.rigid.empty()) pivot = pivot_of_support(input, leading(input, guides.rigid));
  if (guides.rigid.empty() && plane) pivot = pivot_of_planes(input, guides.direction);
  int obstacle = guides.oblique;
  for (const int s : guides.rigid)
    if (obstacle < 0 && s != pivot.support && !is_bearing(input, pivot, s)) obstacle = s;
  if (obstacle < 0 && plane && !keeps_plane(pivot, guides.direction)) obstacle = guides.planes.front();
  if (obstacle < 0) return {rotates(pivot) ? std::optional(pivot) : std::nullopt, -1};
  return {{}, may_turn(input) ? obstacle : -1};
}

}  // namespace

std::optional<SolidPivot> solid_pivot(const SolidInput& input) { return examine_solid(input).pivot; }

std::string solid_keeps_direction(const SolidInput& input) {
  const int obstacle = examine_solid(input).obstacle;
  return obstacle < 0 ? std::string() : input.supports[obstacle].name;
}

}  // namespace reye::body
