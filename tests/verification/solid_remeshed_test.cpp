#include <gtest/gtest.h>

#include "support/solid_remeshed.hpp"

using namespace reye;

TEST(SolidRemeshed, PressureStays) {
  // Both bodies of a worn contact meshed again without wear, whose facets of the scar are still fit: volumes to
  // round-off, forces to the slope of the faces, and the pressure of rings within 3 % of its mean at each mesh.
  const auto result = support::remeshed_cap(4);
  for (const double jump : result.jumps) EXPECT_LE(jump, 0.03);
  EXPECT_LE(result.drift, 0.03);
  EXPECT_LE(result.volume_error, 1e-12);
  EXPECT_LE(result.force_error, 5e-4);
}

TEST(SolidRemeshed, ShearStays) {
  // A contact that slides keeps its tangential force, too: what sticks while the state is found again is held to where
  // its tractions put it.
  const auto result = support::remeshed_cap(2, 0.3);
  for (const double jump : result.jumps) EXPECT_LE(jump, 0.03);
  EXPECT_LE(result.shear_error, 0.01);
}

TEST(SolidRemeshed, AScarDrawnAgainKeepsItsPressure) {
  // A ball that is remeshed on its way, its scar drawn again, presses as before within 3 % of the mean, as the log
  // reports; without the gap carried it would not by half of it.
  const auto problem = sim::prepare_solid(support::ball_worn_for(100.0, 1.0));
  const std::string before = "pressures differ by ";
  std::vector<double> changes;
  sim::SolidObserver observer;
  observer.log = [&](const std::string& line) {
    if (const auto at = line.find(before); at != std::string::npos)
      changes.push_back(std::stod(line.substr(at + before.size())));
  };
  const auto summary = sim::run_solid(problem, observer);
  ASSERT_EQ(summary.status, sim::RunStatus::done) << summary.reason;
  EXPECT_GE(summary.counts.remeshes, 1);
  EXPECT_EQ(changes.size(), static_cast<std::size_t>(summary.counts.remeshes));
  for (const double percent : changes) EXPECT_LE(percent, 3.0);
}

TEST(SolidRemeshed, NeverWhereItMayNot) {
  // The ball of the scar drawn again, where it may not be remeshed, is worn without a fresh mesh, or ends with that
  // reason.
  auto scene = support::ball_worn_for(100.0, 1.0);
  scene.remesh.automatic = false;
  const auto summary = sim::run_solid(sim::prepare_solid(std::move(scene)), {});
  EXPECT_EQ(summary.counts.remeshes, 0);
  if (summary.status != sim::RunStatus::done) {
    EXPECT_NE(summary.reason.find("remesh.automatic is false"), std::string::npos) << summary.reason;
  }
}
