#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "mesh/measure.hpp"
#include "sim/march/block.hpp"
#include "sim/measure/measure.hpp"
#include "sim/measure/surfaces.hpp"
#include "sim/study/run.hpp"
#include "support/problem.hpp"
#include "support/scene_words.hpp"

using namespace reye;

namespace {

const char* const two_sliders_geo = R"(SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 6, 2};
Rectangle(2) = {0.5, 2, 0, 2, 1};
Rectangle(3) = {3.5, 2, 0, 2, 1};
Physical Surface("base") = {1};
Physical Surface("left") = {2};
Physical Surface("right") = {3};
Physical Curve("base_bottom") = {1};
Physical Curve("base_top") = {3};
Physical Curve("left_bottom") = {5};
Physical Curve("left_top") = {7};
Physical Curve("right_bottom") = {9};
Physical Curve("right_top") = {11};
)";

/// Two blocks on one, pressed by 40 and 20 N/mm and dragged; the right one is meshed finer.
const std::string two_sliders =
    "geometry = [\"blocks.geo\"]\n" +
    support::steel_bodies(
        {{"base", "far_size_mm = 0.5"}, {"left", "far_size_mm = 0.5"}, {"right", "far_size_mm = 0.2"}}) +
    R"([contact.pair]
secondary = "base_top"
primary = ["right_bottom", "left_bottom"]
friction = 0.3
wear = { law = "energy", secondary_mm3_per_J = 1e-4, primary_mm3_per_J = 3e-4 }
[support.floor]
edge = "base_bottom"
x = "fixed"
y = "fixed"
[support.left]
edge = "left_top"
x = { motion_mm = 0.02, history = "drag" }
y = { force_N_per_mm = -40.0, history = "press" }
rotation = "fixed"
[support.right]
edge = "right_top"
x = { motion_mm = 0.02, history = "drag" }
y = { force_N_per_mm = -20.0, history = "press" }
rotation = "fixed"
[history]
press = [[0, 0], [1, 1]]
drag = [[0, 0], [0.5, 1], [1, 0]]
[remesh]
every_blocks = 2
[[step]]
name = "press"
play = ["press"]
increments = 2
wear = false
[[step]]
name = "wear"
play = ["drag"]
increments = 4
cycles = 40
jump = 10
)";

double area_of(const body::ShapePtr& shape) { return mesh::area(shape->mesh); }

}  // namespace

// A primary side on two bodies must carry each body's own force, lose each body's own volume, and name its nodes by
// body.
TEST(TwoPrimaries, EachBodyGetsItsOwn) {
  const auto problem = support::problem_from({{"blocks.geo", two_sliders_geo}, {"scene.toml", two_sliders}});
  auto state = sim::initial_state(problem);
  std::vector<sim::IncrementRecord> rows;
  sim::Observer observer;
  observer.increment = [&](const sim::IncrementRecord& r) { rows.push_back(r); };
  const auto summary = sim::run(problem, state, observer);
  ASSERT_EQ(summary.status, sim::RunStatus::done) << summary.reason;
  EXPECT_GE(summary.counts.remeshes, 4);
  EXPECT_LT(summary.contacts[0].ledger_relative_error.value(),
            1e-10);  // strips of nanometres, measured on coordinates of millimetres
  EXPECT_NEAR(summary.contacts[0].normal_force, 60.0, 0.02);
  for (const auto& row : rows) {
    base::Vec2 sum = base::Vec2::Zero();
    for (const auto& force : row.support_forces) sum += force;
    EXPECT_LT(sum.norm(), 1e-8);
  }

  sim::Cache cache;
  const auto kept = sim::system_of(problem, state, cache);
  const auto& system = *kept;
  const auto& setup = system.contacts[0];
  const auto& contact = state.solution.contacts[0];
  std::vector<double> booked(3, 0.0);
  for (int l = 0; l < setup.primary_count(); ++l) booked[setup.primary_nodes[l].body] += contact.removed_primary[l];
  booked[0] = std::accumulate(contact.removed_secondary.begin(), contact.removed_secondary.end(), 0.0);
  EXPECT_NEAR(booked[1] / booked[2], 2.0, 0.02);  // equal ways at twice the force
  // Depths measured on the shape, times lengths on it: to the digits that coordinates have.
  EXPECT_NEAR(booked[1] + booked[2], 3.0 * booked[0], 1e-9 * booked[0]);
  for (int b = 0; b < 3; ++b) EXPECT_NEAR(area_of(problem.shapes[b]) - area_of(state.shapes[b]), booked[b], 1e-12) << b;

  const auto primary = sim::surface_records(setup, contact, state.shapes, problem.contacts[0])[1];
  std::vector<double> carried(3, 0.0);
  for (std::size_t i = 0; i < primary.node.size(); ++i) {
    EXPECT_EQ(state.shapes[primary.body[i]]->mesh.X[primary.node[i]], base::Vec2(primary.x_mm[i], primary.y_mm[i]));
    EXPECT_EQ(primary.body[i], primary.x_mm[i] < 3.0 ? 1 : 2);
    if (i == 0) continue;
    const double step = primary.arc_length_mm[i] - primary.arc_length_mm[i - 1];
    EXPECT_GE(step, 0.0);
    EXPECT_EQ(step == 0.0, primary.body[i] != primary.body[i - 1]);
    carried[primary.body[i]] += 0.5 * step * (primary.pressure_MPa[i] + primary.pressure_MPa[i - 1]);
  }
  EXPECT_NEAR(carried[1], 40.0, 0.4);
  EXPECT_NEAR(carried[2], 20.0, 0.2);
}

// Everything that a run writes and shows must be there for a side on two bodies.
TEST(TwoPrimaries, Frames) {
  const auto problem = support::problem_from({{"blocks.geo", two_sliders_geo}, {"scene.toml", two_sliders}});
  auto state = sim::initial_state(problem);
  std::vector<sim::Frame> frames;
  sim::Observer observer;
  observer.frame = [&](const sim::Frame& frame) { frames.push_back(frame); };
  ASSERT_EQ(sim::run(problem, state, observer).status, sim::RunStatus::done);
  ASSERT_GE(frames.size(), 2U);
  for (const auto& frame : frames)
    for (const auto& surface : frame.surfaces)
      for (std::size_t i = 0; i < surface.node.size(); ++i)
        EXPECT_LT(surface.node[i], frame.bodies[surface.body[i]].mesh->node_count());
  for (int b : {1, 2})
    EXPECT_GT(
        *std::max_element(frames.back().bodies[b].wear_depth_mm.begin(), frames.back().bodies[b].wear_depth_mm.end()),
        0.0);
}
