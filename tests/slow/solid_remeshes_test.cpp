#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/solid/solid_measure.hpp"
#include "stress/many_remeshes.hpp"
#include "support/solid_remeshed.hpp"

using namespace reye;

namespace {

/// Volumes of the bodies of a run, when it began and now.
struct Volumes {
  std::vector<double> first, last;

  void take(const sim::SolidRunState& state) {
    last.clear();
    for (const auto& mesh : state.meshes) last.push_back(mesh::volume(*mesh));
    if (first.empty()) first = last;
  }
};

/// A column of tetrahedra that a rigid plate eats from its top, 0.02 of an element a cycle.
sim::SolidProblem eaten_column(double cycles) {
  constexpr int parts = 2, height = 40;
  constexpr double size = 0.25, mean_MPa = 10.0, side = parts * size, length = height * size;
  auto column = support::solid("column",
                               support::block(mesh::SolidKind::tet4, {parts, parts, height}, base::Vec3::Ones(),
                                              support::box({0.0, 0.0, -length}, {side, side, 0.0})),
                               2e5, 0.0);
  for (const char* face : {"x0", "x1", "y0", "y1", "z0"})
    column.supports.push_back(support::symmetry(std::string("column_") + face, face));
  auto plate = support::solid("plate",
                              support::block(mesh::SolidKind::hex8, {1, 1, 1}, base::Vec3::Ones(),
                                             support::box({-0.3, -0.3, 1e-3}, {side + 0.3, side + 0.3, 0.2})),
                              2e5, 0.0);
  plate.rigid = true;
  plate.supports = {support::pressed_rigidly("z1", mean_MPa * side * side)};
  auto problem = support::problem_of({column, plate}, {0, "z1"}, {1, "z0"}, 0.0, 0.3);
  problem.contacts[0].options.wear = support::archard(0.021 * size / mean_MPa);
  support::slide_once(problem, {.direction = base::Vec3::UnitX(), .parts = {{1.0, ""}}}, 1);
  problem.scene.steps.back().cycles = cycles;
  problem.scene.steps.back().jump = 1.0;
  return problem;
}

}  // namespace

TEST(SolidRemeshes, FiftyOfEitherBodyLoseWhatTheLedgerHolds) {
  // Two bodies from CAD that wear, each remeshed fifty times, have lost the volume that the ledger holds, and that is
  // coefficient x pressure x way, to 1e-9; no fresh mesh changes the pressures by more than 3 % of their mean.
  auto scene = support::ball_worn_for(200.0, 1.2);
  scene.contacts.front().wear.primary = 1.0e-8;
  scene.steps.back().jump_tolerance = 0.0;
  scene.steps.back().jump = 4.0;
  scene.remesh.every_blocks = 1;
  const auto problem = sim::prepare_solid(std::move(scene));
  Volumes volumes;
  double worst = 0.0;
  int records = 0;
  sim::SolidObserver observer;
  observer.state = [&](const sim::SolidRunState& state) { volumes.take(state); };
  observer.remesh = [&](const sim::SolidRemeshRecord& r) {
    worst = std::max(worst, r.pressure_change);
    ++records;
  };
  const auto summary = sim::run_solid(problem, observer);
  ASSERT_EQ(summary.status, sim::RunStatus::done) << summary.reason;
  EXPECT_GE(summary.counts.remeshes, 100);
  EXPECT_EQ(records, summary.counts.remeshes);
  EXPECT_LE(worst, 0.03);
  const auto& contact = summary.contacts[0];
  EXPECT_LE(contact.ledger_relative_error.value(), 1e-9);
  const double ball = contact.secondary.worn_volume_mm3, plate = contact.primary.worn_volume_mm3;
  EXPECT_NEAR(plate, ball / 3.0, 1e-9 * ball);
  EXPECT_NEAR(volumes.first[0] - volumes.last[0], ball, 1e-9 * ball + 1e-12 * volumes.first[0]);
  EXPECT_NEAR(volumes.first[1] - volumes.last[1], plate, 1e-9 * plate + 1e-12 * volumes.first[1]);
}

TEST(SolidRemeshes, AThousandShapeStepsKeepMemoryFlat) {
  // A column eaten by a thousand steps to half of its length has lost what the ledger holds to 1e-9 and needs no more
  // memory than after the first fifth.
  const auto problem = eaten_column(1000.0);
  Volumes volumes;
  double early = 0.0;
  long steps = 0;
  sim::SolidObserver observer;
  observer.state = [&](const sim::SolidRunState& state) {
    const double before = volumes.last.empty() ? 0.0 : volumes.last[0];
    volumes.take(state);
    steps += before > volumes.last[0];
    if (steps == 200 && early == 0.0) early = test::resident_MB();
  };
  const auto summary = sim::run_solid(problem, observer);
  ASSERT_EQ(summary.status, sim::RunStatus::done) << summary.reason;
  EXPECT_GE(steps, 1000);
  EXPECT_GE(summary.counts.remeshes, 20);
  const auto& contact = summary.contacts[0];
  EXPECT_LE(contact.ledger_relative_error.value(), 1e-9);
  EXPECT_NEAR((volumes.first[0] - volumes.last[0]) / contact.secondary.worn_volume_mm3, 1.0, 1e-9);
  EXPECT_NEAR(contact.secondary.max_depth_mm, 1000.0 * 0.021 * 0.25, 1e-3);
  EXPECT_LT(test::resident_MB() - early, support::address_sanitizer ? 300.0 : 16.0);
}

TEST(SolidRemeshes, AHundredWithoutWearChangeNothing) {
  // Both bodies of a worn contact meshed again a hundred times without wear: pressures within 2 % of their mean from
  // each mesh to the next and from the first to the last, volumes to round-off.
  const auto result = support::remeshed_cap(100);
  for (const double jump : result.jumps) EXPECT_LE(jump, 0.02);
  EXPECT_LE(result.drift, 0.02);
  EXPECT_LE(result.force_error, 1e-3);
  EXPECT_LE(result.volume_error, 1e-9);
}
