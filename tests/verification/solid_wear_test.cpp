#include <gtest/gtest.h>

#include "support/solid_hertz.hpp"

using namespace reye;
using base::Vec3;

namespace {

/// A block on a block, pressed with p = 10 MPa on its top, or held there; meshes do not match. nu = 0 and sides on
/// planes of symmetry keep the pressure even. Sliding along x is imposed, friction 0.3.
struct SlidingBlocks {
  double alpha_secondary = 2e-4, alpha_primary = 1e-4;  ///< [mm^2/N]
  mesh::SolidKind lower = mesh::SolidKind::hex8, upper = mesh::SolidKind::hex8;
  bool held = false;  ///< the top is held at the depth of the pressure: the column
  static constexpr double E = 2e3, p = 10.0, mu = 0.3;

  sim::SolidProblem problem(double slide_mm, int increments, double cycles = 0.0, double jump = 1.0) const {
    auto below = support::solid(
        "below", support::block(lower, {3, 3, 1}, Vec3::Ones(), support::box({0, 0, 0}, {1, 1, 1})), E, 0.0);
    auto above = support::solid(
        "above", support::block(upper, {2, 2, 1}, Vec3::Ones(), support::box({0, 0, 1}, {1, 1, 2})), E, 0.0);
    for (auto* body : {&below, &above}) {
      body->supports = {support::symmetry(body->name + "_x", "x0"), support::symmetry(body->name + "_x1", "x1"),
                        support::symmetry(body->name + "_y", "y0"), support::symmetry(body->name + "_y1", "y1")};
    }
    below.supports.push_back(support::symmetry("bottom", "z0"));
    if (held) {
      body::SolidSupport top = support::by_node("top", "z1", {});
      top.along[2] = support::moved(-2.0 * p / E, "press");
      above.supports.push_back(top);
    } else {
      body::SolidLoad press;
      press.name = press.face = "z1";
      press.pressure_MPa = p;
      press.history = "press";
      above.loads = {press};
    }
    auto all = support::problem_of({below, above}, {0, "z1"}, {1, "z0"}, 0.0, 0.2);
    auto& options = all.contacts[0].options;
    options.wear.kind = wear::LawKind::archard;  // mu p = 0.3 p: as the energy law with friction
    options.wear.secondary = mu * alpha_secondary;
    options.wear.primary = mu * alpha_primary;
    options.sliding = {{.direction = Vec3::UnitX(), .parts = {{slide_mm, ""}}}};
    all.scene.histories["press"] = {{0.0, 0.0}, {1.0, 1.0}};
    auto slide = support::step_of(increments, {}, cycles);
    slide.wear = true;
    slide.jump = jump;
    slide.name = "slide";
    all.scene.steps = {support::step_of(1, {"press"}), slide};
    return all;
  }
};

support::HertzCase sliding_ball_case() {
  support::HertzCase c;
  c.elements = 5.0;
  return c;
}

/// A ball that is pressed on a flat, then slides on it in the step and wears by Archard's law.
sim::SolidProblem sliding_ball(double alpha, double way_mm, scene::Step step) {
  const auto c = sliding_ball_case();
  auto problem = support::hertz_problem(c);
  auto& options = problem.contacts[0].options;
  options.wear.kind = wear::LawKind::archard;
  options.wear.secondary = alpha;
  options.sliding = {{.direction = Vec3::UnitX(), .parts = {{way_mm, ""}}}};
  problem.scene.geometry.fine_zones[0].radius_mm = 1.6 * c.a_mm;
  step.wear = true;
  problem.scene.steps.push_back(std::move(step));
  return problem;
}

}  // namespace

TEST(SolidWear, BlocksUnderALoadWearByTheLaw) {
  // Under an even pressure that a load keeps up, both blocks lose k p s everywhere, exactly, whatever the meshes, and
  // the ledger closes.
  for (const auto& [lower, upper] : {std::pair{mesh::SolidKind::hex8, mesh::SolidKind::hex8},
                                     std::pair{mesh::SolidKind::hex8, mesh::SolidKind::tet4},
                                     std::pair{mesh::SolidKind::tet10, mesh::SolidKind::hex8}}) {
    SlidingBlocks blocks;
    blocks.lower = lower;
    blocks.upper = upper;
    const auto played = support::play(blocks.problem(100.0, 4));
    ASSERT_EQ(played.summary.status, sim::RunStatus::done) << played.summary.reason;
    const double depth = blocks.mu * blocks.alpha_secondary * blocks.p * 100.0;
    const auto& frame = played.frames.back();
    for (const double d : frame.surfaces[0].wear_depth_mm) EXPECT_NEAR(d, depth, 1e-10 * depth);
    for (const double d : frame.surfaces[1].wear_depth_mm) EXPECT_NEAR(d, 0.5 * depth, 1e-10 * depth);
    const auto& contact = played.summary.contacts[0];
    EXPECT_NEAR(contact.secondary.worn_volume_mm3, depth, 1e-12 * depth);
    EXPECT_NEAR(contact.primary.worn_volume_mm3, 0.5 * depth, 1e-12 * depth);
    EXPECT_LE(*contact.ledger_relative_error, 1e-13);
  }
}

TEST(SolidWear, AHeldColumnLosesItsPressureByBackwardEuler) {
  // Blocks whose far ends are held lose pressure as they wear: dp = -(E / 2) k p ds, and each increment is a step of
  // backward Euler, p = p_0 / (1 + (E / 2) k s) to 1e-12, whatever its size.
  SlidingBlocks blocks;
  blocks.held = true;
  const auto played = support::play(blocks.problem(10.0, 5));
  ASSERT_EQ(played.summary.status, sim::RunStatus::done) << played.summary.reason;
  const double k = blocks.mu * (blocks.alpha_secondary + blocks.alpha_primary), step = 2.0;
  double p = blocks.p;
  for (std::size_t i = 1; i < played.rows.size(); ++i) {
    p /= 1.0 + 0.5 * blocks.E * k * step;
    EXPECT_NEAR(played.rows[i].contacts[0].pressure_max_MPa, p, 1e-10 * blocks.p);
    EXPECT_NEAR(played.rows[i].contacts[0].normal_force_N, p, 1e-10 * blocks.p);
    EXPECT_LE(played.rows[i].newton, 6);
  }
}

TEST(SolidWear, AJumpStandsForItsCycles) {
  // Blocks of ten cycles wear ten times what one cycle does; their sum is the law's volume.
  SlidingBlocks blocks;
  const auto played = support::play(blocks.problem(1.0, 2, 100.0, 10.0));
  ASSERT_EQ(played.summary.status, sim::RunStatus::done) << played.summary.reason;
  EXPECT_EQ(played.summary.counts.cycles_solved, 10);
  EXPECT_DOUBLE_EQ(played.summary.cycles, 100.0);
  const double depth = blocks.mu * blocks.alpha_secondary * blocks.p * 100.0;
  EXPECT_NEAR(played.summary.contacts[0].secondary.max_depth_mm, depth, 1e-10 * depth);
}

TEST(SolidWear, AToleranceIsHeldByTheColumn) {
  // Under a tolerance of 1 % the depth of the held column comes within 1 % of its differential equation, with few of
  // the cycles played, and the run says no less than a third of its error: from whatever jump it begins, though that
  // decides which blocks it plays.
  SlidingBlocks blocks;
  blocks.held = true;
  const double k = blocks.mu * (blocks.alpha_secondary + blocks.alpha_primary);
  const double lost = 2.0 * blocks.p / blocks.E * (1.0 - std::exp(-0.5 * blocks.E * k * 20.0));
  const double exact = lost * blocks.alpha_secondary / (blocks.alpha_secondary + blocks.alpha_primary);
  for (const double more : {0.0, 1e-6, 1e-4, 1e-3, 0.01, 0.1, 0.3, 0.5, 1.0, 2.0}) {
    auto problem = blocks.problem(0.002, 1, 10000.0, 1.0);
    problem.scene.steps[1].jump_tolerance = 0.01;
    problem.scene.steps[1].jump = 10.0 + more;
    const auto played = support::play(problem);
    ASSERT_EQ(played.summary.status, sim::RunStatus::done) << played.summary.reason;
    const double error = std::abs(played.summary.contacts[0].secondary.max_depth_mm / exact - 1.0);
    EXPECT_LE(error, 0.01) << *played.summary.error_cycle_jump << " by " << played.summary.counts.cycles_solved;
    EXPECT_LE(error, 3.0 * *played.summary.error_cycle_jump + 1e-4);
    EXPECT_LE(played.summary.counts.cycles_solved, 150);
    EXPECT_LE(*played.summary.contacts[0].ledger_relative_error, 1e-12);
  }
}

TEST(SolidWear, PressuresOnTheWayAreThoseOfTheColumn) {
  // Pressures that are shown on the way must be those of the differential equation of the held column, though its last
  // short cycles change them.
  SlidingBlocks blocks;
  blocks.held = true;
  const double k = blocks.mu * (blocks.alpha_secondary + blocks.alpha_primary);
  auto problem = blocks.problem(0.002, 1, 10000.0, 1.0);
  problem.scene.steps[1].jump_tolerance = 0.01;
  problem.scene.steps[1].jump = 20.0;
  problem.scene.frames.every_cycles = 1000.0;
  const auto played = support::play(problem);
  ASSERT_EQ(played.summary.status, sim::RunStatus::done) << played.summary.reason;
  int shown = 0;
  for (const auto& row : played.rows) {
    const double thousands = row.cycle / 1000.0;
    if (row.cycle < 1.0 || std::abs(thousands - std::round(thousands)) > 1e-9) continue;
    ++shown;
    const double exact = blocks.p * std::exp(-0.5 * blocks.E * k * 0.002 * row.cycle);
    EXPECT_NEAR(row.contacts[0].pressure_max_MPa / exact, 1.0, 0.02) << row.cycle;
  }
  EXPECT_GE(shown, 3);  // blocks of some thousand cycles pass the others
}

TEST(SolidWear, ALimitEndsTheRunAtItsDepth) {
  // A limit that stops the run ends it at the cycle at which its depth is reached, within a thousandth.
  SlidingBlocks blocks;
  auto problem = blocks.problem(1.0, 1, 1000.0, 30.0);
  const double per_cycle = blocks.mu * blocks.alpha_secondary * blocks.p;
  scene::Limit limit;
  limit.name = "deep";
  limit.contact = "pad";
  limit.side = "secondary";
  limit.depth_mm = 123.4 * per_cycle;
  limit.stop = true;
  problem.scene.limits = {limit};
  const auto played = support::play(problem);
  ASSERT_EQ(played.summary.status, sim::RunStatus::done) << played.summary.reason;
  ASSERT_TRUE(played.summary.life_cycles.at("deep").has_value());
  EXPECT_NEAR(*played.summary.life_cycles.at("deep"), 123.4, 0.13);
  EXPECT_NEAR(played.summary.cycles, 123.4, 0.13);
}

TEST(SolidWear, ABallWornFlatLosesTheCapOfItsPath) {
  // A ball that slides on a flat under a load of P loses V = k P s, but for the slope of its surface, whose square is
  // below 1e-4, and needs few iterations on its way.
  const auto c = sliding_ball_case();
  const auto played = support::play(sliding_ball(1e-8, 200.0, support::step_of(4)));
  ASSERT_EQ(played.summary.status, sim::RunStatus::done) << played.summary.reason;
  const double volume = 1e-8 * c.force() * 200.0;
  const auto& contact = played.summary.contacts[0];
  EXPECT_NEAR(contact.secondary.worn_volume_mm3 / c.share(), volume, 1e-4 * volume);
  EXPECT_LE(*contact.ledger_relative_error, 1e-13);
  EXPECT_GT(contact.secondary.max_depth_mm, 0.0);
  EXPECT_LE(played.summary.counts.newton_iterations, 8 * played.summary.counts.increments);
}

TEST(SolidWear, ARemeshedBlockKeepsItsPressureAndItsBook) {
  // A block that wears by more than half of its elements is remeshed on its way: it loses exactly what the law asks
  // for, and the even pressure of its load stays what it was.
  SlidingBlocks blocks;
  blocks.lower = mesh::SolidKind::tet4;
  blocks.alpha_primary = 0.0;
  const double per_mm = blocks.mu * blocks.alpha_secondary * blocks.p, depth = 0.6;
  const auto played = support::play(blocks.problem(depth / per_mm / 12.0, 1, 12.0, 1.0));
  ASSERT_EQ(played.summary.status, sim::RunStatus::done) << played.summary.reason;
  EXPECT_GE(played.summary.counts.remeshes, 1);
  const auto& contact = played.summary.contacts[0];
  EXPECT_NEAR(contact.secondary.worn_volume_mm3, depth, 1e-9 * depth);
  EXPECT_LE(*contact.ledger_relative_error, 1e-9);
  for (const double p : played.frames.back().surfaces.front().pressure_MPa) EXPECT_NEAR(p, blocks.p, 1e-6 * blocks.p);
  EXPECT_LE(played.summary.balance, 1e-10);
}

TEST(SolidWear, TheEndOfARunIsNotRemeshed) {
  // A body whose last block leaves it about to need a fresh mesh keeps the mesh whose pressures wore it; the run that
  // continues by one block more makes one there.
  SlidingBlocks blocks;
  blocks.lower = mesh::SolidKind::tet4;
  blocks.alpha_primary = 0.0;
  const double per_mm = blocks.mu * blocks.alpha_secondary * blocks.p;
  const auto remeshes = [&](int cycles) {
    return support::play(blocks.problem(0.05 / per_mm, 1, cycles, 1.0)).summary.counts.remeshes;
  };
  int cycles = 1;
  while (cycles < 20 && remeshes(cycles + 1) == 0) ++cycles;
  EXPECT_EQ(remeshes(cycles), 0);
  std::vector<double> when;
  sim::SolidObserver observer;
  observer.remesh = [&](const sim::SolidRemeshRecord& record) { when.push_back(record.cycle); };
  const auto problem = blocks.problem(0.05 / per_mm, 1, cycles + 1, 1.0);
  sim::run_solid(problem, observer);
  EXPECT_EQ(when, std::vector<double>{static_cast<double>(cycles)});
}

TEST(SolidWear, StrongWearNeedsFewIterations) {
  // Where an increment wears tens of times what bodies approach by their compliance, points that close wear at once:
  // Newton needs few iterations and no cut-back.
  const auto played = support::play(sliding_ball(1e-7, 50.0, support::step_of(1, {}, 8.0)));
  ASSERT_EQ(played.summary.status, sim::RunStatus::done) << played.summary.reason;
  EXPECT_EQ(played.summary.counts.cutbacks, 0);
  EXPECT_LE(played.summary.counts.newton_iterations, 7 * played.summary.counts.increments);
}

TEST(SolidWear, HexahedraWearUntilTheyArePoor) {
  // Hexahedra are not remeshed: they wear beyond the depth at which tetrahedra would be, to the law's volume. One that
  // is worn through ends its run with the cause, and what is shown last is the last good state; progress reports its
  // depth.
  SlidingBlocks blocks;
  blocks.alpha_primary = 0.0;
  const double per_mm = blocks.mu * blocks.alpha_secondary * blocks.p;
  const auto deep = support::play(blocks.problem(0.7 / per_mm / 14.0, 1, 14.0, 1.0));
  ASSERT_EQ(deep.summary.status, sim::RunStatus::done) << deep.summary.reason;
  EXPECT_EQ(deep.summary.counts.remeshes, 0);
  EXPECT_NEAR(deep.summary.contacts[0].secondary.worn_volume_mm3, 0.7, 1e-9);

  const auto problem = blocks.problem(1.5 / per_mm / 30.0, 1, 30.0, 1.0);
  std::vector<sim::SolidFrame> frames;
  double told_mm = 0.0, row_mm = 0.0;
  sim::SolidObserver observer;
  observer.frame = [&](const sim::SolidFrame& frame) { frames.push_back(frame); };
  observer.progress = [&](const sim::Progress& progress) { told_mm = progress.depth_max_mm; };
  observer.increment = [&](const sim::SolidIncrement& row) { row_mm = row.contacts[0].depth_secondary_mm; };
  const auto summary = sim::run_solid(problem, observer);
  EXPECT_EQ(summary.status, sim::RunStatus::failed);
  EXPECT_NE(summary.reason.find("body below"), std::string::npos) << summary.reason;
  ASSERT_FALSE(frames.empty());
  EXPECT_EQ(frames.back().step, "last good state");
  EXPECT_GT(told_mm, 0.7);
  EXPECT_EQ(told_mm, row_mm);
}
