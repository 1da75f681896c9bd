#include <gtest/gtest.h>

#include "scene/solid/solid_scene.hpp"
#include "sim/solid/solid_march.hpp"
#include "sim/study/run.hpp"
#include "sim/study/solid_accuracy.hpp"
#include "sim/study/solid_discretisation.hpp"

using namespace reye;

namespace {

/// The ball that presses on a flat, without the rest of its scene; size 0: left to the accuracy.
scene::SolidScene pressed_ball(double size) {
  auto scene = scene::read_solid(std::string(REYE_SOURCE_DIR) + "/geo/ball_on_flat/scene.toml");
  for (auto& zone : scene.geometry.fine_zones) zone.size_mm = size;
  scene.steps.resize(1);
  scene.steps[0].increments = 1;
  scene.frames = {};
  scene.frames.paraview = false;
  scene.estimate_error = true;
  return scene;
}

struct Pressed {
  sim::SolidSummary summary;
  std::vector<sim::SkinRecord> surfaces;
};

Pressed pressed(const sim::SolidProblem& problem) {
  Pressed ball;
  sim::SolidObserver observer;
  observer.frame = [&](const sim::SolidFrame& frame) { ball.surfaces = frame.surfaces; };
  ball.summary = sim::run(problem, sim::initial_solid_state(problem), observer);
  return ball;
}

/// Of a mesh against one of a third of its size.
double true_error(const Pressed& ball, const Pressed& finest) {
  return sim::mesh_difference(finest.surfaces, ball.surfaces).traction.value();
}

Pressed finest_ball() {
  auto scene = pressed_ball(0.12);
  scene.estimate_error = false;
  return pressed(sim::prepare_solid(scene));
}

}  // namespace

// The estimated error of the mesh must be the true one of a ball's tractions within a factor of three, and `accuracy`
// must choose elements whose true error is at most what was asked for.
TEST(SolidMeshError, OfABallIsFoundAndKept) {
  const Pressed finest = finest_ball();
  ASSERT_FALSE(finest.summary.error_discretisation);  // nobody asked
  const Pressed ball = pressed(sim::prepare_solid(pressed_ball(0.36)));
  ASSERT_TRUE(ball.summary.error_discretisation);
  const double ratio = *ball.summary.error_discretisation / true_error(ball, finest);
  EXPECT_GE(ratio, 1.0 / 3.0);
  EXPECT_LE(ratio, 3.0);
  auto asked = pressed_ball(0.0);
  asked.accuracy = 0.2;
  const auto problem = sim::prepare(asked);
  EXPECT_GT(problem.scene.geometry.fine_zones[0].size_mm, 0.12);
  ASSERT_EQ(problem.decided.size(), 2u);
  EXPECT_LE(true_error(pressed(problem), finest), asked.accuracy);
}

// An accuracy that no mesh which fits can give must be refused where it is asked for, with what it would take.
TEST(SolidMeshError, OfTooLittleIsRefused) {
  auto asked = pressed_ball(0.0);
  asked.accuracy = 1e-4;
  try {
    sim::prepare(asked);
    FAIL();
  } catch (const base::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("more than 80 are not chosen; give the fine zones their size_mm"),
              std::string::npos)
        << error.what();
  }
}
