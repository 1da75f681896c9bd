#include <gtest/gtest.h>

#include "scene/solid/solid_scene.hpp"
#include "sim/study/run.hpp"
#include "sim/study/solid_discretisation.hpp"

using namespace reye;

namespace {

struct Fretted {
  sim::SolidSummary summary;
  std::vector<sim::SkinRecord> surfaces;
};

/// The ball that frets on a flat, for 3000 cycles, with elements of a size in its fine zone.
Fretted fretted(double size, bool estimate) {
  auto scene = scene::read_solid(std::string(REYE_SOURCE_DIR) + "/geo/ball_on_flat_fretting/scene.toml");
  const double coarser = size / scene.geometry.fine_zones[0].size_mm;
  scene.geometry.fine_zones[0].size_mm = size;
  for (auto& body : scene.geometry.bodies) body.mesh.far_size_mm *= coarser;
  scene.steps[1].cycles = 3000.0;
  scene.steps[1].jump_tolerance = 0.02;
  scene.limits.clear();
  scene.frames.paraview = false;
  scene.estimate_error = estimate;
  const auto problem = sim::prepare_solid(scene);
  Fretted ball;
  sim::SolidObserver observer;
  observer.frame = [&](const sim::SolidFrame& frame) { ball.surfaces = frame.surfaces; };
  ball.summary = sim::run(problem, sim::initial_solid_state(problem), observer);
  return ball;
}

}  // namespace

// The estimated error of a worn ball's profiles must be the true one, against elements of half the size, within a
// factor of three.
TEST(SolidMeshError, OfAWornBallIsFound) {
  const Fretted coarse = fretted(0.6, true), fine = fretted(0.3, false);
  ASSERT_TRUE(coarse.summary.error_discretisation);
  const auto apart = sim::mesh_difference(fine.surfaces, coarse.surfaces);
  ASSERT_TRUE(apart.wear);
  RecordProperty("estimate", std::to_string(*coarse.summary.error_discretisation));
  RecordProperty("difference", std::to_string(*apart.wear));
  const double ratio = *coarse.summary.error_discretisation / *apart.wear;
  EXPECT_GE(ratio, 1.0 / 3.0) << *apart.wear;
  EXPECT_LE(ratio, 3.0) << *apart.wear;
}
