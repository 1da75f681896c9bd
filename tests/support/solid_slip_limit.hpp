#pragma once
#include "support/solid_mindlin.hpp"

/// Two equal balls with nu = 0 under a constant load and a tangential force that swings between +-q mu P, one of which
/// wears until nothing slips any more: Ciavarella and Hills' limit, of balls. Inside the stick radius nothing wears;
/// there the balls press as a round that is cut off, outside they just meet.
namespace reye::support {

/// The limit for a stick radius c; exact: c = a (1 - q)^(1/3).
struct SlipLimit {
  double c, force, plane_modulus, R;  ///< mm, N, E* [MPa], of the relative curvature [mm]

  /// Approach of the balls, w = 0 at r = c.
  double approach() const { return force / (2.0 * plane_modulus * c) + c * c / (3.0 * R); }
  /// Pressure at r < c, where all of the load is carried.
  double pressure(double r) const {
    const double edge = std::sqrt(c * c - r * r);
    return plane_modulus / std::numbers::pi * (2.0 * edge / R + (approach() - c * c / R) / edge);
  }
  /// Worn depth at r >= c, before it is cut off at zero.
  double form(double r) const {
    const double d = approach();
    return d - r * r / (2.0 * R) -
           2.0 / std::numbers::pi *
               ((d - r * r / (2.0 * R)) * std::asin(c / r) + c / (2.0 * R) * std::sqrt(r * r - c * c));
  }
  /// Largest depth and volume, r over so many intervals up to 2.5 c.
  std::array<double, 2> depth_and_volume() const {
    constexpr int intervals = 4000;
    double depth = 0.0, volume = 0.0;
    for (int k = 0; k < intervals; ++k) {
      const double step = 1.5 * c / intervals, r = c + (k + 0.5) * step, w = std::max(0.0, form(r));
      depth = std::max(depth, w);
      volume += 2.0 * std::numbers::pi * r * w * step;
    }
    return {depth, volume};
  }
};

/// At the edge of stick pressure and shear are singular, in the ratio mu where nothing slips any more: a small error in
/// that ratio lets the edge slip and recede. Two causes were found (results/solid_slip_limit). Cubes of eight nodes are
/// stiffer in shear than in pressure where tractions change from node to node (compliances 0.7 to 0.9 of those of
/// pressure at wavelengths of two to four elements); a first layer of a quarter of their width leaves 0.96 to 0.99. And
/// the normals of a run at small strain are those of X, at r / (2 R) to those of the half-spaces of the closed form:
/// that adds p r / (2 R) to the shear of one side, 1.2 % of mu p at R = 50 a, mu = 0.5, and takes it from the other.
struct SlipLimitCase {
  double q = 0.5;
  double elements = 8.0;    ///< per radius of the first contact
  double fine = 1.5;        ///< even elements so far over that radius; the scar ends at 1.14 for q = 0.5, 1.31 for 0.75
  double layer = 1.0;       ///< thickness of the first elements over their width
  double R_mm = 25.0;       ///< of the relative curvature; a = 0.5 mm
  double way = 10.0;        ///< cycles, over those in which the first one's wear is that of the limit
  double tolerance = 0.02;  ///< of the blocks
  double jump = 0.0;        ///< cycles of each block; 0: chosen by the tolerance
  int increments = 8;       ///< of a cycle
  /// Whether wear enters the equations of its own increment. On fine elements it may not: a point whose slip wears away
  /// its own pressure faster than it relieves its shear sticks and slips in turn. The limit does not know of the way.
  bool implicit_wear = true;

  HertzCase hertz() const {
    HertzCase c;
    c.nu = 0.0;
    c.mu = 0.5;
    c.half = c.two_balls = true;
    c.R_mm = R_mm;
    c.elements = elements;
    c.fine = fine;
    c.fine_depth = layer < 1.0 ? 0.03 : 0.3;
    c.growth = 1.6;
    c.layer = layer;
    c.deep_growth = layer < 1.0 ? 1.4 : 0.0;
    return c;
  }
  SlipLimit limit(double c) const { return {c, hertz().force(), hertz().plane_modulus(), hertz().R_mm}; }
  Mindlin mindlin() const { return mindlin_of(q, hertz()); }

  sim::SolidProblem problem() const {
    const auto c = hertz();
    auto all = swinging_balls(q, c);
    auto& law = all.contacts[0].options.wear;
    law.kind = wear::LawKind::energy;
    all.contacts[0].options.implicit_wear = implicit_wear;
    constexpr double cycles_to_limit = 20.0;
    law.secondary = limit(mindlin().stick_radius()).depth_and_volume()[1] / (cycles_to_limit * mindlin().loop());
    all.scene.geometry.fine_zones[0].radius_mm = (fine + 0.05) * c.a_mm;
    all.scene.steps = {step_of(1, {"press"}), step_of(2, {"slide"}),
                       step_of(increments, {"swing"}, std::round(way * cycles_to_limit))};
    auto& rub = all.scene.steps.back();
    rub.wear = true;
    rub.jump_tolerance = jump > 0.0 ? 0.0 : tolerance;
    if (jump > 0.0) rub.jump = jump;
    all.scene.shape = false;  // a depth of some thousandths of an element
    all.scene.frames.paraview = false;
    return all;
  }
};

/// What a run gives beside the limit.
struct SlipLimitRun {
  PlayedSolids played;
  double stick_radius = 0.0, depth = 0.0, volume = 0.0;  ///< at the end, of the whole ball [mm; mm; mm^3]
  double punch_radius = 0.0;                             ///< of the limit whose middle presses as this one's does [mm]
};

/// The c of the limit whose pressure at the nodes within half of the exact c is that of the run in the mean. The area
/// that sticks gives c to a part of an element, and that is not enough: at q = 0.5 depth and volume grow by 8 and 13
/// times what c / a loses. The pressure of the middle grows by 0.75 times that, whatever the elements at the edge do.
inline double punch_radius(const SlipLimitCase& c, const sim::SkinRecord& worn) {
  const double within = 0.5 * c.mindlin().stick_radius();
  const auto excess = [&](double radius) {
    double sum = 0.0;
    for (std::size_t j = 0; j < worn.x_mm.size(); ++j)
      if (const double r = worn.x_mm[j].head<2>().norm(); r < within)
        sum += c.limit(radius).pressure(r) - worn.pressure_MPa[j];
    return sum;
  };
  double low = 1.2 * within, high = c.hertz().a_mm;  // the smaller the radius, the higher the pressure of its middle
  for (int k = 0; k < 50; ++k) {
    const double middle = 0.5 * (low + high);
    (excess(middle) > 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

inline SlipLimitRun play_slip_limit(const SlipLimitCase& c) {
  SlipLimitRun run{play(c.problem())};
  if (run.played.summary.status != sim::RunStatus::done) return run;
  const double share = c.hertz().share();
  const auto& worn = run.played.summary.contacts[0].secondary;
  run.stick_radius = std::sqrt(run.played.rows.back().contacts[0].stick_area_mm2 / share / std::numbers::pi);
  run.depth = worn.max_depth_mm;
  run.volume = worn.worn_volume_mm3 / share;
  run.punch_radius = punch_radius(c, run.played.frames.back().surfaces[0]);
  return run;
}

}  // namespace reye::support
