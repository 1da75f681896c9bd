#include "output/report/report.hpp"

#include <gtest/gtest.h>

#include "output/folder/files.hpp"
#include "output/folder/summary.hpp"
#include "output/report/figures.hpp"
#include "sample_run.hpp"
#include "support/texts.hpp"
#include "well_formed.hpp"

using namespace reye::output;
using reye::support::holds;
using sample::well_formed;

namespace {

std::string page_of(const std::string& dir) { return read_text((sample::fs::path(dir) / "report.html").string()); }

}  // namespace

// The page of a finished run is well-formed, holds every figure and section, and needs nothing from outside.
TEST(Report, IsWholeAndSelfContained) {
  sample::TemporaryFolder dir;
  sample::write_run(dir.str(), 40);
  const std::string page = page_of(dir.str());
  EXPECT_TRUE(well_formed(page));
  EXPECT_FALSE(well_formed(page.substr(0, page.size() / 2)));
  for (const char* id : {"profile-pad-secondary", "profile-pad-primary", "pressure-pad", "tractions-pad", "depth-pad",
                         "worn-pad", "energy", "forces"}) {
    EXPECT_TRUE(holds(page, "<figure id=\"" + std::string(id) + "\">")) << id;
    EXPECT_TRUE(well_formed(read_text(dir / ("figures/" + std::string(id) + ".svg")))) << id;
  }
  EXPECT_TRUE(well_formed(read_text(dir / "figures/overview-pad.svg")));
  EXPECT_TRUE(holds(page, "Contact pad: secondary side face, primary side round."));
  for (const char* section :
       {"Results", "Ledger", "The run", "Where the time went", "Skipped, and why", "Cut-backs, and why"})
    EXPECT_TRUE(holds(page, "<h2>" + std::string(section) + "</h2>")) << section;
  for (const char* outside : {"src=", "href=", "@import", "url(http"}) EXPECT_FALSE(holds(page, outside)) << outside;
}

// Text of the user is shown as text, not taken for markup.
TEST(Report, EscapesText) {
  sample::TemporaryFolder dir;
  sample::write_run(dir.str(), 4);
  EXPECT_TRUE(holds(page_of(dir.str()), "<h1>Cylinder on flat &lt;steel &amp; steel&gt;</h1>"));
}

// Warnings stand before every figure of a report, and there is no such section where there is none.
TEST(Report, WarningsComeFirst) {
  sample::TemporaryFolder dir;
  sample::write_run(dir.str(), 4);
  EXPECT_FALSE(holds(page_of(dir.str()), "<h2>Warnings</h2>"));
  auto summary = sample::summary();
  summary.warnings = {{"resolution", "contact pad", "2 elements touch & more.", 4.0}};
  atomic_write(dir / "summary.json", summary_json(summary));
  write_report(dir.str(), false);
  const std::string page = page_of(dir.str());
  EXPECT_TRUE(well_formed(page));
  EXPECT_TRUE(holds(page, "<li><strong>resolution, contact pad:</strong> 2 elements touch &amp; more.</li>"));
  EXPECT_LT(page.find("<h2>Warnings</h2>"), page.find("<h2>Results</h2>"));
}

// For each bond the page reports the largest tension and shear with their places, and for those at a free end that they
// grow with the mesh.
TEST(Report, BondsSayWhereTheyPull) {
  sample::TemporaryFolder dir;
  sample::write_run(dir.str(), 4);
  EXPECT_FALSE(holds(page_of(dir.str()), "largest of the run"));
  auto summary = sample::summary();
  reye::sim::BondTraction most;
  most.tension = {12.5, {1.0, 2.0}, 30.0, false};
  most.shear = {4.25, {3.0, 2.0}, 20.0, false};
  const auto page = [&] {
    summary.bonds = {{"glue & more", most, most}};
    atomic_write(dir / "summary.json", summary_json(summary));
    write_report(dir.str(), false);
    EXPECT_TRUE(well_formed(page_of(dir.str())));
    return page_of(dir.str());
  };
  const std::string inside = page();
  EXPECT_TRUE(holds(inside, "glue &amp; more, tension"));
  EXPECT_TRUE(holds(inside, "(1, 2), cycle 30<"));
  EXPECT_TRUE(holds(inside, ">4.25<"));
  EXPECT_FALSE(holds(inside, "grows as elements get shorter"));
  most.shear.at_end = true;
  const std::string outside = page();
  EXPECT_TRUE(holds(outside, "(3, 2), cycle 20, at the end of the bond<"));
  EXPECT_TRUE(holds(outside, "grows as elements get shorter"));
}

// A killed run without summary, with half a row in its tables, still gives a page that says so.
TEST(Report, WorksOnAKilledRun) {
  sample::TemporaryFolder dir;
  sample::write_run(dir.str(), 20);
  sample::fs::remove(dir / "summary.json");
  append_text(dir / "history.csv", "wear,12");
  append_text(dir / "surface_pad_secondary.csv", "18000,0.3,");
  write_report(dir.str());
  const std::string page = page_of(dir.str());
  EXPECT_TRUE(well_formed(page));
  EXPECT_TRUE(holds(page, "not finished"));
  EXPECT_TRUE(holds(page, "profile-pad-secondary"));
}

// A run that failed at once, without frames, gives a page with its reason and no figures.
TEST(Report, WorksWithoutFrames) {
  sample::TemporaryFolder dir;
  RunWriter writer(dir.str(), sample::scene());
  writer.begin();
  auto summary = sample::summary();
  summary.status = reye::sim::RunStatus::failed;
  summary.reason = "no convergence in step 'press'";
  summary.contacts.clear();
  writer.finish(summary);
  const std::string page = page_of(dir.str());
  EXPECT_TRUE(well_formed(page));
  EXPECT_TRUE(holds(page, "no convergence in step 'press'"));
  EXPECT_FALSE(holds(page, "<figure id"));
}

// Bodies remeshed stand in a table with what it cost, folded away when they are many; half a row is left out.
TEST(Report, TellsOfRemeshes) {
  sample::TemporaryFolder dir;
  RunWriter writer(dir.str(), sample::scene());
  writer.begin();
  writer.remesh(sample::remesh(1500.0));
  writer.remesh(sample::remesh(2500.0));
  write_report(dir.str());
  const std::string page = page_of(dir.str());
  EXPECT_TRUE(well_formed(page));
  EXPECT_TRUE(holds(page, "<details open=\"open\"><summary>Remeshed bodies: 2</summary>"));
  EXPECT_TRUE(holds(page,
                    "<tr><th>2500</th><td>pad, upper</td><td class=\"number\">120 → 135</td>"
                    "<td class=\"number\">1.2</td><td class=\"number\">0.033</td><td class=\"number\">0.04</td>"
                    "<td class=\"number\">0.01</td><td>worn at (0, 1) mm: 0.6 of the element below</td></tr>"));
  for (int k = 0; k < 20; ++k) writer.remesh(sample::remesh(3000.0 + k));
  append_text(dir / "remesh.csv", "wear,35");
  write_report(dir.str());
  EXPECT_FALSE(holds(page_of(dir.str()), "open=\"open\""));
}

// A run without remeshes says nothing of them.
TEST(Report, IsSilentWithoutRemeshes) {
  sample::TemporaryFolder dir;
  sample::write_run(dir.str(), 4);
  EXPECT_FALSE(holds(page_of(dir.str()), "remeshed"));
}

// A folder without a run is an error.
TEST(Report, RefusesAnEmptyFolder) {
  sample::TemporaryFolder dir;
  EXPECT_THROW(write_report(dir.str()), std::runtime_error);
}

// Figures left by an earlier, richer report are not taken for figures of this one.
TEST(Report, DropsFiguresOfFormerReports) {
  sample::TemporaryFolder dir;
  sample::write_run(dir.str(), 4);
  atomic_write(dir / "figures/depth-gone.svg", "<svg/>");
  write_report(dir.str());
  EXPECT_FALSE(sample::fs::exists(dir / "figures/depth-gone.svg"));
}

// The surface table falls into one set of rows per frame, also when two frames have the same cycle.
TEST(RunData, FramesOfOneCycleStayApart) {
  sample::TemporaryFolder dir;
  RunWriter writer(dir.str(), sample::scene());
  writer.begin();
  for (const double cycle : {0.0, 0.0, 5.0}) writer.frame(sample::frame(cycle, 4));
  const auto run = read_run(dir.str());
  ASSERT_EQ(run.contacts.size(), 1u);
  ASSERT_EQ(run.contacts[0].sides.size(), 2u);
  EXPECT_EQ(run.contacts[0].sides[0].frames.size(), 3u);
  EXPECT_EQ(run.contacts[0].sides[0].frames[1].end, 10u);
}

// With hundreds of remeshes the page lists the last two hundred and says how many there were.
TEST(Report, RemeshesShownAreBounded) {
  sample::TemporaryFolder dir;
  RunWriter writer(dir.str(), sample::scene());
  writer.begin();
  for (int k = 0; k < 250; ++k) writer.remesh(sample::remesh(1000.0 + k));
  write_report(dir.str());
  const std::string page = page_of(dir.str());
  EXPECT_TRUE(holds(page, "Remeshed bodies: 250, the last 200 of them"));
  EXPECT_FALSE(holds(page, "<th>1049</th>"));
  EXPECT_TRUE(holds(page, "<th>1050</th>"));
}
