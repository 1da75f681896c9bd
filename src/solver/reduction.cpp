#include "solver/reduction.hpp"

#include <utility>

namespace reye::solver {

Reduction::Reduction(const System& system, const Reach& reach, bool moving) : offset_(system.offset) {
  const auto out = reach.columns_out(system, Reach::Bodies::linear);
  parts_.resize(system.bodies.size());
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const int n = body::dofs(system.bodies[b]);
    auto [near, far] = columns_.add(n, [&](int column) { return out[column]; });
    if (const auto* linear = std::get_if<body::LinearBody>(&system.bodies[b])) {
      const auto& translation = linear->translation();
      auto near_translation = translation.part(near), far_translation = translation.part(far);
      std::optional<body::Turning> turning;
      if (linear->turning()) turning = linear->turning()->part(near);
      auto inverse = moving || turning ? linear->compliance() : nullptr;
      parts_[b] = {Condensed(linear->shared_stiffness(), std::move(inverse), std::move(near), std::move(far)),
                   std::move(near_translation), std::move(far_translation), std::move(turning)};
    }
  }
}

Vector Reduction::restrict_to(const Vector& q) const { return q(columns_.column); }

Reduction::Loads Reduction::loads(const System& system, const std::vector<Vector>& load_factors) const {
  Loads loads{Vector::Zero(size()), std::vector<body::TurningLoad>(parts_.size()), {}};
  for (const auto& part : parts_) {
    const Vector none = Vector::Zero(static_cast<Eigen::Index>(part.far().size()));
    loads.own.push_back({none, none, none});
  }
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const auto* linear = std::get_if<body::LinearBody>(&system.bodies[b]);
    if (!linear) continue;
    const auto& part = parts_[b];
    if (part.turning) {
      const auto load = linear->turning_load(load_factors[b]);
      auto still = part.Condensed::load(load.still), along = part.Condensed::load(load.along),
           across = part.Condensed::load(load.across);
      loads.turning[b] = {std::move(still.near), std::move(along.near), std::move(across.near)};
      loads.own[b] = {std::move(still.own), std::move(along.own), std::move(across.own)};
    } else if (load_factors[b].size() > 0) {
      auto load = part.Condensed::load(linear->load(load_factors[b]));
      loads.forces.segment(first(static_cast<int>(b)), load.near.size()) = load.near;
      loads.own[b].still = std::move(load.own);
    }
  }
  return loads;
}

Vector Reduction::scatter(const Vector& reduced) const {
  Vector q = Vector::Zero(static_cast<Eigen::Index>(columns_.index.size()));
  for (int i = 0; i < size(); ++i) q[columns_.column[i]] = reduced[i];
  return q;
}

base::TwoPart Reduction::of_body(int body, const base::TwoPart& reduced) const {
  const auto n = parts_[body].size();
  return {reduced.high.segment(first(body), n), reduced.low.segment(first(body), n)};
}

Vector Reduction::deformation(int body, const base::TwoPart& reduced) const {
  return parts_[body].near_translation.without(parts_[body].in_frame(of_body(body, reduced)));
}

base::TwoPart Reduction::expand(const base::TwoPart& reduced, const Loads& loads) const {
  base::TwoPart q{scatter(reduced.high), scatter(reduced.low)};
  for (std::size_t b = 0; b < parts_.size(); ++b) {
    const auto& part = parts_[b];
    if (part.far().empty()) continue;
    const auto kept = of_body(static_cast<int>(b), reduced), near = part.in_frame(kept);
    const Vec2 a = part.near_translation.of(near.high);
    const Vector own = part.turning ? loads.own[b].at(part.turning->angle_of(kept.high)) : loads.own[b].still;
    const auto far = part.far_translation.with(a, part.moved(part.near_translation.without(a, near), own));
    for (std::size_t i = 0; i < part.far().size(); ++i) {
      q.high[offset_[b] + part.far()[i]] = far.high[static_cast<Eigen::Index>(i)];
      q.low[offset_[b] + part.far()[i]] = far.low[static_cast<Eigen::Index>(i)];
    }
  }
  return q;
}

}  // namespace reye::solver
