#include <gtest/gtest.h>

#include "output/folder/files.hpp"
#include "output/folder/folder.hpp"
#include "output/report/report.hpp"
#include "sample_run.hpp"
#include "support/texts.hpp"

using namespace reye::output;
using reye::support::holds;
using sample::fs::exists;

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

// The marker holds what a report needs to know of the run.
TEST(Folder, IdentityReadsBack) {
  sample::TemporaryFolder dir;
  claim_folder(dir.str(), identity_of(sample::scene(sample::Analysis::axisymmetric)));
  const auto identity = read_identity(dir.str()).value();
  EXPECT_EQ(identity.title, sample::scene().title);
  EXPECT_EQ(identity.analysis, sample::Analysis::axisymmetric);
  EXPECT_EQ(identity.friction.at("pad"), 0.9);
}

// Nothing is removed or written through a symbolic link in the folder: a new run removes the link alone, a resumed one
// and a report refuse it.
TEST(Folder, FollowsNoLinkInside) {
  sample::TemporaryFolder dir, other;
  atomic_write(other / "precious.svg", "mine");
  atomic_write(other / "table.csv", "mine");
  const auto plant = [&](const char* name, const std::string& target) {
    sample::fs::remove_all(dir / name);
    sample::fs::create_symlink(target, dir / name);
  };
  const auto untouched = [&] {
    return read_text(other / "precious.svg") == "mine" && read_text(other / "table.csv") == "mine" &&
           std::distance(sample::fs::directory_iterator(other.str()), {}) == 2;
  };
  sample::write_run(dir.str(), 4);
  for (const char* name : {"frames", "figures", "checkpoint"}) plant(name, other.str());
  for (const char* name : {"log.txt", "summary.json", "surface_pad_primary.csv", "report.html", "series.pvd"})
    plant(name, other / "table.csv");
  sample::write_run(dir.str(), 4);
  EXPECT_TRUE(untouched());
  EXPECT_FALSE(sample::fs::is_symlink(dir / "frames"));

  for (const char* name : {"log.txt", "history.csv"}) {
    plant(name, other / "table.csv");
    RunWriter writer(dir.str(), sample::scene());
    EXPECT_THROW(
        {
          writer.resume({});
          writer.log("a line");
        },
        std::runtime_error)
        << name;
    EXPECT_TRUE(untouched()) << name;
    sample::fs::remove(dir / name);
    sample::write_run(dir.str(), 4);
  }
  plant("frames", other.str());
  EXPECT_THROW(RunWriter(dir.str(), sample::scene()).resume({}), std::runtime_error);
  sample::fs::remove(dir / "frames");
  sample::write_run(dir.str(), 4);
  plant("figures", other.str());
  plant("report.html", other / "table.csv");
  EXPECT_THROW(write_report(dir.str()), std::runtime_error);
  EXPECT_TRUE(untouched());
  sample::fs::remove(dir / "figures");
  write_report(dir.str());
  EXPECT_TRUE(untouched());
  EXPECT_FALSE(sample::fs::is_symlink(dir / "report.html"));
}

// A link to a folder may be given as the output folder, but another run behind it is not removed.
TEST(Folder, ForceRemovesNoRunThroughALink) {
  sample::TemporaryFolder dir;
  sample::write_run(dir / "run", 4);
  sample::fs::create_directory_symlink(dir / "run", dir / "link");
  EXPECT_FALSE(open_folder(dir / "link", "fretting", "abc123", true));
  EXPECT_FALSE(open_folder(dir / "run", "hertz", "2", true));
  for (const char* link : {"link", "link/"}) {
    const auto refusal = open_folder(dir / link, "hertz", "2", true).value_or("");
    EXPECT_TRUE(holds(refusal, "is a symbolic link to ")) << refusal;
  }
}

// What a kill has left under a temporary name goes when the folder is used again; a file of the user's stays.
TEST(Folder, LeftOversGo) {
  sample::TemporaryFolder dir;
  const std::vector<std::string> left = {"summary.json.4711.tmp", ".reye.json.new.1.tmp",
                                         "frames/bodies_000000.vtu.12.tmp"};
  const std::vector<std::string> kept = {"notes.txt.4711.tmp", "summary.json.tmp", "my.tmp"};
  for (const bool resumed : {false, true}) {
    sample::write_run(dir.str(), 4);
    for (const auto* names : {&left, &kept})
      for (const auto& name : *names) atomic_write(dir / name, "half");
    RunWriter writer(dir.str(), sample::scene());
    resumed ? writer.resume({}) : writer.begin();
    for (const auto& name : left) EXPECT_FALSE(exists(dir / name)) << name;
    for (const auto& name : kept) EXPECT_TRUE(exists(dir / name)) << name;
  }
}

// A name may have any bytes: the marker stays JSON and is read again.
TEST(Folder, NamesOfAnyBytes) {
  sample::TemporaryFolder dir;
  claim_folder(dir.str(), {"a\n\"\xff\x1b", "t", "1", {}, {}});
  ASSERT_TRUE(read_identity(dir.str()));
  EXPECT_FALSE(open_folder(dir.str(), "other", "1", false));
}
