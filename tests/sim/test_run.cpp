#include <gtest/gtest.h>

#include "played.hpp"
#include "problem_of.hpp"
#include "sim/study/run.hpp"

using namespace reye;
using test::played;

namespace {

const char* const limits = R"([limit.reached]
contact  = "pad"
depth_mm = 1e-7
[limit.never]
contact  = "pad"
depth_mm = 1.0
)";

}  // namespace

// The plan must say what each body, contact and step is, and what is skipped.
TEST(Run, Plan) {
  const auto problem = test::problem_of(test::block_scene);
  EXPECT_EQ(
      problem.plan.lines,
      (std::vector<std::string>{
          "body slider: linear elastic, small strain, 8 quads, 23 dofs condensed to 13",
          "body base: linear elastic, small strain, 20 quads, 47 dofs condensed to 25",
          "contact pad: 5 secondary nodes on slider_bottom, 11 primary nodes, friction 0.3, wear by dissipated energy",
          "contact pad: its sides touch as drawn, at (1, 0) mm",
          "step \"press\": 1 increments, no wear",
          "step \"wear\": 40 cycles in blocks of 10, 8 increments a cycle",
      }));
  const auto detailed = test::problem_of(
      test::with(test::block_scene,
                 {{"friction  = 0.3", "friction = { cycles = [0, 20], value = [0.3, 0.5] }"},
                  {"law = \"energy\"",
                   "law = \"energy\", threshold_mJ_per_mm2 = 2.5, pressure_exponent = 0.5, pressure_ref_MPa = 10"}}));
  EXPECT_EQ(
      detailed.plan.lines[2],
      "contact pad: 5 secondary nodes on slider_bottom, 11 primary nodes, friction from 0.3 at cycle 0 to 0.5 at cycle "
      "20 (2 values), wear by dissipated energy beyond 2.5 mJ/mm^2 x (pressure / 10 MPa)^0.5");
  const std::string linear = " is linear: factorised once per shape, interior solved back only for frames";
  const std::string reach = "contact pad: nodes far from where it touches are condensed out until it comes near";
  const std::string waits = "contact pad: no shape step until its wear is a hundredth of a facet deep, or is shown";
  const std::string frames = "frames only of the start and of the end of each step: stress is recovered only there";
  EXPECT_EQ(problem.plan.skipped,
            (std::vector<std::string>{
                "body slider" + linear + " and, at most once a block, for the triggers of remeshing",
                "body base" + linear + " and, at most once a block, for the triggers of remeshing", reach, waits}));
  const auto off = test::problem_of(
      "shape = \"off\"\n" + test::with(test::block_scene, {{", primary_mm3_per_J = 2.0e-5", ""}}) + test::few_frames);
  EXPECT_EQ(off.plan.skipped,
            (std::vector<std::string>{
                "body slider" + linear, "body base" + linear, reach,
                "shape = \"off\": wear stays in the gap, no shape step", "contact pad: the primary side does not wear",
                "no boundary moves by wear and no reference may be renewed: no body is remeshed", frames}));
}

// A run must play all blocks, close its ledger, and end every block with a state from which it can resume.
TEST(Run, BlocksAndLedger) {
  const auto problem = test::problem_of(test::block_scene);
  std::vector<double> cycles;
  sim::Observer observer;
  observer.block = [&](const sim::State& s) { cycles.push_back(s.cycle); };
  const auto r = played(problem, observer);
  EXPECT_EQ(r.summary.status, sim::RunStatus::done) << r.summary.reason;
  EXPECT_EQ(cycles, (std::vector{0.0, 10.0, 20.0, 30.0, 40.0}));
  EXPECT_LT(r.summary.contacts[0].ledger_relative_error.value(), 1e-12);
  EXPECT_NEAR(r.summary.contacts[0].primary.worn_area / r.summary.contacts[0].secondary.worn_area, 2.0 / 3.0, 1e-9);
  EXPECT_EQ(r.summary.counts.blocks, 5);
}

// The life must be interpolated between the blocks in which the limit is crossed, and null where it is not.
TEST(Run, LifeIsInterpolated) {
  const auto text = std::string(test::block_scene) + limits;
  const auto problem = test::problem_of(text);
  std::vector<std::pair<double, double>> depth;  // of each block
  sim::Observer observer;
  observer.block = [&](const sim::State& s) { depth.emplace_back(s.cycle, s.limit_measure.at("reached")); };
  const auto r = played(problem, observer);
  ASSERT_EQ(r.summary.status, sim::RunStatus::done) << r.summary.reason;
  std::size_t k = 1;
  while (k < depth.size() && depth[k].second < 1e-7) ++k;
  ASSERT_LT(k, depth.size());
  const auto [c0, d0] = depth[k - 1];
  const auto [c1, d1] = depth[k];
  EXPECT_DOUBLE_EQ(r.summary.life_cycles.at("reached").value(), c0 + (c1 - c0) * (1e-7 - d0) / (d1 - d0));
  EXPECT_FALSE(r.summary.life_cycles.at("never"));
  EXPECT_EQ(r.summary.cycles, 40.0);
}

// A limit with stop = true must end the run where it is reached, after one cycle at the earliest.
TEST(Run, LimitStops) {
  const auto problem = test::problem_of(std::string(test::block_scene) +
                                        test::with(limits, {{"depth_mm = 1e-7", "depth_mm = 1e-9\nstop = true"}}));
  const auto r = played(problem);
  EXPECT_EQ(r.summary.status, sim::RunStatus::done);
  EXPECT_EQ(r.summary.cycles, 1.0);
}

// A run that fails must be a summary with its reason and the last accepted state, never an exception.
TEST(Run, FailureIsASummary) {
  const auto problem =
      test::problem_of(std::string(test::block_scene) + "[solver]\nmax_newton = 1\nmax_cutbacks = 0\n");
  int frames = 0;
  sim::Observer observer;
  observer.frame = [&](const sim::Frame&) { ++frames; };
  const auto r = played(problem, observer);
  EXPECT_EQ(r.summary.status, sim::RunStatus::failed);
  EXPECT_NE(r.summary.reason.find("no convergence in 1 iterations"), std::string::npos);
  EXPECT_EQ(frames, 1);  // the start is the last good state
  EXPECT_EQ(r.summary.contacts.size(), 1U);
}

// What an observer throws must end the run: a full disk is not a failed solve.
TEST(Run, ObserverMayThrow) {
  const auto problem = test::problem_of(test::block_scene);
  sim::Observer observer;
  observer.frame = [](const sim::Frame&) { throw std::runtime_error("disk full"); };
  EXPECT_THROW(played(problem, observer), std::runtime_error);
}

// Resuming from the state of a block's end, with nothing kept but that state, must change no bit.
TEST(Run, GoesOnFromAnyBlock) {
  const auto problem = test::problem_of(test::block_scene);
  std::vector<sim::State> ends;
  sim::Observer observer;
  observer.block = [&](const sim::State& s) { ends.push_back(s); };
  const auto whole = played(problem, observer);
  for (auto state : ends) {
    sim::run(problem, state, {});
    EXPECT_EQ(state.cycle, whole.state.cycle);
    EXPECT_EQ(state.solution.q.high, whole.state.solution.q.high);
    EXPECT_EQ(state.solution.q.low, whole.state.solution.q.low);
    EXPECT_EQ(state.solution.contacts[0].removed_secondary, whole.state.solution.contacts[0].removed_secondary);
  }
}
