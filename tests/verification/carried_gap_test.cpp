#include "apps/scenes.hpp"
#include "verification/watched_remeshes.hpp"

using namespace reye;
using namespace reye::verification;

namespace {

/// A small pin worn flat, both bodies remeshed in every block, its fine zones outrun several times.
std::string worn_pin(Replacements words = {}) {
  std::ofstream(support::temporary_folder() + "wearing.geo") << test::wearing_geo;
  words.push_back({"size_mm = 0.015", "size_mm = 0.0075"});
  words.push_back({"cycles = 6", "cycles = 8"});
  return replaced(test::worn_pin, words);
}

void expect_carried(const Watched& w) {
  EXPECT_GE(w.remeshes.size(), 12U);
  EXPECT_LT(w.pressure_jump(), 0.02);
  for (const auto& r : w.remeshes) EXPECT_LT(r.peak_jump, 0.03);
  EXPECT_LT(w.depth_step, 0.005);
  EXPECT_LT(w.run.contact().ledger_relative_error.value(), 1e-9);
}

}  // namespace

// A pin worn flat, conforming to its plate within the elastic approach, must keep its pressure over every remesh of
// both bodies, its depth and its ledger.
TEST(CarriedGap, WornPin) { expect_carried(watched(worn_pin())); }

// The worn pin must keep its pressure in second order.
TEST(CarriedGap, SecondOrder) { expect_carried(watched(worn_pin({{"mesh     = {", "order    = 2\nmesh     = {"}}))); }

// The worn pin must keep its pressure on triangles.
TEST(CarriedGap, Triangles) {
  expect_carried(watched(worn_pin({{"growth = 1.8", "growth = 1.8, element = \"tri\""}})));
}

// The worn pin must keep its pressure where only the primary wears, with facets of its own size.
TEST(CarriedGap, PrimaryAlone) {
  expect_carried(
      watched(worn_pin({{"secondary = \"round\"", "secondary = \"face\""},
                        {"primary   = [\"face\"]", "primary   = [\"round\"]"},
                        {"secondary_mm3_per_J = 1.0e-4, primary_mm3_per_J = 1.0e-5", "primary_mm3_per_J = 1.0e-4"},
                        {"half_width_mm = 0.15", "half_width_mm = 0.3"}})));
}

// A ball worn into its cup, where the motion that costs no pressure is along the axis alone and goes far beside the
// elastic approach, must keep its pressure, too.
TEST(CarriedGap, BallInCup) {
  const auto w = watched(scene_text("ball_in_cup"));
  EXPECT_GE(w.remeshes.size(), 3U);
  EXPECT_LT(w.pressure_jump(), 0.02);
  for (const auto& r : w.remeshes) EXPECT_LT(r.peak_jump, 0.03);
  EXPECT_LT(w.run.contact().ledger_relative_error.value(), 1e-9);
}
