#include <gtest/gtest.h>

#include <algorithm>

#include "sim/measure/measure.hpp"
#include "sim/measure/surfaces.hpp"
#include "sim/study/run.hpp"
#include "support/problem.hpp"
#include "support/scene_words.hpp"

using namespace reye;

namespace {

/// Half a disc of radius 1 on a block, off its middle.
const char* const disc_on_block =
    R"(Point(1) = {-1, 1, 0}; Point(2) = {0, 0, 0}; Point(3) = {1, 1, 0}; Point(4) = {0, 1, 0};
Circle(1) = {1, 4, 2}; Circle(2) = {2, 4, 3}; Line(3) = {3, 1};
Curve Loop(1) = {1, 2, 3}; Plane Surface(1) = {1};
Point(5) = {-1.3, -1, 0}; Point(6) = {1.7, -1, 0}; Point(7) = {1.7, 0, 0}; Point(8) = {-1.3, 0, 0};
Line(5) = {5, 6}; Line(6) = {6, 7}; Line(7) = {7, 8}; Line(8) = {8, 5};
Curve Loop(2) = {5, 6, 7, 8}; Plane Surface(2) = {2};
Physical Surface("disc") = {1}; Physical Surface("block") = {2};
Physical Curve("round") = {1, 2}; Physical Curve("top") = {3}; Physical Curve("face") = {7}; Physical Curve("bottom") = {5};
)";

std::string scene(const std::string& contact, const std::string& disc_size) {
  return "geometry = [\"disc.geo\"]\n" +
         support::steel_bodies({{"disc", "far_size_mm = " + disc_size}, {"block", "far_size_mm = 0.06"}}) +
         R"([contact.pad]
secondary = "round"
primary = ["face"]
)" + contact +
         R"(
[support.holder]
edge = "top"
x = { motion_mm = 0.01, history = "slide" }
rotation = "fixed"
y = { force_N_per_mm = -2000.0, history = "press" }
[support.floor]
edge = "bottom"
x = "fixed"
y = "fixed"
[history]
press = [[0, 0], [1, 1]]
slide = [[0, 0], [1, 1]]
[[step]]
name = "press"
play = ["press"]
increments = 3
[[step]]
name = "slide"
play = ["slide"]
increments = 2
)";
}

struct Pressed {
  std::array<sim::SurfaceRecord, 2> tables;
  sim::ContactSummary summary;
  base::Vec2 holder;  ///< force of the support on the disc
};

Pressed pressed(const std::string& contact, const std::string& disc_size) {
  const auto problem = support::problem_from({{"disc.geo", disc_on_block}, {"scene.toml", scene(contact, disc_size)}});
  auto state = sim::initial_state(problem);
  sim::Observer observer;
  Pressed result;
  observer.increment = [&](const sim::IncrementRecord& r) { result.holder = r.support_forces[0]; };
  const auto summary = sim::run(problem, state, observer);
  EXPECT_EQ(summary.status, sim::RunStatus::done) << summary.reason;
  sim::Cache cache;
  const auto kept = sim::system_of(problem, state, cache);
  const auto& system = *kept;
  result.tables =
      sim::surface_records(system.contacts[0], state.solution.contacts[0], state.shapes, problem.contacts[0]);
  result.summary = summary.contacts[0];
  return result;
}

double integral(const sim::SurfaceRecord& s, const std::vector<double>& values) {
  double sum = 0.0;
  for (std::size_t i = 1; i < values.size(); ++i)
    sum += 0.5 * (s.arc_length_mm[i] - s.arc_length_mm[i - 1]) * (values[i] + values[i - 1]);
  return sum;
}

}  // namespace

// What is shown of the primary side must be what presses on it: nowhere below zero, without shear where there is no
// friction, and adding up to the force.
TEST(Tables, ThePrimarySideShowsWhatActs) {
  for (const char* size : {"0.2", "0.06", "0.03"}) {  // of the secondary side, against 0.06
    const auto run = pressed("", size);
    const auto& primary = run.tables[1];
    const double peak = *std::max_element(primary.pressure_MPa.begin(), primary.pressure_MPa.end());
    EXPECT_GT(peak, 1000.0);
    for (double p : primary.pressure_MPa) EXPECT_GE(p, 0.0) << size;
    for (double q : primary.shear_MPa) EXPECT_LE(std::abs(q), 1e-9 * peak) << size;
    EXPECT_NEAR(integral(primary, primary.pressure_MPa), 2000.0, 40.0) << size;
  }
}

// A contact without friction must report no tangential force; with friction what its supports feel.
TEST(Tables, TangentialForceIsAResultant) {
  const auto smooth = pressed("", "0.07");
  EXPECT_LT(std::abs(smooth.summary.tangential_force), 1e-9 * smooth.summary.normal_force);
  const auto rough = pressed("friction = 0.3", "0.07");
  EXPECT_NEAR(rough.summary.normal_force, 2000.0, 4.0);
  EXPECT_GT(std::abs(rough.holder.x()), 300.0);
  EXPECT_NEAR(std::abs(rough.summary.tangential_force), std::abs(rough.holder.x()), 0.02 * std::abs(rough.holder.x()));
}
