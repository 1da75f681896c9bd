#include <gtest/gtest.h>

#include <cmath>

#include "sim/study/discretisation.hpp"
#include "verification/wear_scene.hpp"

using namespace reye;
using verification::prepared, verification::scene_text;

namespace {

/// A side along x from -1 to 1 with values f(x) as pressure and depth.
template <class F>
sim::SurfaceRecord side(int elements, F f, sim::Side which = sim::Side::secondary) {
  sim::SurfaceRecord s;
  s.side = which;
  for (int i = 0; i <= elements; ++i) {
    const double x = -1.0 + 2.0 * i / elements;
    s.arc_length_mm.push_back(x + 1.0);
    s.x_mm.push_back(x);
    s.y_mm.push_back(0.0);
    s.pressure_MPa.push_back(f(x));
    s.shear_MPa.push_back(0.5 * f(x));
    s.wear_depth_mm.push_back(f(x));
  }
  return s;
}

double bump(double x) { return std::max(0.0, 1.0 - 4.0 * x * x); }

sim::Problem hertz_problem(const std::string& size, const std::string& more = "") {
  const verification::Replacements words{{"size_mm = 0.010", "size_mm = " + size},
                                         {"increments = 5", "increments = 1"}};
  return prepared(scene_text("hertz_halfplane", words) + more);
}

}  // namespace

// A side with a tenth more of everything must be a tenth off, in wear and in tractions, whatever the other mesh.
TEST(Discretisation, ATenthMore) {
  const std::vector fine{side(64, [](double x) { return 1.0 - 0.5 * x; })};
  const std::vector coarse{side(7, [](double x) { return 1.1 * (1.0 - 0.5 * x); })};
  const auto apart = sim::mesh_difference(fine, coarse, base::Analysis::plane_strain);
  EXPECT_NEAR(apart.wear.value(), 0.1, 1e-12);
  EXPECT_NEAR(apart.traction.value(), 0.1, 1e-12);
  EXPECT_NEAR(apart.peak.value(), 0.1, 1e-12);
  EXPECT_EQ(sim::mesh_difference(fine, fine, base::Analysis::plane_strain).wear, 0.0);
}

// In axisymmetry a place must count by its radius: p = 1 against 1 + x / 10 for 1 <= x <= 3 is off by a tenth of
// root int x^2 x dx over int x dx = 5.
TEST(Discretisation, RingsCountByTheirRadius) {
  auto fine = side(1000, [](double) { return 1.0; }),
       coarse = side(1000, [](double x) { return 1.0 + 0.1 * (x + 2.0); });
  for (auto* s : {&fine, &coarse})
    for (double& x : s->x_mm) x += 2.0;
  const auto apart = sim::mesh_difference({fine}, {coarse}, base::Analysis::axisymmetric);
  EXPECT_NEAR(apart.traction.value(), 0.1 * std::sqrt(5.0), 1e-5);
}

// A smooth profile that is straight between the coarse nodes must be off by the second power of their distance.
TEST(Discretisation, OrderOfInterpolation) {
  std::vector<double> apart;
  const std::vector fine{side(1024, bump)};
  for (int n : {16, 32, 64})
    apart.push_back(sim::mesh_difference(fine, {side(n, bump)}, base::Analysis::plane_strain).wear.value());
  for (int k : {0, 1}) EXPECT_NEAR(std::log2(apart[k] / apart[k + 1]), 2.0, 0.1) << apart[k];
}

// A spike of one node must show in the error of the peak, though in the mean it is small.
TEST(Discretisation, ASpikeIsAnErrorOfThePeak) {
  const std::vector coarse{side(100, [](double) { return 1.0; })};
  auto fine = coarse;
  fine[0].pressure_MPa[50] = 2.0;
  const auto apart = sim::mesh_difference(fine, coarse, base::Analysis::plane_strain);
  EXPECT_LT(apart.traction.value(), 0.11);
  EXPECT_NEAR(apart.peak.value(), 0.5, 1e-12);
}

// Where nothing has worn or touches there must be no number, not a zero.
TEST(Discretisation, NothingToCompare) {
  const std::vector none{side(8, [](double) { return 0.0; })};
  const auto apart = sim::mesh_difference(none, none, base::Analysis::plane_strain);
  EXPECT_FALSE(apart.wear || apart.traction || apart.peak);
}

// The companion's scene must have all sizes doubled, automatic ones, too, and no further end than the run had.
TEST(Discretisation, Coarser) {
  auto problem = hertz_problem("0.04");
  problem.scene.geometry.bodies[0].mesh.far_size_mm = 0.0;
  problem.scene.output.estimate_error = true;
  problem.scene.body_material.at("flat").kinematics = base::Kinematics::finite;  // what the run has decided stays
  problem.scene.steps.resize(3);
  problem.scene.steps[1].cycles = problem.scene.steps[2].cycles = 100.0;
  sim::State state = sim::initial_state(problem);
  state.step = 1;
  state.step_cycles = 30.0;
  const auto coarse = sim::coarser(problem, state);
  EXPECT_DOUBLE_EQ(coarse.geometry.fine_zones[0].size_mm, 0.08);
  EXPECT_NEAR(coarse.geometry.bodies[0].mesh.far_size_mm, std::hypot(40.0, 20.0) / 10.0, 1e-9);
  EXPECT_DOUBLE_EQ(coarse.geometry.bodies[1].mesh.far_size_mm, 4.0);
  EXPECT_EQ(coarse.body_material.at("flat").kinematics, base::Kinematics::finite);
  ASSERT_EQ(coarse.steps.size(), 2u);
  EXPECT_EQ(coarse.steps[1].cycles, 30.0);
  EXPECT_FALSE(coarse.output.estimate_error);
}

// A run that is not asked must pay nothing and know nothing; one that is asked must have the same end, bit by bit.
TEST(Discretisation, OnlyWhenAsked) {
  sim::Summary told[2];
  Eigen::VectorXd q[2];
  for (int asked : {0, 1}) {
    const auto problem = hertz_problem("0.04", asked ? "[output]\nestimate_error = true\n" : "");
    auto state = sim::initial_state(problem);
    told[asked] = sim::run(problem, state, {});
    q[asked] = state.solution.q.high;
  }
  EXPECT_EQ(q[0], q[1]);
  EXPECT_EQ(told[0].counts.newton_iterations, told[1].counts.newton_iterations);
  EXPECT_FALSE(told[0].error_discretisation || told[0].error_peak_pressure || told[0].error_energy_norm);
  EXPECT_GT(told[1].error_discretisation.value(), 0.0);
  EXPECT_GT(told[1].error_peak_pressure.value(), 0.0);
  EXPECT_GT(told[1].error_energy_norm.value(), 0.0);
}

// An interruption during the companion run must leave a run that is interrupted and, restarted, ends with its estimate.
TEST(Discretisation, Interrupted) {
  const auto problem = hertz_problem("0.04", "[output]\nestimate_error = true\n");
  auto state = sim::initial_state(problem);
  sim::Observer observer;
  bool coarse = false;
  observer.progress = [&](const sim::Progress& p) { coarse = p.step.starts_with("coarse"); };
  observer.interrupted = [&] { return coarse; };
  EXPECT_EQ(sim::run(problem, state, observer).status, sim::RunStatus::interrupted);
  const auto again = sim::run(problem, state, {});
  EXPECT_EQ(again.status, sim::RunStatus::done);
  EXPECT_TRUE(again.error_discretisation.has_value());
}

// A mesh that came with its file cannot be made coarser, and for one with hardly an element in contact no error can be
// given: no number, and the log says why.
TEST(Discretisation, NoNumberButAReason) {
  const std::pair<sim::Problem, std::string> cases[] = {
      {prepared(scene_text("patch", {{"[output]", "[output]\nestimate_error = true"}})), "came with their files"},
      {hertz_problem("0.08", "[output]\nestimate_error = true\n"), "fewer than four elements touch"}};
  for (const auto& [problem, reason] : cases) {
    auto state = sim::initial_state(problem);
    std::string log;
    sim::Observer observer;
    observer.log = [&](const std::string& line) { log += line; };
    const auto summary = sim::run(problem, state, observer);
    EXPECT_EQ(summary.status, sim::RunStatus::done);
    EXPECT_FALSE(summary.error_discretisation.has_value());
    EXPECT_NE(log.find(reason), std::string::npos) << log;
  }
}
