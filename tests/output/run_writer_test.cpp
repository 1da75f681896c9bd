#include <gtest/gtest.h>

#include "output/folder/files.hpp"
#include "output/folder/tables.hpp"
#include "output/run/run_writer.hpp"
#include "sample_run.hpp"

using namespace reye::output;
using sample::contents;

namespace {

void play(RunWriter& writer, int first, int last) {
  for (int block = first; block < last; ++block) {
    writer.increment(sample::increment(40, 100.0 * block));
    if (block % 2 == 1) writer.remesh(sample::remesh(100.0 * block));
    writer.frame(sample::frame(100.0 * block, 4 + block));
  }
}

}  // namespace

// Two runs give the same bytes in every file.
TEST(RunWriter, SameInputSameBytes) {
  sample::TemporaryFolder a, b;
  sample::write_run(a.str(), 6);
  sample::write_run(b.str(), 6);
  EXPECT_EQ(contents(a.str()), contents(b.str()));
}

// A run killed after its checkpoint and resumed there leaves the same bytes as the unbroken run.
TEST(RunWriter, ResumedRunEqualsUnbrokenRun) {
  sample::TemporaryFolder whole, broken;
  RunWriter unbroken(whole.str(), sample::scene());
  unbroken.begin();
  play(unbroken, 0, 5);
  unbroken.finish(sample::summary(reye::base::Analysis::plane_strain, 400.0));

  RunWriter killed(broken.str(), sample::scene());
  killed.begin();
  play(killed, 0, 2);
  const Counters at_checkpoint = killed.counters();
  play(killed, 2, 4);
  append_text(broken / "history.csv", "wear, half a ro");
  RunWriter resumed(broken.str(), sample::scene());
  resumed.resume(at_checkpoint);
  EXPECT_EQ(resumed.counters(), at_checkpoint);
  play(resumed, 2, 5);
  resumed.finish(sample::summary(reye::base::Analysis::plane_strain, 400.0));
  EXPECT_EQ(contents(whole.str()), contents(broken.str()));
}

// Without a folder nothing is written, and the tables kept are those of a folder, byte for byte.
TEST(RunWriter, InMemoryTheTablesAreThoseOfAFolder) {
  sample::TemporaryFolder dir;
  RunWriter on_disk(dir.str(), sample::scene()), in_memory("", sample::scene());
  for (auto* writer : {&on_disk, &in_memory}) {
    writer->log("early");
    writer->begin();
    play(*writer, 0, 4);
    writer->log("late");
    writer->finish(sample::summary(reye::base::Analysis::plane_strain, 300.0));
  }
  auto expected = contents(dir.str());
  std::erase_if(expected,
                [](const auto& file) { return !file.first.ends_with(".csv") && file.first != "summary.json"; });
  EXPECT_EQ(in_memory.tables(), expected);
  EXPECT_EQ(expected.count("remesh.csv"), 1U);
  EXPECT_TRUE(on_disk.tables().empty());
  EXPECT_EQ(in_memory.counters(), on_disk.counters());
}

// The table of remeshes begins with the first of them, has a row for each, and is cut back with the checkpoint.
TEST(RunWriter, RemeshesAreCountedAndCutBack) {
  sample::TemporaryFolder dir;
  RunWriter killed(dir.str(), sample::scene());
  killed.begin();
  EXPECT_FALSE(sample::fs::exists(dir / "remesh.csv"));
  killed.remesh(sample::remesh(100.0));
  const Counters at_checkpoint = killed.counters();
  EXPECT_EQ(at_checkpoint.remesh_rows, 1);
  const std::string table = read_text(dir / "remesh.csv");
  EXPECT_EQ(table, remesh_header(reye::base::Analysis::plane_strain) + remesh_row(sample::remesh(100.0)));
  killed.remesh(sample::remesh(200.0));
  append_text(dir / "remesh.csv", "wear, half a ro");
  RunWriter resumed(dir.str(), sample::scene());
  resumed.resume(at_checkpoint);
  EXPECT_EQ(read_text(dir / "remesh.csv"), table);
  resumed.remesh(sample::remesh(300.0));
  EXPECT_EQ(read_text(dir / "remesh.csv"), table + remesh_row(sample::remesh(300.0)));
}

// A checkpoint from before the first remesh leaves no table of a later one; nor does a new run.
TEST(RunWriter, NoRemeshLeavesNoTable) {
  sample::TemporaryFolder dir;
  RunWriter killed(dir.str(), sample::scene());
  killed.begin();
  const Counters start = killed.counters();
  killed.remesh(sample::remesh(100.0));
  RunWriter resumed(dir.str(), sample::scene());
  resumed.resume(start);
  EXPECT_FALSE(sample::fs::exists(dir / "remesh.csv"));
  resumed.remesh(sample::remesh(100.0));
  RunWriter(dir.str(), sample::scene()).begin();
  EXPECT_FALSE(sample::fs::exists(dir / "remesh.csv"));
}

// A checkpoint from before the first frame leaves no rows of a later one behind.
TEST(RunWriter, ResumesFromBeforeTheFirstFrame) {
  sample::TemporaryFolder dir;
  RunWriter killed(dir.str(), sample::scene());
  killed.begin();
  const Counters start = killed.counters();
  play(killed, 0, 2);
  RunWriter resumed(dir.str(), sample::scene());
  resumed.resume(start);
  EXPECT_FALSE(sample::fs::exists(dir / "surface_pad_secondary.csv"));
  EXPECT_EQ(read_text(dir / "series.pvd").find("DataSet"), std::string::npos);
}

// A restart takes away the summary of the run it continues, so that it is not taken for the whole.
TEST(RunWriter, ResumeRemovesTheOldSummary) {
  sample::TemporaryFolder dir;
  sample::write_run(dir.str(), 4);
  RunWriter writer(dir.str(), sample::scene());
  writer.resume({});
  EXPECT_FALSE(sample::fs::exists(dir / "summary.json"));
  EXPECT_FALSE(sample::fs::exists(dir / "report.html"));
}

// What is logged before the run begins is not lost.
TEST(RunWriter, KeepsTheEarlyLog) {
  sample::TemporaryFolder dir;
  RunWriter writer(dir.str(), sample::scene());
  writer.log("plan: nothing skipped");
  EXPECT_FALSE(sample::fs::exists(dir / "log.txt"));
  writer.begin();
  writer.log("block 1");
  EXPECT_EQ(read_text(dir / "log.txt"), "plan: nothing skipped\nblock 1\n");
}

// A log must not grow without bound: it says where it ends and takes no more, also after a restart.
TEST(RunWriter, LogIsBounded) {
  sample::TemporaryFolder dir;
  const std::string line(1000, 'x');
  RunWriter writer(dir.str(), sample::scene());
  writer.begin();
  for (int k = 0; k < 2100; ++k) writer.log(line);
  const std::string log = read_text(dir / "log.txt");
  EXPECT_LT(log.size(), most_log_bytes + 1100);
  EXPECT_EQ(log.substr(log.size() - 30), "the log is full and ends here\n");
  RunWriter again(dir.str(), sample::scene());
  again.resume({});
  again.log(line);
  EXPECT_EQ(read_text(dir / "log.txt"), log);
}

// After every frame both collections name exactly the frames that are there, whole.
TEST(RunWriter, CollectionsAreWholeAfterEachFrame) {
  sample::TemporaryFolder dir;
  RunWriter writer(dir.str(), sample::scene());
  writer.begin();
  for (int k = 0; k < 3; ++k) {
    play(writer, k, k + 1);
    const std::string pvd = read_text(dir / "series.pvd");
    EXPECT_NE(pvd.find("</VTKFile>"), std::string::npos);
    const std::string last = "frames/bodies_00000" + std::to_string(k) + ".vtu";
    EXPECT_NE(pvd.find("timestep=\"" + std::to_string(100 * k) + "\" group=\"\" part=\"0\" file=\"" + last),
              std::string::npos);
    EXPECT_TRUE(sample::fs::exists(dir / last));
    EXPECT_NE(read_text(dir / "surfaces.pvd").find("frames/surface_00000" + std::to_string(k) + ".vtp"),
              std::string::npos);
  }
}
