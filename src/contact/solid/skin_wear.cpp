#include "contact/solid/skin_wear.hpp"

#include <algorithm>

namespace reye::contact {

namespace {

using base::Vec3;
using base::Vector;

/// Entries of one row divided by its sum. None is below zero but by round-off, which would take a volume from nodes
/// that are hardly faced.
SkinRows shares(const SkinRows& T) {
  SkinRows share = T;
  for (int j = 0; j < share.outerSize(); ++j) {
    double sum = 0.0;
    for (SkinRows::InnerIterator it(share, j); it; ++it) sum += it.valueRef() = std::max(0.0, it.value());
    for (SkinRows::InnerIterator it(share, j); it; ++it) it.valueRef() /= sum;
  }
  return share;
}

Vector inverse_or_zero(const Vector& v) {
  return v.unaryExpr([](double x) { return x > 0.0 ? 1.0 / x : 0.0; });
}

/// One side of a SkinWorn, from a volume whose derivatives are those by pressure, frictional work and distance.
SkinWorn::Side side_of(const base::Dual<3>& volume, const SkinNode& node, const SkinFrame& frame, double covered) {
  const Vec3 shear = contact::shear(node, frame);
  const double length = node.slip.norm(), sign = shear.dot(node.slip) < 0.0 ? -1.0 : 1.0;
  const Vec3 along = length > 0.0 ? Vec3(node.slip / length) : Vec3(Vec3::Zero());
  SkinWorn::Side side;
  side.volume = volume.v;
  side.of_traction = volume.d[0] * frame.normal + volume.d[1] * covered * sign * frame.across(node.slip);
  side.of_motion = frame.across(volume.d[1] * covered * sign * shear + volume.d[2] * covered * along);
  return side;
}

}  // namespace

SkinWear fresh_wear(const SkinSetup& setup) {
  SkinWear wear;
  for_each_field(wear, [&](const Field& field, auto& member) {
    if constexpr (!std::is_arithmetic_v<std::remove_reference_t<decltype(member)>>)
      member.assign(field.site == Site::secondary ? setup.secondary.points.size() : setup.primary.points.size(), 0.0);
  });
  return wear;
}

SkinWorn worn_at(const wear::Law& law, const SkinNode& node, const SkinFrame& frame, double covered,
                 const wear::Start& start) {
  using Number = base::Dual<3>;
  using std::abs;
  const double work = covered * shear(node, frame).dot(node.slip);
  const wear::Sliding<Number> sliding{Number::variable(pressure(node, frame), 0), Number::variable(std::abs(work), 1),
                                      Number::variable(covered * node.slip.norm(), 2), Number(covered)};
  const auto worn = wear::worn(law, sliding, start);
  return {side_of(worn.secondary, node, frame, covered), side_of(worn.primary, node, frame, covered)};
}

SkinOpenings::SkinOpenings(const SkinSetup& setup, const SkinPlace& place) {
  const Vector inverse = inverse_or_zero(place.covered);
  per_secondary_ = inverse.asDiagonal() * place.D * inverse_or_zero(place.area).asDiagonal();
  of_primary_ = inverse.asDiagonal() * place.M * inverse_or_zero(setup.primary_area).asDiagonal();
  share_ = shares(place.T);
  per_primary_ = SkinRows(of_primary_ * SkinRows(share_.transpose()));
}

Vector SkinOpenings::by_volumes(const std::vector<double>& secondary, const std::vector<double>& primary) const {
  const auto as_vector = [](const std::vector<double>& v) {
    return Eigen::Map<const Vector>(v.data(), static_cast<Eigen::Index>(v.size()));
  };
  return per_secondary_ * as_vector(secondary) + of_primary_ * as_vector(primary);
}

void SkinOpenings::spread(int k, double volume, std::vector<double>& primary) const {
  for (SkinRows::InnerIterator it(share_, k); it; ++it)
    primary[static_cast<std::size_t>(it.col())] += volume * it.value();
}

double SkinOpenings::depth_faced(int j, const SkinWear& wear, const Vector& area) const {
  double depth = 0.0;
  for (SkinRows::InnerIterator it(share_, j); it; ++it) {
    const auto l = static_cast<std::size_t>(it.col());
    if (area[it.col()] > 0.0) depth += it.value() * (wear.moved_primary[l] + wear.pending_primary[l] / area[it.col()]);
  }
  return depth;
}

void book(const SkinSetup& setup, const SkinPlace& place, const SkinOpenings& openings,
          const std::vector<SkinNode>& nodes, const std::vector<SkinStatus>& status, const std::vector<SkinWorn>& worn,
          const SkinWearing& wearing, SkinWear& wear) {
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    if (!slides(status[j], setup.options.friction)) continue;
    const double work = wearing.jump * place.covered[j] * std::abs(shear(nodes[j], place.frame[j]).dot(nodes[j].slip));
    wear.slip[j] += wearing.jump * nodes[j].slip.norm();
    wear.frictional_work += work;
    wear.energy[j] += work;
    if (!wearing.on || !worn[j].any()) continue;
    wear.worn_work += work;
    wear.law_volume += worn[j].secondary.volume + worn[j].primary.volume;
    wear.pending_secondary[j] += worn[j].secondary.volume;
    wear.removed_secondary[j] += worn[j].secondary.volume;
    if (worn[j].primary.volume == 0.0) continue;
    openings.spread(static_cast<int>(j), worn[j].primary.volume, wear.pending_primary);
    openings.spread(static_cast<int>(j), worn[j].primary.volume, wear.removed_primary);
  }
}

}  // namespace reye::contact
