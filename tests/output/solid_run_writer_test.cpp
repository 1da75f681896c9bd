#include "output/solid/solid_run_writer.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "output/report/run_data.hpp"
#include "solid_sample.hpp"
#include "support/texts.hpp"
#include "well_formed.hpp"

using namespace reye::output;
using reye::support::holds;
using reye::support::without_report_time;
using solid_sample::text;

namespace {

namespace fs = std::filesystem;

/// Everything in a folder with its bytes, below it as well, but for the time in the log.
std::map<std::string, std::string> content_of(const std::string& dir) {
  std::map<std::string, std::string> content;
  for (const auto& entry : fs::recursive_directory_iterator(dir))
    if (entry.is_regular_file())
      content[fs::relative(entry.path(), dir).string()] = without_report_time(read_text(entry.path().string()));
  return content;
}

std::size_t lines_in(const std::string& of) { return static_cast<std::size_t>(std::count(of.begin(), of.end(), '\n')); }

}  // namespace

// A run leaves each file of the contract, whole, and none half-written.
TEST(SolidRunWriter, WritesEveryFile) {
  const reye::support::TemporaryFolder dir;
  solid_sample::write_run(dir.str());
  for (const char* file : {".reye.json", "history.csv", "surface_pad_secondary.csv", "surface_pad_primary.csv",
                           "series.pvd", "surfaces.pvd", "summary.json", "scene.svg", "report.html", "inputs.json",
                           "log.txt", "frames/bodies_000002.vtu", "frames/surface_000002.vtp"})
    EXPECT_TRUE(fs::is_regular_file(dir / file)) << file;
  for (const auto& [file, bytes] : content_of(dir.str()))
    EXPECT_FALSE(becoming(fs::path(file).filename().string())) << file;
  EXPECT_EQ(lines_in(text(dir.str(), "history.csv")), 1u + 5u);
  EXPECT_EQ(lines_in(text(dir.str(), "surface_pad_secondary.csv")), 1u + 3u * 6u);
  EXPECT_EQ(lines_in(text(dir.str(), "surface_pad_primary.csv")), 1u + 3u * 9u);
  EXPECT_TRUE(text(dir.str(), "log.txt").starts_with("first line\nreport made in ")) << text(dir.str(), "log.txt");
  for (const char* file : {"series.pvd", "surfaces.pvd", "scene.svg"})
    EXPECT_TRUE(sample::well_formed(text(dir.str(), file))) << file;
  EXPECT_TRUE(holds(text(dir.str(), "series.pvd"), "file=\"frames/bodies_000002.vtu\""));
  EXPECT_TRUE(read_identity(dir.str())->solid);
}

// Two runs of the same records leave the same bytes.
TEST(SolidRunWriter, BytesRepeat) {
  const reye::support::TemporaryFolder one, other;
  solid_sample::write_run(one.str());
  solid_sample::write_run(other.str());
  EXPECT_EQ(content_of(one.str()), content_of(other.str()));
}

// A new run removes what a former one left, and nothing that no run writes.
TEST(SolidRunWriter, BeginRemovesFormerResults) {
  const reye::support::TemporaryFolder dir;
  solid_sample::write_run(dir.str());
  atomic_write(dir / "notes.txt", "mine");
  SolidRunWriter(dir.str(), solid_sample::scene()).begin();
  for (const char* gone : {"summary.json", "report.html", "surface_pad_secondary.csv", "frames/bodies_000000.vtu",
                           "series.pvd", "scene.svg", "log.txt"})
    EXPECT_FALSE(fs::exists(dir / gone)) << gone;
  EXPECT_EQ(lines_in(text(dir.str(), "history.csv")), 1u);
  EXPECT_EQ(text(dir.str(), "notes.txt"), "mine");
}

// A restart drops rows and frames after its checkpoint: the resumed run writes the bytes of an unbroken one.
TEST(SolidRunWriter, ResumedRunWritesTheSameBytes) {
  const reye::support::TemporaryFolder whole, broken;
  solid_sample::write_run(whole.str());
  Counters counters;
  {
    SolidRunWriter writer(broken.str(), solid_sample::scene());
    writer.log("first line");
    writer.begin();
    writer.frame(solid_sample::frame(0.0, 0.0));
    writer.increment(solid_sample::increment("press", 0.0, 1.0));
    writer.frame(solid_sample::frame(0.0));
    counters = writer.counters();
    writer.increment(solid_sample::increment("rub", 9.0, 0.5));
    writer.frame(solid_sample::frame(9.0));
  }
  SolidRunWriter writer(broken.str(), solid_sample::scene());
  writer.resume(counters);
  for (int i = 1; i <= 4; ++i) writer.increment(solid_sample::increment("rub", 0.25 * i, 0.25 * i));
  writer.frame(solid_sample::frame(1.0));
  writer.finish(solid_sample::summary());
  EXPECT_EQ(content_of(broken.str()), content_of(whole.str()));
}

// Without frames for ParaView the tables are all there, and the page says why it has no maps.
TEST(SolidRunWriter, WithoutParaview) {
  const reye::support::TemporaryFolder dir;
  auto scene = solid_sample::scene();
  scene.frames.paraview = false;
  solid_sample::write_run(dir.str(), scene);
  EXPECT_FALSE(fs::exists(dir / "series.pvd"));
  EXPECT_TRUE(fs::is_empty(dir / "frames"));
  EXPECT_EQ(lines_in(text(dir.str(), "surface_pad_secondary.csv")), 1u + 3u * 6u);
  EXPECT_TRUE(holds(text(dir.str(), "report.html"), "asks for no frames for ParaView"));
}
