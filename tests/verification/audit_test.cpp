#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/measure.hpp"
#include "sim/problem/records.hpp"
#include "wear_scene.hpp"

/// An audit of finished runs: what a run reports about one thing in several places is one number.
namespace reye::verification {

namespace {

using sim::Side;

constexpr double pi = std::numbers::pi;

/// Area [mm^2] of a body of first order, or the volume [mm^3] of the ring it stands for.
double content(const mesh::Mesh& mesh, base::Analysis analysis) {
  if (analysis != base::Analysis::axisymmetric) return mesh::area(mesh);
  double volume = 0.0;
  for (const auto& loop : mesh.outline)
    for (std::size_t i = 1; i < loop.size(); ++i) {
      const auto &a = mesh.X[loop[i - 1]], &b = mesh.X[loop[i]];
      volume += pi / 3.0 * (b.y() - a.y()) * (a.x() * a.x() + a.x() * b.x() + b.x() * b.x());
    }
  return volume;
}

/// Forces of all supports on one body at the end of the run.
base::Vec2 held_by_supports(const Played& run, int body) {
  base::Vec2 force = base::Vec2::Zero();
  for (std::size_t s = 0; s < run.problem.support_body.size(); ++s)
    if (run.problem.support_body[s] == body) force += run.records.back().support_forces[s];
  return force;
}

/// The integral of the pressure that a table shows, by the trapezoidal rule along its arc length.
double pressed_force(const sim::SurfaceRecord& s, base::Analysis analysis) {
  double force = 0.0;
  const auto density = [&](std::size_t i) {
    return s.pressure_MPa[i] * (analysis == base::Analysis::axisymmetric ? 2.0 * pi * s.x_mm[i] : 1.0);
  };
  for (std::size_t i = 1; i < s.node.size(); ++i)
    force += 0.5 * (density(i - 1) + density(i)) * (s.arc_length_mm[i] - s.arc_length_mm[i - 1]);
  return force;
}

/// The booked volume of every side has left its body: the change of its content, to the digits that content has.
void expect_booked_volume_is_the_change_of_shape(const Played& run, const std::string& divided_arc) {
  const auto analysis = run.problem.scene.analysis;
  for (int b = 0; b < run.problem.body_count(); ++b) {
    if (run.problem.inputs[b].name == divided_arc) continue;
    double booked = 0.0;
    for (std::size_t c = 0; c < run.problem.contacts.size(); ++c) {
      if (run.problem.contacts[c].secondary.body == b) booked += run.summary.contacts[c].secondary.worn_area;
      if (run.problem.contacts[c].primary.front().body == b) booked += run.summary.contacts[c].primary.worn_area;
    }
    if (run.problem.rigid[b]) {
      EXPECT_EQ(booked, 0.0);
      continue;
    }
    const double before = content(run.problem.shapes[b]->mesh, analysis),
                 after = content(run.state.shapes[b]->mesh, analysis);
    EXPECT_NEAR(before - after, booked, 1e-9 * booked + 1e-13 * before) << "body " << run.problem.inputs[b].name;
  }
}

/// The resultant of a contact is what the supports of either body feel, where nothing else acts on it.
void expect_supports_feel_the_contact(const Played& run, double tolerance) {
  if (run.problem.contacts.size() != 1) return;
  const auto& contact = run.contact();
  const bool ring = run.problem.scene.analysis == base::Analysis::axisymmetric;
  const double resultant = ring ? contact.normal_force : std::hypot(contact.normal_force, contact.tangential_force);
  for (const int b : {run.problem.contacts[0].secondary.body, run.problem.contacts[0].primary.front().body}) {
    const auto& input = run.problem.inputs[b];
    if (!input.boundary_loads.empty() || !input.point_loads.empty() || !input.body_forces.empty()) continue;
    const base::Vec2 felt = held_by_supports(run, b);
    EXPECT_NEAR(ring ? std::abs(felt.y()) : felt.norm(), resultant, tolerance * resultant) << "body " << input.name;
  }
}

/// The last row of the history and the summary are of one state.
void expect_history_ends_with_the_summary(const Played& run) {
  double energy = 0.0, secondary = 0.0, primary = 0.0, peak = 0.0;
  for (const auto& c : run.summary.contacts) {
    energy += c.dissipated_energy;
    secondary = std::max(secondary, c.secondary.max_depth_mm);
    primary = std::max(primary, c.primary.max_depth_mm);
    peak = std::max(peak, c.peak_pressure_MPa.value_or(0.0));
  }
  const auto& last = run.records.back();
  EXPECT_DOUBLE_EQ(last.cycle, run.summary.cycles);
  EXPECT_NEAR(last.energy_mJ, energy, 1e-12 * energy);
  EXPECT_NEAR(last.depth_max_secondary_mm, secondary, 1e-9 * secondary);
  EXPECT_NEAR(last.depth_max_primary_mm, primary, 1e-9 * primary);
  EXPECT_NEAR(last.pressure_max_MPa, peak, 1e-9 * peak);
}

struct Bounds {
  double table = 0.01;    ///< of the integral of the pressure table against the normal force
  double support = 1e-6;  ///< of the resultant against what supports feel
  bool shape = true;      ///< wear has gone from the bodies
  std::string
      divided_arc{};  ///< body whose unworn arc a remesh divides into other chords: they change its content, too
};

void audit(const Played& run, const Bounds& bounds = {}) {
  ASSERT_FALSE(run.records.empty());
  const auto analysis = run.problem.scene.analysis;
  double from_nothing = 0.0;
  for (const auto& record : run.records) {
    EXPECT_GE(record.energy_mJ, from_nothing) << "dissipated energy never falls";
    from_nothing = record.energy_mJ;
  }
  if (run.problem.contacts.size() == 1 && analysis != base::Analysis::axisymmetric) {
    EXPECT_NEAR(pressed_force(run.surface(Side::secondary), analysis), run.contact().normal_force,
                bounds.table * run.contact().normal_force);
  }
  for (const auto& c : run.summary.contacts) EXPECT_LT(c.ledger_relative_error.value_or(0.0), 1e-9) << c.name;
  if (bounds.shape) expect_booked_volume_is_the_change_of_shape(run, bounds.divided_arc);
  expect_supports_feel_the_contact(run, bounds.support);
  expect_history_ends_with_the_summary(run);
}

}  // namespace

/// Every place in which a run reports a force, an energy, a volume or a depth reports the same one, whatever kind it is
/// of.
TEST(Audit, BlockUnderImposedSliding) { audit(played(scene_text("sliding_block"))); }

TEST(Audit, ColumnThatKeepsItsShape) { audit(played(scene_text("column")), {.shape = false}); }

TEST(Audit, GrossSlipByEnergy) {
  audit(played(
      scene_text("life_band", {{"cycles = 2000", "cycles = 200"}, {"depth_mm    = 1e-3", "depth_mm    = 1e-2"}})));
}

TEST(Audit, GrossSlipUnderATolerance) {
  audit(played(scene_text("life_band", {{"cycles = 2000\njump = 100", "cycles = 200\njump = { tolerance = 0.02 }"},
                                        {"depth_mm    = 1e-3", "depth_mm    = 1e-2"}})));
}

TEST(Audit, PartialSlip) {
  audit(
      played(scene_text("life_band", {{"motion_mm = 0.02", "motion_mm = 0.001"}, {"cycles = 2000", "cycles = 400"}})));
}

TEST(Audit, PinWornWithRemeshes) {
  audit(played(scene_text("pin_worn_flat", {{"cycles = 180\njump = 5", "cycles = 40\njump = 5"},
                                            {"cycles = 3300\njump = 25", "cycles = 0"},
                                            {"size_mm = 0.02 }", "size_mm = 0.04 }\n[remesh]\nevery_blocks = 6\n"}})),
        {.divided_arc = "pin"});
}

TEST(Audit, RingsByArchard) {
  audit(played(
      scene_text("ring_on_ring_axisymmetric", {{"cycles = 300", "cycles = 30"}, {"size_mm = 1.0", "size_mm = 2.5"}})));
}

TEST(Audit, HertzWithoutWear) { audit(played(scene_text("hertz_block", {{"size_mm = 0.035", "size_mm = 0.07"}}))); }

TEST(Audit, RubberThatWears) {
  audit(played(scene_text("rubber_pin_wear", {{"cycles = 200", "cycles = 10"}, {"size_mm = 0.08", "size_mm = 0.2"}})),
        {.table = 0.03});  // the table's lengths are those of X, the pressure is per length of x
}

TEST(Audit, PlasticFretting) {
  audit(played(scene_text("plastic_fretting", {{"cycles = 400", "cycles = 20"},
                                               {"size_mm = 0.012", "size_mm = 0.04"},
                                               {"increments = 40\nwear", "increments = 8\nwear"},
                                               {"increments = 40\ncycles", "increments = 8\ncycles"}})),
        {.divided_arc = "cylinder"});  // remeshed where contact comes near the ends of so coarse a zone
}

TEST(Audit, TwoContactsInAChain) {
  audit(played(scene_text("three_bodies", {{"cycles = 5", "cycles = 1"}, {"increments = 40", "increments = 12"}})));
}

}  // namespace reye::verification
