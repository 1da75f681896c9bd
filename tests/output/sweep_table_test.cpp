#include <gtest/gtest.h>

#include "output/folder/files.hpp"
#include "output/folder/summary.hpp"
#include "output/run/sweep_table.hpp"
#include "sample_run.hpp"

using namespace reye;

namespace {

output::SweepRow row(const std::string& member, const std::string& value,
                     std::vector<std::pair<std::string, std::string>> figures) {
  return {member, {value}, {"done", "", "", std::move(figures)}};
}

}  // namespace

// A run that has ended reads back with every number of its summary, unknown ones empty; without a summary it is
// missing.
TEST(SweepTable, ReadsTheEnd) {
  const sample::TemporaryFolder folder;
  const auto dir = folder.str();
  output::atomic_write(dir + "/summary.json", output::summary_json(sample::summary()));
  const auto end = output::read_end(dir);
  EXPECT_EQ(end.status, "done");
  EXPECT_EQ(end.sha256, sample::scene().sha256);
  const std::map<std::string, std::string> figures(end.figures.begin(), end.figures.end());
  EXPECT_EQ(figures.size(), end.figures.size());
  EXPECT_EQ(figures.at("cycles"), "18000.0");
  EXPECT_EQ(figures.at("contacts.pad.secondary.max_depth_mm"), "0.0025");
  EXPECT_EQ(figures.at("contacts.pad.stick_half_width_mm"), "");
  EXPECT_EQ(figures.at("life_cycles.deep"), "17000.0");
  EXPECT_EQ(figures.at("counts.blocks"), "180");
  EXPECT_EQ(figures.at("warnings"), "0");
  EXPECT_EQ(end.figures.back().first, "peak_rss_MB");
  EXPECT_EQ(output::read_end(folder / "elsewhere").status, "missing");
}

// Every member is a row under the same heads, in the order of the summary; what it does not have stays empty, texts
// lose their TOML quotes.
TEST(SweepTable, RowsUnderTheSameHeads) {
  auto failed = row("member_001", "\"tri\"", {{"cycles", "2"}, {"wall_s", "1"}});
  failed.end.status = "failed";
  failed.end.reason = "first,\nsecond";
  EXPECT_EQ(output::sweep_table({"body.flat.mesh.element"},
                                {failed, row("member_002", "\"quad\"", {{"cycles", "3"}, {"p", ""}, {"wall_s", "4"}})}),
            "member,body.flat.mesh.element,status,reason,cycles,p,wall_s\n"
            "member_001,tri,failed,\"first, second\",2,,1\n"
            "member_002,quad,done,,3,,4\n");
}

// The life over all members runs from the shortest to the longest, bands included, and says who does not reach the
// limit.
TEST(SweepTable, LifeBands) {
  const auto banded = row("a", "1",
                          {{"life_cycles.deep", "100.0"},
                           {"life_cycles.wide", "50.0"},
                           {"life_band.deep.shortest_cycles", "25.0"},
                           {"life_band.deep.longest_cycles", "400.0"}});
  const auto plain = row("b", "2", {{"life_cycles.deep", "900.0"}, {"life_cycles.wide", ""}});
  EXPECT_EQ(output::life_bands({banded, plain}),
            (std::vector<std::string>{"limit deep: life 25 to 900 cycles",
                                      "limit wide: life 50 to 50 cycles; not reached by 1 of 2 members"}));
  EXPECT_TRUE(output::life_bands({row("a", "1", {{"cycles", "5"}})}).empty());
}
