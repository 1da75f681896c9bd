#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "problem_of.hpp"
#include "sim/march/block.hpp"
#include "sim/measure/measure.hpp"
#include "sim/measure/surfaces.hpp"

using namespace reye;

namespace {

struct Prepared {
  sim::Problem problem;
  sim::Cache cache;
  sim::State state;

  explicit Prepared(const std::string& text, double gap = 0.0)
      : problem(test::problem_of(text, gap)), state(sim::initial_state(problem)) {
    sim::begin_state(problem, state, cache);
  }
  /// One iteration only, and so many cut-backs.
  void make_hopeless(int cutbacks) {
    problem.scene.max_cutbacks = cutbacks;
    solver::NewtonOptions hopeless;
    hopeless.max_iterations = 1;
    cache.newton = solver::Newton(hopeless);
  }
  sim::SystemPtr system() { return sim::system_of(problem, state, cache); }
  solver::Sides sides() { return solver::positions(*system(), system()->contacts[0], state.solution.q.high); }
  sim::BlockSpan span(int step) const {
    const auto& s = problem.scene.steps[step];
    return {&s, s.cycles > 0.0 ? s.jump : 1.0, s.cycles > 0.0};
  }
};

double lowest(const base::Points& points) {
  double y = INFINITY;
  for (const auto& p : points) y = std::min(y, p.y());
  return y;
}

/// Everything of a state that a failed step could have touched.
std::vector<double> numbers(const sim::State& s) {
  std::vector<double> all(s.solution.q.high.begin(), s.solution.q.high.end());
  all.insert(all.end(), s.solution.q.low.begin(), s.solution.q.low.end());
  for (const auto& c : s.solution.contacts) {
    for (const auto& l : c.lambda) all.insert(all.end(), {l.x(), l.y()});
    for (const auto& v :
         {c.pending_secondary, c.pending_primary, c.removed_secondary, c.removed_primary, c.slip, c.energy_secondary})
      all.insert(all.end(), v.begin(), v.end());
    all.insert(all.end(),
               {c.friction, c.frictional_work, c.worn_work, c.law_volume, c.strip_secondary, c.strip_primary});
  }
  for (const auto& [name, factor] : s.factors) all.push_back(factor);
  all.insert(all.end(), {s.cycle, static_cast<double>(s.counts.increments), static_cast<double>(s.counts.cutbacks)});
  return all;
}

}  // namespace

// Bodies apart and driven by a force must be moved along it until they touch, as rigid bodies, without a spring.
TEST(Approach, LoadedBodyIsMovedUntilItTouches) {
  Prepared p(test::block_scene, 0.2);
  EXPECT_NEAR(lowest(p.sides().secondary), 0.0, 1e-12);
  const auto& linear = p.system()->bodies[0];
  const auto q = p.system()->part(p.state.solution.q.high, 0);
  const base::Vector none;
  const double force = std::get<body::LinearBody>(linear).residual(q, none).norm();
  EXPECT_LT(force, 1e-6);  // 200e3 MPa times round-off of the motion
  EXPECT_EQ(p.state.solution.q.high.tail(1)[0], 0.0);
}

// A body whose motion along the load is held must stay where the scene puts it.
TEST(Approach, HeldBodyStays) {
  Prepared p(test::with(test::block_scene, {{"y        = { force_N_per_mm = -20.0, history = \"press\" }",
                                             "y = { motion_mm = -0.3, history = \"press\" }"}}),
             0.2);
  EXPECT_NEAR(lowest(p.sides().secondary), 0.2, 1e-12);
  EXPECT_EQ(p.state.solution.q.high.norm(), 0.0);
}

// A force of a later step must not keep apart what the first one presses together.
TEST(Approach, LaterForcesWait) {
  Prepared p(test::with(test::block_scene, {{"[history]",
                                             "[load.pull]\nedge = \"slider_top\"\ntraction_MPa = [0.0, 15.0]\n"
                                             "history = \"stroke\"\n[history]"}}),
             0.2);
  EXPECT_NEAR(lowest(p.sides().secondary), 0.0, 1e-12);
}

// Bodies that touch from the start must not be moved.
TEST(Approach, TouchingBodiesStay) {
  Prepared p(test::block_scene);
  EXPECT_LT(p.state.solution.q.high.norm(), 1e-12);
}

// A failed block must leave the state it started from untouched: it is a value, never half updated.
TEST(Blocks, FailedStepLeavesTheState) {
  Prepared p(test::block_scene);
  p.make_hopeless(0);
  const auto before = numbers(p.state);
  const auto shapes = p.state.shapes;
  const auto outcome = sim::play_increments(p.problem, p.state, p.cache, p.span(1), {});
  EXPECT_NE(outcome.failure.find("no convergence in 1 iterations"), std::string::npos) << outcome.failure;
  EXPECT_EQ(numbers(p.state), before);
  EXPECT_EQ(p.state.shapes, shapes);
}

// An increment that does not converge must be halved, as often as allowed, and every halving say where and why.
TEST(Blocks, CutBackHalvesAndSaysWhy) {
  Prepared p(test::block_scene);
  p.make_hopeless(2);
  std::vector<std::string> log;
  sim::Observer observer;
  observer.log = [&](const std::string& line) { log.push_back(line); };
  const auto outcome = sim::play_increments(p.problem, p.state, p.cache, p.span(1), observer);
  EXPECT_EQ(outcome.state.counts.cutbacks, 2);
  ASSERT_EQ(outcome.state.cutback_reasons.size(), 2U);
  EXPECT_NE(outcome.state.cutback_reasons[0].find("step \"wear\", cycle 0, progress 0 to 0.125: "), std::string::npos);
  EXPECT_NE(outcome.state.cutback_reasons[1].find("progress 0 to 0.0625: "), std::string::npos);
  EXPECT_NE(outcome.failure.find("progress 0 to 0.03125: "), std::string::npos);
  ASSERT_EQ(log.size(), 3U);
  EXPECT_EQ(log[0], "cut back: " + outcome.state.cutback_reasons[0]);
  EXPECT_EQ(log[2].find("no state: step \"wear\", cycle 0, progress 0 to 0.03125: no convergence in 1 iterations"), 0U)
      << log[2];
}

// However many increments are cut, a state must keep the reasons of the first hundred only, and count all.
TEST(Blocks, CutBackReasonsAreBounded) {
  Prepared p(test::block_scene);
  p.make_hopeless(120);
  const auto outcome = sim::play_increments(p.problem, p.state, p.cache, p.span(1), {});
  EXPECT_EQ(outcome.state.counts.cutbacks, 120);
  EXPECT_EQ(outcome.state.cutback_reasons.size(), 100U);
  EXPECT_NE(outcome.state.cutback_reasons[0].find("progress 0 to 0.125: "), std::string::npos);
}

// Surface tables must run along the boundary from its end with smaller x, with the pressure in balance with the load
// A system that is held must stay what it is when the cache makes that of another shape, or of another kinematics.
TEST(Blocks, SystemsAreImmutable) {
  Prepared p(test::block_scene);
  const auto held = p.system();
  const base::Matrix before = std::get<body::LinearBody>(held->bodies[0]).stiffness();
  auto mesh = p.state.shapes[0]->mesh;
  for (auto& X : mesh.X) X.x() *= 1.5;
  p.state.shapes[0] = body::make_shape(std::move(mesh));
  const auto next = p.system();
  EXPECT_NE(next, held);
  EXPECT_EQ(p.system(), next);
  EXPECT_EQ(std::get<body::LinearBody>(held->bodies[0]).stiffness(), before);
  p.problem.inputs[1].kinematics = base::Kinematics::finite;
  p.problem.inputs[1].material = material::Hencky{100.0, 0.3};
  EXPECT_TRUE(std::holds_alternative<body::NonlinearBody>(p.system()->bodies[1]));
  EXPECT_TRUE(std::holds_alternative<body::LinearBody>(next->bodies[1]));
}

// A body that changes its shape must hand on its analysis and nothing else, one that keeps it all of it; where the new
// system cannot be made the cache must hold none, so that the old one is made again, to the bit.
TEST(Blocks, OperatorsAtAnotherShape) {
  Prepared p(test::block_scene);
  const auto tangent = [&](int b) { return std::get<body::LinearBody>(p.system()->bodies[b]).stiffness(); };
  const auto analysis = [&](int b) { return std::get<body::LinearBody>(p.system()->bodies[b]).analysis(); };
  const std::array before{tangent(0), tangent(1)};
  const std::array known{analysis(0), analysis(1)};
  const auto born = p.state.shapes[0];
  const auto stretched = [&](double factor) {
    auto mesh = born->mesh;
    for (auto& X : mesh.X) X.x() *= factor;
    return body::make_shape(std::move(mesh));
  };
  p.state.shapes[0] = stretched(1.5);
  EXPECT_NE(tangent(0), before[0]);
  EXPECT_EQ(tangent(1), before[1]);
  EXPECT_EQ(analysis(0), known[0]);
  EXPECT_EQ(analysis(1), known[1]);
  p.state.shapes[0] = stretched(-1.0);
  EXPECT_THROW(p.system(), base::MeshError);
  EXPECT_TRUE(p.cache.key.shapes.empty());
  p.state.shapes[0] = born;
  EXPECT_EQ(tangent(0), before[0]);
  EXPECT_EQ(tangent(1), before[1]);
}

// and the shear on the secondary side against its motion.
TEST(Blocks, SurfaceTables) {
  Prepared p(test::block_scene);
  auto outcome = sim::play_increments(p.problem, p.state, p.cache, p.span(0), {});
  ASSERT_EQ(outcome.failure, "");
  p.state = outcome.state;
  std::vector<sim::IncrementRecord> rows;
  sim::Observer observer;
  observer.increment = [&](const sim::IncrementRecord& r) { rows.push_back(r); };
  observer.interrupted = [&] { return rows.size() == 2; };  // at the end of the first stroke
  outcome = sim::play_increments(p.problem, p.state, p.cache, p.span(1), observer);
  ASSERT_TRUE(outcome.interrupted);
  p.state = outcome.state;
  const auto tables = sim::surface_records(p.system()->contacts[0], p.state.solution.contacts[0], p.state.shapes,
                                           p.problem.contacts[0]);
  std::vector<double> pressed, sheared;
  for (const auto& table : tables) {
    EXPECT_TRUE(std::is_sorted(table.arc_length_mm.begin(), table.arc_length_mm.end()));
    EXPECT_TRUE(std::is_sorted(table.x_mm.begin(), table.x_mm.end()));
    EXPECT_EQ(table.arc_length_mm.front(), 0.0);
    double pressure = 0.0, shear = 0.0;
    for (std::size_t i = 1; i < table.node.size(); ++i) {
      const double ds = table.arc_length_mm[i] - table.arc_length_mm[i - 1];
      pressure += 0.5 * ds * (table.pressure_MPa[i] + table.pressure_MPa[i - 1]);
      shear += 0.5 * ds * (table.shear_MPa[i] + table.shear_MPa[i - 1]);
    }
    EXPECT_NEAR(pressure, 20.0, 1e-2);  // along normals that turn with the surface, by about 1e-4
    pressed.push_back(pressure);
    sheared.push_back(shear);
  }
  EXPECT_NEAR(sheared[0], -0.3 * pressed[0], 1e-9);  // on the normals of the deformed surface the law is exact
  EXPECT_NEAR(sheared[1], -sheared[0], 1e-2);
  EXPECT_DOUBLE_EQ(tables[0].arc_length_mm.back(), 2.0);
  EXPECT_DOUBLE_EQ(tables[1].arc_length_mm.back(), 4.0);
  const auto& forces = rows.back().support_forces;  // holder, floor: what the supports do to the bodies
  EXPECT_NEAR(forces[0].y(), -20.0, 1e-8);
  EXPECT_NEAR((forces[0] + forces[1]).norm(), 0.0, 1e-8);
  EXPECT_NEAR(forces[0].x(), -sheared[0], 1e-2);
}
