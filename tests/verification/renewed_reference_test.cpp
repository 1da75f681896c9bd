#include <map>

#include "mesh/measure.hpp"
#include "verification/wear_scene.hpp"

using namespace reye;
using namespace reye::verification;

namespace {

/// Force of the die over the progress of the press.
std::map<double, double> force_curve(const Played& run, int die) {
  std::map<double, double> curve;
  for (const auto& r : run.records) curve[r.progress] = -r.support_forces[die].y();
  return curve;
}

struct Difference {
  double root_mean_square = 0.0, work = 0.0;  ///< both relative to the first curve
};

/// Over the ends of increments that both runs have: all planned ones.
Difference between(const std::map<double, double>& a, const std::map<double, double>& b) {
  double squares = 0.0, all_squares = 0.0, sum = 0.0, all = 0.0;
  int common = 0;
  for (const auto& [progress, force] : a) {
    const auto other = b.find(progress);
    if (other == b.end()) continue;
    ++common;
    const double difference = other->second - force;
    squares += difference * difference;
    all_squares += force * force;
    sum += difference;
    all += force;
  }
  EXPECT_GE(common, 40);
  return {std::sqrt(squares / all_squares), sum / all};
}

}  // namespace

// A billet upset to 60 % of its height, its mesh renewed on the way on the deformed shape, must need the force and the
// work of a run on one mesh within 1 %; every renewal says that deformation asked for it.
TEST(RenewedReference, UpsettingForce) {
  const auto run = played(scene_text("upsetting_remesh"));
  const auto plain = played(scene_text("upsetting_remesh", {{"[remesh]", "[remesh]\nautomatic = false"}}));
  EXPECT_GE(run.summary.counts.remeshes, 2);
  EXPECT_EQ(plain.summary.counts.remeshes, 0);
  const auto d = between(force_curve(plain, 2), force_curve(run, 2));
  EXPECT_LT(d.root_mean_square, 0.01);
  EXPECT_LT(std::abs(d.work), 0.005);
  // X is the shape of the last renewal, whose volume plasticity has kept but for the elastic part.
  const auto volume = [](const mesh::Mesh& mesh) {
    double sum = 0.0;
    for (const auto& cell : mesh.cells) sum += mesh::cell_area(mesh.X, mesh.kind, cell);
    return sum;
  };
  EXPECT_NEAR(volume(run.state.shapes[0]->mesh) / volume(run.problem.shapes[0]->mesh), 1.0, 0.01);
  EXPECT_EQ(run.state.solution.interiors[0].F0.size(), run.state.solution.interiors[0].history.size());
}

// Probes and frames must count from the start whatever was renewed on the way: a point of the barrel moves as in a run
// on one mesh within 1 %, and what a frame shows as unstressed is the billet as it was drawn.
TEST(RenewedReference, ProbesCountFromTheStart) {
  const std::pair<std::string, std::string> probes{
      "[output]", "[output]\nprobes = { barrel = { body = \"billet\", at_mm = [10.0, 3.0] } }"};
  const auto run = played(scene_text("upsetting_remesh", {probes}));
  const auto plain = played(scene_text("upsetting_remesh", {probes, {"[remesh]", "[remesh]\nautomatic = false"}}));
  EXPECT_GE(run.summary.counts.remeshes, 2);
  const auto u = run.summary.probes.at("barrel"), expected = plain.summary.probes.at("barrel");
  EXPECT_GT(expected.norm(), 2.0);
  EXPECT_LT((u - expected).norm(), 0.01 * expected.norm());
  double low = 1e300, high = 0.0;
  for (const auto& x : run.frame.bodies.at(0).mesh->X) {
    low = std::min(low, x.y());
    high = std::max(high, x.y());
  }
  EXPECT_NEAR(high - low, 15.0, 0.02);
}

// A support that moves the renewed body itself must continue from where it was: the billet pushed against a fixed die
// needs the force of the die pushed against the billet.
TEST(RenewedReference, MovedSupportsGoOn) {
  const auto die = played(scene_text("upsetting_remesh"));
  const auto billet = played(scene_text(
      "upsetting_remesh", {{"y    = \"fixed\"", "y    = { motion_mm = 6.0, history = \"press\" }"},
                           {"y        = { motion_mm = -6.0, history = \"press\" }", "y        = \"fixed\""}}));
  EXPECT_GE(billet.summary.counts.remeshes, 2);
  const auto d = between(force_curve(die, 2), force_curve(billet, 2));
  EXPECT_LT(d.root_mean_square, 0.01);
  EXPECT_LT(std::abs(d.work), 0.005);
}
