#include <cmath>

#include "sim/problem/records.hpp"
#include "wear_scene.hpp"

/// A fretting cycle of elastic bodies in gross slip: where the energy comes from and where it goes.
namespace reye::verification {

namespace {

/// The published fretting contact on a coarser mesh: pressed, run in for one cycle, then one more.
Replacements short_fretting(int increments, const std::string& last_step) {
  return {
      {"half_width_mm = 0.5, depth_mm = 0.2, size_mm = 0.010", "half_width_mm = 0.1, depth_mm = 0.1, size_mm = 0.008"},
      {"increments = 40", "increments = " + std::to_string(increments)},
      {"cycles = 18000\njump = 100", last_step}};
}

const std::string fretting_law =
    "wear      = { law = \"energy\", secondary_mm3_per_J = 3.2222222222e-5, primary_mm3_per_J = 2.1111111111e-5 }";
const std::string life_limit =
    "[limit.life]                                 # the first cycle at which it is reached; the run continues unless "
    "stop = true\n"
    "contact  = \"pad\"\nside     = \"secondary\"\ndepth_mm = 0.0025\n";

Played without_wear(int increments) {
  auto r = short_fretting(increments, "");
  r.push_back({fretting_law, ""});
  r.push_back({life_limit, ""});
  return played(scene_text("fretting_mccoll", r));
}

/// Records of the last step, headed by the one before it.
std::vector<sim::IncrementRecord> last_cycle(const Played& run) {
  std::size_t first = 0;
  while (run.records[first].step != "wear") ++first;
  return {run.records.begin() + static_cast<std::ptrdiff_t>(first) - 1, run.records.end()};
}

double stroke(double progress) {
  return 0.025 * (progress <= 0.25 ? 4.0 * progress : progress <= 0.75 ? 2.0 - 4.0 * progress : 4.0 * progress - 4.0);
}

/// Work of the shaker over the last cycle, trapezoid of its force; the holder's force is constant and returns.
double work_of_supports(const Played& run) {
  const auto cycle = last_cycle(run);
  double work = 0.0;
  for (std::size_t i = 1; i < cycle.size(); ++i) {
    const double from = i == 1 ? 0.0 : cycle[i - 1].progress;
    work += 0.5 * (cycle[i].support_forces[1].x() + cycle[i - 1].support_forces[1].x()) *
            (stroke(cycle[i].progress) - stroke(from));
  }
  return work;
}

double dissipated(const Played& run) {
  const auto cycle = last_cycle(run);
  return cycle.back().energy_mJ - cycle.front().energy_mJ;
}

/// Largest difference of two sets of multipliers, in parts of the largest.
double difference(const Played& a, const Played& b) {
  const auto &la = a.state.solution.contacts[0].lambda, &lb = b.state.solution.contacts[0].lambda;
  double most = 0.0, largest = 0.0;
  for (std::size_t j = 0; j < la.size(); ++j) {
    most = std::max(most, (la[j] - lb[j]).norm());
    largest = std::max(largest, la[j].norm());
  }
  return most / largest;
}

}  // namespace

/// Over a closed cycle the work of the supports is the frictional work; the gap falls at first order or faster.
TEST(WearCycle, EnergyCloses) {
  std::vector<double> gap;
  for (int increments : {40, 80, 160}) {
    const Played run = without_wear(increments);
    gap.push_back(std::abs(work_of_supports(run) / dissipated(run) - 1.0));
  }
  EXPECT_LT(gap[0], 0.03);
  EXPECT_LT(gap[2], 0.005);
  EXPECT_GT(std::log2(gap[0] / gap[1]), 0.8);
  EXPECT_GT(std::log2(gap[1] / gap[2]), 0.8);
}

/// A wear coefficient that vanishes leaves the run without wear.
TEST(WearCycle, VanishingWear) {
  auto r = short_fretting(20, "cycles = 2");
  r.push_back({life_limit, ""});
  r.push_back({"secondary_mm3_per_J = 3.2222222222e-5, primary_mm3_per_J = 2.1111111111e-5",
               "secondary_mm3_per_J = 1e-18, primary_mm3_per_J = 1e-18"});
  const Played faint = played(scene_text("fretting_mccoll", r));
  const Played none = played(
      replaced(scene_text("fretting_mccoll", r),
               {{"wear      = { law = \"energy\", secondary_mm3_per_J = 1e-18, primary_mm3_per_J = 1e-18 }", ""}}));
  EXPECT_LT(difference(faint, none), 1e-8);
}

/// Both sides of a fretting contact lose exactly coefficient x energy, through the motion of the shape.
TEST(WearCycle, BookOfBothSides) {
  auto r = short_fretting(20, "cycles = 300\njump = 100");
  r.push_back({life_limit, ""});
  const Played run = played(scene_text("fretting_mccoll", r));
  const auto& c = run.contact();
  EXPECT_LT(c.ledger_relative_error.value(), 1e-9);
  EXPECT_NEAR(c.secondary.worn_area / (3.2222222222e-8 * c.dissipated_energy), 1.0, 1e-9);
  EXPECT_NEAR(c.primary.worn_area / (2.1111111111e-8 * c.dissipated_energy), 1.0, 1e-9);
}

/// In full slip Archard's law with k = alpha mu wears as the energy law does.
TEST(WearCycle, ArchardAgreesWithEnergy) {
  auto r = short_fretting(20, "cycles = 200\njump = 100");
  r.push_back({life_limit, ""});
  const Played energy = played(scene_text("fretting_mccoll", r));
  r.push_back({"law = \"energy\", secondary_mm3_per_J = 3.2222222222e-5, primary_mm3_per_J = 2.1111111111e-5",
               "law = \"archard\", secondary_per_MPa = 2.9e-8, primary_per_MPa = 1.9e-8"});
  const Played archard = played(scene_text("fretting_mccoll", r));
  EXPECT_NEAR(archard.contact().secondary.worn_area / energy.contact().secondary.worn_area, 1.0, 1e-9);
  EXPECT_NEAR(archard.contact().secondary.max_depth_mm / energy.contact().secondary.max_depth_mm, 1.0, 1e-9);
}

}  // namespace reye::verification
