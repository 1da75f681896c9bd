#include "output/solid/solid_report.hpp"

#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "sample_run.hpp"
#include "solid_sample.hpp"
#include "support/texts.hpp"
#include "well_formed.hpp"

using namespace reye::output;
using reye::support::holds;
using solid_sample::text;

// The page of a finished run is well-formed, holds every map, profile, figure and section, and needs nothing from
// outside nor any script.
TEST(SolidReport, IsWholeAndSelfContained) {
  const reye::support::TemporaryFolder dir;
  solid_sample::write_run(dir.str());
  const std::string page = text(dir.str(), "report.html");
  EXPECT_TRUE(sample::well_formed(page));
  EXPECT_LT(page.size(), 3000000u);
  for (const char* id : {"scene", "map-pressure-pad", "map-shear-pad", "map-slip-pad", "map-status-pad",
                         "profile-pad-1", "profile-pad-2", "map-depth-pad", "history-pressure", "history-force",
                         "history-area", "history-energy", "supports", "loop-1"})
    EXPECT_TRUE(holds(page, "<figure id=\"" + std::string(id) + "\">")) << id;
  for (const char* section : {"Results", "Maps of the contact", "The run over its steps", "What went in", "The run",
                              "Its size", "Where the time went", "Warnings", "Scene"})
    EXPECT_TRUE(holds(page, "<h2>" + std::string(section) + "</h2>")) << section;
  for (const char* outside : {"src=", "href=", "@import", "url(http", "<script"})
    EXPECT_FALSE(holds(page, outside)) << outside;
  EXPECT_TRUE(sample::well_formed(text(dir.str(), "figures/map-pressure-pad.svg")));
}

// Names of the user are shown as text, and every number of the tables is there; nothing is printed as nan.
TEST(SolidReport, ShowsInputsAndResults) {
  const reye::support::TemporaryFolder dir;
  solid_sample::write_run(dir.str());
  const std::string page = text(dir.str(), "report.html");
  for (const char* shown :
       {"<h1>Block &lt;on&gt; block</h1>", "pin &amp; co", "steel, E 210000 MPa, nu 0.3", "x, y, z fixed",
        "x 0.02 mm × slide, z -100 N × press; as one rigid face", "pressure 3 MPa", "stick, 0.5 mm²", "slip, 0.5 mm²",
        "2 facets touch &amp; more.", "3 s (75 %)", "1 · 10⁻¹⁴", "analysis = &quot;solid&quot;", "solids in three"})
    EXPECT_TRUE(holds(page, shown)) << shown;
  for (const char* never : {">nan", " nan", ">inf", "-nan"}) EXPECT_FALSE(holds(page, never)) << never;
}

// A run that was killed has a page of what is on disk, which says that it is not finished.
TEST(SolidReport, OfAKilledRun) {
  const reye::support::TemporaryFolder dir;
  solid_sample::write_run(dir.str(), solid_sample::scene(), false);
  append_text(dir / "history.csv", "rub,1,0.5");  // half a row
  write_solid_report(dir.str());
  const std::string page = text(dir.str(), "report.html");
  EXPECT_TRUE(sample::well_formed(page));
  EXPECT_TRUE(holds(page, "not finished"));
  EXPECT_TRUE(holds(page, "<figure id=\"map-pressure-pad\">"));
}

// A run in which nothing touched, or nothing was written yet, has a page without maps.
TEST(SolidReport, WithoutContact) {
  const reye::support::TemporaryFolder dir;
  SolidRunWriter writer(dir.str(), solid_sample::scene());
  writer.begin();
  write_solid_report(dir.str());
  EXPECT_TRUE(sample::well_formed(text(dir.str(), "report.html")));
  auto frame = solid_sample::frame(0.0, 0.0);
  for (auto& skin : frame.surfaces) {
    skin.status.assign(skin.status.size(), 0);
    skin.wear_depth_mm.assign(skin.status.size(), 0.0);
  }
  writer.frame(frame);
  auto summary = solid_sample::summary();
  summary.status = reye::sim::RunStatus::failed;
  summary.reason = "bodies part";
  writer.finish(summary);
  const std::string page = text(dir.str(), "report.html");
  EXPECT_TRUE(sample::well_formed(page));
  EXPECT_TRUE(holds(page, "No frame shows this contact under pressure."));
  EXPECT_TRUE(holds(page, "bodies part"));
}

// Where the tangential force was larger before, the maps show that frame, too.
TEST(SolidReport, ShowsTheFrameOfLargestTangentialForce) {
  const reye::support::TemporaryFolder dir;
  SolidRunWriter writer(dir.str(), solid_sample::scene());
  writer.begin();
  auto hard = solid_sample::frame(0.25);
  for (auto& skin : hard.surfaces)
    for (auto& t : skin.shear_MPa) t *= 3.0;
  writer.increment(solid_sample::increment("rub", 0.25, 0.25));
  writer.frame(hard);
  writer.frame(solid_sample::frame(1.0));
  write_solid_report(dir.str());
  const std::string page = text(dir.str(), "report.html");
  EXPECT_TRUE(holds(page, "<figure id=\"map-shear-pad-most\">"));
  EXPECT_TRUE(holds(page, "shear, frame 0, cycle 0.25, largest shear force"));
}

// A contact without friction has a map of its pressure alone.
TEST(SolidReport, WithoutFriction) {
  const reye::support::TemporaryFolder dir;
  auto scene = solid_sample::scene();
  scene.contacts[0].friction = 0.0;
  solid_sample::write_run(dir.str(), scene);
  const std::string page = text(dir.str(), "report.html");
  EXPECT_TRUE(holds(page, "<figure id=\"map-pressure-pad\">"));
  EXPECT_FALSE(holds(page, "<figure id=\"map-slip-pad\">"));
}

// Files that are damaged or missing are refused with their names; so are folders of the plane and of nothing.
TEST(SolidReport, DamageIsRefused) {
  for (const char* file : {"summary.json", "inputs.json", "history.csv", "frames/surface_000001.vtp"}) {
    const reye::support::TemporaryFolder dir;
    solid_sample::write_run(dir.str());
    const std::string whole = text(dir.str(), file);
    replace_text(dir / file, whole.substr(0, whole.size() / 2));
    try {
      write_solid_report(dir.str());
      ADD_FAILURE() << file << " was taken for whole";
    } catch (const reye::base::InputError& error) {
      EXPECT_TRUE(holds(error.what(), file)) << error.what();
    }
  }
  const reye::support::TemporaryFolder plane, empty;
  sample::write_run(plane.str(), 4);
  EXPECT_THROW(write_solid_report(plane.str()), reye::base::InputError);
  EXPECT_THROW(write_solid_report(empty.str()), reye::base::InputError);
}

// With moving pictures the page has pressure and depth over the frames; without, it has none.
TEST(SolidReport, Moving) {
  const reye::support::TemporaryFolder dir;
  solid_sample::write_run(dir.str());
  for (const bool moves : {true, false}) {
    write_solid_report(dir.str(), moves);
    const std::string page = text(dir.str(), "report.html");
    EXPECT_TRUE(sample::well_formed(page));
    for (const char* id : {"moving-pressure-pad", "moving-depth-pad"})
      EXPECT_EQ(holds(page, "<figure id=\"" + std::string(id) + "\">"), moves) << id;
  }
}
