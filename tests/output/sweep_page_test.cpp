#include "output/run/sweep_page.hpp"

#include <gtest/gtest.h>

#include "support/texts.hpp"
#include "well_formed.hpp"

using namespace reye;
using sample::well_formed;
using support::holds;
using support::times;

namespace {

output::SweepRow row(const std::string& member, std::vector<std::string> values, const std::string& life,
                     const std::string& depth) {
  return {member,
          std::move(values),
          {"done", "", "", {{"life_cycles.deep", life}, {"contacts.pad.secondary.max_depth_mm", depth}}}};
}

}  // namespace

// Each key has a figure of the life and one of the depth, with a line for each value of the other key; each member has
// a row that leads to its page.
TEST(SweepPage, ShowsEveryKeyAndMember) {
  const std::vector<output::SweepRow> rows{
      row("member_000", {"0.3", "1"}, "100", "0.001"), row("member_001", {"0.3", "2"}, "80", "0.001"),
      row("member_002", {"0.6", "1"}, "60", "0.001"), row("member_003", {"0.6", "2"}, "", "0.0005")};
  const auto page = output::sweep_page("Pins <and> plates", {"contact.pad.friction", "step[0].jump"}, rows);
  EXPECT_TRUE(well_formed(page));
  EXPECT_TRUE(holds(page, "Pins &lt;and&gt; plates"));
  EXPECT_EQ(times("<figure id=", page), 4u);
  EXPECT_EQ(times("<path ", page), 8u);
  EXPECT_TRUE(holds(page, "friction = 0.6"));
  for (const auto& member : rows) EXPECT_TRUE(holds(page, "href=\"" + member.member + "/report.html\""));
  EXPECT_TRUE(holds(page, "<li>limit deep: life 60.0000 to 100.000 cycles; not reached by 1 of 4 members</li>") ||
              holds(page, "<li>limit deep: life 60 to 100 cycles; not reached by 1 of 4 members</li>"));
}

// A key of words counts its values and says which is which; the reason of a failed member is shown.
TEST(SweepPage, KeysOfWords) {
  auto failed = row("member_001", {"quad"}, "", "");
  failed.end.status = "failed";
  failed.end.reason = "no state";
  const auto page = output::sweep_page("t", {"body.flat.mesh.element"}, {row("member_000", {"tri"}, "5", "1"), failed});
  EXPECT_TRUE(well_formed(page));
  EXPECT_TRUE(holds(page, "body.flat.mesh.element: 1 = tri, 2 = quad"));
  EXPECT_TRUE(holds(page, "failed: no state"));
}

// Values over powers of ten are drawn on their logarithms.
TEST(SweepPage, WideKeys) {
  const auto page =
      output::sweep_page("t", {"contact.pad.wear"}, {row("a", {"1e-6"}, "5", "1"), row("b", {"1e-3"}, "6", "1")});
  EXPECT_TRUE(holds(page, "log₁₀ of contact.pad.wear"));
}
