#include <sstream>

#include "solid_scenes.hpp"

using namespace reye;

namespace {

/// The cells of a table by heading, a column each; no cell holds a comma here.
std::map<std::string, std::vector<std::string>> columns_of(const test::fs::path& file) {
  std::map<std::string, std::vector<std::string>> columns;
  std::vector<std::string> head;
  std::istringstream text(test::read(file));
  for (std::string line; std::getline(text, line);) {
    std::istringstream cells(line);
    std::size_t k = 0;
    for (std::string cell; std::getline(cells, cell, ','); ++k)
      if (columns.size() <= k && head.size() <= k)
        head.push_back(cell);
      else
        columns[head.at(k)].push_back(cell);
  }
  return columns;
}

std::vector<std::string> sweep_into(const std::string& folder) {
  return {"sweep",   "rubbing.toml",
          "--vary",  "contact.pad.friction=0.2,0.3",
          "--vary",  "support.holder.z.force_N=-40",
          "--jobs",  "1",
          "--quiet", "--out",
          folder};
}

}  // namespace

// A sweep of solids that is interrupted must stop its member after the increment and end with 130; called again it must
// resume to the table of an unbroken one, with pressure, area, forces and energy of each member, and a page of them.
TEST(SolidSweep, InterruptedAndResumed) {
  const test::WithRubbing place;
  auto running = place.start_reye(sweep_into("broken"));
  ASSERT_TRUE(running.signal_when(SIGINT, [&] { return test::lines(place / "broken/member_000/history.csv") > 12; }));
  EXPECT_EQ(running.wait().code, 130);
  EXPECT_TRUE(test::holds(test::read(place / "broken/member_000/summary.json"), R"("status": "interrupted")"));
  const auto resumed = place.reye(sweep_into("broken"));
  ASSERT_EQ(resumed.code, 0) << resumed.err;
  ASSERT_EQ(place.reye(sweep_into("whole")).code, 0);
  auto broken = columns_of(place / "broken/sweep.csv"), whole = columns_of(place / "whole/sweep.csv");
  for (auto* table : {&broken, &whole})
    for (const char* time : {"wall_s", "cpu_s", "peak_rss_MB"}) EXPECT_EQ(table->erase(time), 1u);
  EXPECT_EQ(broken, whole);
  for (const char* quantity : {"peak_pressure_MPa", "contact_area_mm2", "equivalent_radius_mm", "half_widths_mm[0]",
                               "tangential_force_N", "dissipated_energy_mJ"})
    EXPECT_EQ(whole.at(std::string("contacts.pad.") + quantity).size(), 2u) << quantity;
  for (const auto& force : whole.at("contacts.pad.normal_force_N")) EXPECT_NEAR(std::stod(force), 40.0, 0.1);
  const auto page = test::read(place / "whole/sweep.html");
  for (const char* title : {"Largest pressure, pad", "Area in contact, pad", "Energy dissipated, pad"})
    EXPECT_TRUE(test::holds(page, title)) << title;
}

// Values that solids do not take must be refused before anything is written, with the rule of their scenes.
TEST(SolidSweep, BadInput) {
  const test::WithRubbing place;
  const auto before = place.files();
  const auto refused = [&](const std::string& variation) {
    const auto answer = place.reye({"sweep", "rubbing.toml", "--vary", variation});
    EXPECT_EQ(answer.code, 2);
    return answer.err;
  };
  EXPECT_EQ(refused("contact.pad.frction=0.1"),
            "--vary = contact.pad.frction=0.1: unknown key; did you mean friction?\n");
  EXPECT_EQ(refused("accuracy=0.3"), "member_000: accuracy = 0.3: must lie in (0, 0.2]\n");
  EXPECT_EQ(place.files(), before);
}
