#include "contact/solid/skin_place.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "mortar/solid/facet_geometry.hpp"

namespace reye::contact {

namespace {

using base::Points3;
using base::Vec3;
using base::Vector;

mortar::Skin moved(const SkinSide& side, const Vector& u) {
  mortar::Skin skin = side.skin;
  skin.X = skin.x;  // at small strain tractions act on the areas of X
  for (std::size_t i = 0; i < side.points.size(); ++i) skin.x[i] += u.segment<3>(3 * side.points[i].column);
  return skin;
}

SkinRows rows_over_points(const SkinSetup& setup, const mortar::SkinIntegrals& integrals, int points) {
  std::vector<base::Triplet> entries;
  const auto add = [&](const base::SparseMatrix& part, const SkinSide& side, double sign) {
    for (int column = 0; column < part.outerSize(); ++column)
      for (base::SparseMatrix::InnerIterator it(part, column); it; ++it)
        entries.emplace_back(static_cast<int>(it.row()), side.points[column].column, sign * it.value());
  };
  add(integrals.D, setup.secondary, 1.0);
  add(integrals.M, setup.primary, -1.0);
  SkinRows Q(setup.count(), points);
  Q.setFromTriplets(entries.begin(), entries.end());
  return Q;
}

constexpr double parallel = 1.0 - 1e-6;  // cosine of directions that count as one

bool holds_along(const HeldDirections& held, const Vec3& e) {
  Vec3 rest = e;
  for (int k = 0; k < held.count; ++k) rest -= held.d[k].dot(e) * held.d[k];
  return rest.squaredNorm() < 1.0 - parallel;
}

/// A direction in which the secondary point is held, and one at least of the primary points that it faces: then a
/// support holds both, and the others would balance on the far side of a plane of symmetry.
bool held_on_both_sides(const SkinPlace& place, int j, int own, const Vec3& e,
                        const std::vector<HeldDirections>& held) {
  if (!holds_along(held[own], e)) return false;
  for (SkinRows::InnerIterator it(place.Q, j); it; ++it)
    if (it.value() < 0.0 && holds_along(held[static_cast<std::size_t>(it.col())], e)) return true;
  return false;
}

SkinFrame free_frame(Vec3 normal) {
  SkinFrame frame;
  frame.normal = normal;
  frame.tangent[0] = normal.unitOrthogonal();
  frame.tangent[1] = normal.cross(frame.tangent[0]);
  return frame;
}

/// The normal is put into the planes that hold both sides, and the tangents are those that remain.
SkinFrame held_frame(Vec3 normal, const std::vector<Vec3>& directions) {
  Vec3 kept = normal;
  for (const Vec3& e : directions) kept -= kept.dot(e) * e;
  SkinFrame frame;
  frame.free = 2 - static_cast<int>(directions.size());
  if (frame.free < 0 || kept.squaredNorm() < 0.25) {  // held along its normal, too: supports alone decide there
    frame = free_frame(normal);
    frame.free = 0;
    return frame;
  }
  frame.normal = kept.normalized();
  frame.tangent[0] = directions.size() == 1 ? directions[0].cross(frame.normal).normalized() : directions[0];
  frame.tangent[1] = frame.normal.cross(frame.tangent[0]);
  return frame;
}

SkinFrame frame_of(const SkinPlace& place, int j, int own, const Vec3& normal,
                   const std::vector<HeldDirections>& held) {
  std::vector<Vec3> directions;
  for (int k = 0; k < held[own].count; ++k) {
    const Vec3& e = held[own].d[k];
    if (std::abs(e.dot(normal)) < 0.5 && held_on_both_sides(place, j, own, e, held)) directions.push_back(e);
  }
  return directions.empty() ? free_frame(normal) : held_frame(normal, directions);
}

std::vector<SkinFrame> frames_of(const SkinSetup& setup, const SkinPlace& place, const Points3& normals,
                                 const std::vector<HeldDirections>& held) {
  std::vector<SkinFrame> frames;
  for (int j = 0; j < setup.count(); ++j)
    frames.push_back(place.carries[j] ? frame_of(place, j, setup.secondary.points[j].column, normals[j], held)
                                      : free_frame(normals[j]));
  return frames;
}

}  // namespace

Vec3 SkinFrame::tangential(const Vec3& v) const { return v - normal.dot(v) * normal; }

Vec3 SkinFrame::across(const Vec3& v) const {
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < free; ++k) sum += tangent[k].dot(v) * tangent[k];
  return sum;
}

SkinFrame turned_least(SkinFrame frame, const SkinFrame& before) {
  const Vec3 along = frame.tangential(before.tangent[0]);
  if (frame.free < 2 || along.squaredNorm() < 0.25) return frame;
  frame.tangent[0] = along.normalized();
  frame.tangent[1] = frame.normal.cross(frame.tangent[0]);
  return frame;
}

SkinPlace place_skins(const SkinSetup& setup, const Vector& displacement, const std::vector<HeldDirections>& held,
                      int points, mortar::SkinPairs& pairs, const std::vector<char>& fresh) {
  const auto integrals = mortar::integrate(moved(setup.secondary, displacement), moved(setup.primary, displacement),
                                           {setup.search, setup.options.dual}, pairs, fresh);
  SkinPlace place;
  place.Q = rows_over_points(setup, integrals, points);
  if (setup.options.wear.wears()) {
    place.D = integrals.D;
    place.M = integrals.M;
    place.T = integrals.T;
  }
  place.covered = integrals.covered;
  place.area = integrals.area;
  place.carries = integrals.carries;
  place.covers = integrals.covers;
  place.frame = frames_of(setup, place, integrals.normal, held);
  return place;
}

void turn_frames(const SkinSetup& setup, const Vector& displacement, const std::vector<HeldDirections>& held,
                 SkinPlace& place) {
  place.frame =
      frames_of(setup, place, mortar::nodal_normals(moved(setup.secondary, displacement), place.covers), held);
}

Points3 relative(const SkinPlace& place, const Vector& x) {
  Points3 w(place.frame.size(), Vec3::Zero());
  for (int j = 0; j < place.count(); ++j) {
    if (!place.carries[j]) continue;
    for (SkinRows::InnerIterator it(place.Q, j); it; ++it) w[j] += it.value() * x.segment<3>(3 * it.col());
    w[j] /= place.covered[j];
  }
  return w;
}

}  // namespace reye::contact
