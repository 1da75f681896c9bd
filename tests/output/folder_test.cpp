#include <gtest/gtest.h>

#include "output/files.hpp"
#include "output/folder.hpp"
#include "sample_run.hpp"

using namespace reye::output;
using sample::fs::exists;

namespace {
bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
}  // namespace

// A new folder is accepted and not made yet; a folder with only foreign files is accepted too.
TEST(Folder, AcceptsNewAndForeign) {
  sample::TemporaryFolder dir;
  EXPECT_FALSE(open_folder(dir / "a/b", "s", "1", false));
  EXPECT_FALSE(exists(dir / "a"));
  sample::fs::create_directories(dir / "a/b");
  atomic_write(dir / "a/b/notes.txt", "mine");
  EXPECT_FALSE(open_folder(dir / "a/b", "s", "1", false));
}

// Another scene's run, another version of the scene, and results of unknown origin are refused unless forced.
TEST(Folder, RefusesAnotherRun) {
  sample::TemporaryFolder dir;
  claim_folder(dir.str(), {"fretting", "t", "1", {}, {}});
  EXPECT_FALSE(open_folder(dir.str(), "fretting", "1", false));
  EXPECT_TRUE(holds(open_folder(dir.str(), "hertz", "2", false).value(), "another scene, 'fretting'"));
  EXPECT_TRUE(holds(open_folder(dir.str(), "fretting", "2", false).value(), "another version of the scene"));
  EXPECT_FALSE(open_folder(dir.str(), "hertz", "2", true));
  sample::fs::remove(dir / ".reye.json");
  EXPECT_FALSE(open_folder(dir.str(), "hertz", "2", false));
  atomic_write(dir / "history.csv", "x");
  EXPECT_TRUE(holds(open_folder(dir.str(), "hertz", "2", false).value(), "unknown run"));
}

// A file in the place of the folder is an error text, not a crash.
TEST(Folder, RefusesAFile) {
  sample::TemporaryFolder dir;
  atomic_write(dir / "f", "x");
  EXPECT_TRUE(open_folder(dir / "f", "s", "1", true));
  EXPECT_TRUE(holds(open_folder(dir / "f/below/it", "s", "1", true).value(), "cannot make the output folder"));
}

// Results of the former run stay until the new one begins; then they go and foreign files stay.
TEST(Folder, ResultsGoOnlyWhenTheRunBegins) {
  sample::TemporaryFolder dir;
  sample::write_run(dir.str(), 4);
  atomic_write(dir / "notes.txt", "mine");
  ASSERT_FALSE(open_folder(dir.str(), "fretting", "abc123", false));
  RunWriter writer(dir.str(), sample::scene());
  EXPECT_TRUE(exists(dir / "summary.json"));
  writer.begin();
  for (const char* gone : {"summary.json", "series.pvd", "surface_pad_primary.csv", "report.html", "log.txt"})
    EXPECT_FALSE(exists(dir / gone)) << gone;
  EXPECT_TRUE(sample::fs::is_empty(dir / "frames"));
  EXPECT_EQ(read_text(dir / "notes.txt"), "mine");
}

// The marker tells of the run what a report needs.
TEST(Folder, IdentityReadsBack) {
  sample::TemporaryFolder dir;
  claim_folder(dir.str(), identity_of(sample::scene(sample::Analysis::axisymmetric)));
  const auto identity = read_identity(dir.str()).value();
  EXPECT_EQ(identity.title, sample::scene().title);
  EXPECT_EQ(identity.analysis, sample::Analysis::axisymmetric);
  EXPECT_EQ(identity.friction.at("pad"), 0.9);
}
