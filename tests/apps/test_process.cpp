#include "alterations.hpp"
#include "base/printable.hpp"
#include "command.hpp"
#include "output/folder/folder_lock.hpp"
#include "places.hpp"
#include "same_results.hpp"
#include "scenes.hpp"

using namespace reye;

namespace {

/// A run that lasts long enough to be met under way on a machine that has other work.
const std::string long_wearing = test::changed(test::wearing, {{"cycles = 400", "cycles = 2000"}});

struct WithLongWearing : test::WithWearing {
  WithLongWearing() : WithWearing(long_wearing) {}
};

bool under_way(const test::Place& place, const std::string& folder, long rows = 5) {
  return test::lines(place / (folder + "/history.csv")) > rows;
}

/// Whether any process still writes into a folder.
bool written_to(const test::Place& place, const std::string& folder) {
  return output::is_locked((place / folder).string());
}

}  // namespace

// While a run writes into a folder a second one must be refused with 2 and a sentence, with --restart and --force, too;
// a report of the folder must be made; the first run must end as if it had been alone.
TEST(Process, TwoRunsInOneFolder) {
  const WithLongWearing place;
  ASSERT_EQ(place.reye({"run", "wearing.toml", "--out", "whole", "--quiet"}).code, 0);
  auto first = place.start_reye({"run", "wearing.toml", "--out", "o", "--quiet"});
  ASSERT_TRUE(first.signal_when(SIGSTOP, [&] { return under_way(place, "o"); }));
  for (const char* how : {"--quiet", "--restart", "--force"}) {
    const auto second = place.start({REYE_COMMAND, "run", "wearing.toml", "--out", "o", how}, 0, "second").wait();
    EXPECT_EQ(second.code, 2) << how;
    EXPECT_EQ(second.err,
              "--out = o: another run is writing to the output folder o; wait for its end, or choose another folder "
              "with --out\n");
  }
  EXPECT_EQ(place.start({REYE_COMMAND, "report", "o"}, 0, "second").wait().code, 0);
  EXPECT_TRUE(test::holds(test::read(place / "o/report.html"), "The run has not ended"));
  ASSERT_TRUE(first.signal_when(SIGCONT, [] { return true; }));
  EXPECT_EQ(first.wait().code, 0);
  test::expect_same(place, "whole", "o");
}

// A report made again and again while a run writes must be made each time, and leave the run as it would be alone.
TEST(Process, ReportsOfARunningFolder) {
  const WithLongWearing place;
  ASSERT_EQ(place.reye({"run", "wearing.toml", "--out", "whole", "--quiet"}).code, 0);
  auto run = place.start_reye({"run", "wearing.toml", "--out", "o", "--quiet"});
  ASSERT_TRUE(run.signal_when(SIGCONT, [&] { return under_way(place, "o", 0); }));
  int made = 0;
  for (; run.is_running(); ++made) {
    const auto report = place.start({REYE_COMMAND, "report", "o"}, 0, "second").wait();
    ASSERT_EQ(report.code, 0) << report.err;
  }
  EXPECT_GT(made, 0);
  EXPECT_EQ(run.wait().code, 0);
  ASSERT_EQ(place.reye({"report", "o"}).code, 0);
  test::expect_same(place, "whole", "o");
}

// SIGHUP and SIGTERM must end a run as Ctrl-C does: everything written, 130, and on to the bytes of an unbroken run.
// Any number of SIGHUP asks once only, as a closed terminal sends several; one that nohup has ignored asks nothing.
TEST(Process, HangUpAndTerminate) {
  const WithLongWearing place;
  ASSERT_EQ(place.reye({"run", "wearing.toml", "--out", "whole", "--quiet"}).code, 0);
  for (const int signal : {SIGHUP, SIGTERM}) {
    test::fs::remove_all(place / "o");
    auto run = place.start_reye({"run", "wearing.toml", "--out", "o", "--quiet"});
    ASSERT_TRUE(run.signal_when(signal, [&] { return under_way(place, "o", 25); }));
    for (int k = 0; k < 5 && signal == SIGHUP; ++k) run.signal_when(signal, [] { return true; });
    const auto told = run.wait();
    EXPECT_EQ(told.code, 130) << told.err;
    EXPECT_TRUE(test::holds(told.err, "reye: interrupted in step \"wear\" at cycle ")) << told.err;
    EXPECT_TRUE(test::holds(test::read(place / "o/summary.json"), R"("status": "interrupted")"));
    EXPECT_EQ(place.reye({"run", "wearing.toml", "--out", "o", "--restart", "--quiet"}).code, 0);
    test::expect_same(place, "whole", "o");
  }
  auto run = place.start({"/usr/bin/nohup", REYE_COMMAND, "run", "wearing.toml", "--out", "nohup", "--quiet"});
  ASSERT_TRUE(run.signal_when(SIGHUP, [&] { return under_way(place, "nohup"); }));
  EXPECT_EQ(run.wait().code, 0);
}

// Output that nobody reads any more must not end a run.
TEST(Process, OutputIsLost) {
  const WithLongWearing place;
  ASSERT_EQ(place.reye({"run", "wearing.toml", "--out", "whole", "--quiet"}).code, 0);
  const auto told =
      place.start({"/bin/bash", "-c", "set -o pipefail; \"$0\" run wearing.toml --out o 2>&1 | head -1", REYE_COMMAND})
          .wait();
  EXPECT_EQ(told.code, 0);
  EXPECT_EQ(std::count(told.out.begin(), told.out.end(), '\n'), 1);
  test::expect_same(place, "whole", "o");
}

// When a sweep is killed its members must end, too, each with its last good state on disk; the same call resumes it.
TEST(Process, MembersEndWithTheirSweep) {
  const WithLongWearing place;
  const std::vector<std::string> words = {
      "sweep", "wearing.toml", "--vary", "contact.pad.friction=0.4,0.5", "--jobs", "2", "--out", "s", "--quiet"};
  auto sweep = place.start_reye(words);
  ASSERT_TRUE(
      sweep.signal_when(SIGKILL, [&] { return under_way(place, "s/member_000") && under_way(place, "s/member_001"); }));
  EXPECT_EQ(sweep.wait().code, 128 + SIGKILL);
  for (int k = 0; k < 6000 && (written_to(place, "s/member_000") || written_to(place, "s/member_001")); ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  for (const char* member : {"s/member_000", "s/member_001"}) {
    EXPECT_FALSE(written_to(place, member));
    EXPECT_LT(test::lines(place / member / "history.csv"), 2 + 16 * 20) << "it ran to its end";
    EXPECT_TRUE(test::holds(test::read(place / member / "summary.json"), R"("status": "interrupted")"));
  }
  EXPECT_EQ(place.reye(words).code, 0);
}

// A member whose folder is damaged must not keep the table from the others.
TEST(Process, TableOfABrokenMember) {
  const WithLongWearing place;
  const std::vector<std::string> words = {
      "sweep", "wearing.toml", "--vary", "contact.pad.friction=0.4,0.5,0.6", "--out", "s", "--quiet"};
  ASSERT_EQ(place.reye(words).code, 0);
  const auto whole = test::read(place / "s/sweep.csv");
  auto table = words;
  table.push_back("--table");
  const auto summary = test::read(place / "s/member_001/summary.json");
  for (const std::string& broken : {std::string("{"), summary.substr(0, 200), std::string("\xff\xfe")}) {
    place.write("s/member_001/summary.json", broken);
    const auto told = place.reye(table);
    EXPECT_EQ(told.code, 1);
    EXPECT_TRUE(test::holds(
        told.err, "member_001 (contact.pad.friction = 0.5): damaged: s/member_001/summary.json cannot be read"))
        << told.err;
    EXPECT_EQ(test::lines(place / "s/sweep.csv"), 4);
    EXPECT_TRUE(test::holds(test::read(place / "s/sweep.csv"), "member_002,0.6,done,"));
  }
  test::fs::remove_all(place / "s/member_001");
  EXPECT_EQ(place.reye(table).code, 1);
  place.write("s/member_001", "a file");
  EXPECT_EQ(place.reye(table).code, 1) << "a file in the place of a member";
}

// Neither a run with --force nor a sweep may remove or write anything through a link that was planted where it works.
TEST(Process, PlantedLinks) {
  const WithLongWearing place;
  place.write("blocks.geo", test::blocks_geo);
  place.write("blocks.toml", test::blocks);
  place.write("mine/history.csv", "mine");
  place.write("mine/frames/bodies_000000.vtu", "mine");
  ASSERT_EQ(place.reye({"run", "wearing.toml", "--out", "o", "--quiet"}).code, 0);
  const auto mine = place.files("mine");
  for (const char* folder : {"frames", "figures", "checkpoint"}) {
    test::fs::remove_all(place / "o" / folder);
    test::fs::create_directory_symlink(place / "mine", place / "o" / folder);
  }
  for (const char* file : {"history.csv", "summary.json", "log.txt", "report.html", "surface_pad_primary.csv"}) {
    test::fs::remove(place / "o" / file);
    test::fs::create_symlink(place / "mine/history.csv", place / "o" / file);
  }
  EXPECT_EQ(place.reye({"run", "wearing.toml", "--out", "o", "--restart", "--quiet"}).code, 2);
  EXPECT_EQ(place.reye({"run", "blocks.toml", "--out", "o", "--force", "--quiet"}).code, 0);
  EXPECT_EQ(place.files("mine"), mine);
  EXPECT_FALSE(test::fs::is_symlink(place / "o/history.csv"));
  test::fs::create_directory_symlink(place / "mine", place / "link");
  const auto forced = place.reye({"run", "blocks.toml", "--out", "link", "--force"});
  EXPECT_EQ(forced.code, 2);
  EXPECT_TRUE(forced.err.starts_with("--out = link: the output folder link is a symbolic link to /")) << forced.err;
  test::fs::create_directories(place / "s");
  test::fs::create_directory_symlink(place / "mine", place / "s/member_000");
  const auto sweep =
      place.reye({"sweep", "blocks.toml", "--vary", "contact.pad.friction=0.4", "--out", "s", "--force"});
  EXPECT_EQ(sweep.code, 2);
  EXPECT_EQ(sweep.err, "member_000: s/member_000 is a symbolic link, which a sweep does not follow\n");
  EXPECT_EQ(place.files("mine"), mine);
}

// A damaged folder must be refused by `report` with 2 and a sentence that names the file.
TEST(Process, ReportOfADamagedFolder) {
  const WithLongWearing place;
  ASSERT_EQ(place.reye({"run", "wearing.toml", "--out", "o", "--quiet"}).code, 0);
  for (const char* file :
       {".reye.json", "summary.json", "history.csv", "surface_pad_secondary.csv", "frames/bodies_000001.vtu"}) {
    const auto whole = test::read(place / "o" / file);
    place.write(std::string("o/") + file, whole.substr(0, whole.size() / 2));
    const auto told = place.reye({"report", "o", "--animation"});
    EXPECT_EQ(told.code, 2);
    EXPECT_TRUE(told.err.starts_with(std::string("dir: o/") + file + " is damaged: ")) << told.err;
    EXPECT_EQ(std::count(told.err.begin(), told.err.end(), '\n'), 1) << told.err;
    place.write(std::string("o/") + file, whole);
  }
  EXPECT_EQ(place.reye({"report", "o", "--animation"}).code, 0);
}

// A folder and a scene may be called by any bytes: everything works, JSON and page stay valid, messages stay in their
// lines.
TEST(Process, NamesOfAnyBytes) {
  const WithLongWearing place;
  ASSERT_EQ(place.reye({"run", "wearing.toml", "--out", "whole", "--quiet"}).code, 0);
  for (const std::string name : {"two\nlines", "\xff <b>&\"'", "=cmd \x1b[31m%s µ軸"}) {
    const std::string scene = name + "/" + name + ".toml", out = name + ".o";
    place.write(name + "/wearing.geo", test::wearing_geo);
    place.write(scene, test::changed(long_wearing, {{"title    = \"Small wearing contact\"\n", ""},
                                                    {"name = \"wear\"", "name = \"=w\\u001b\\n\""}}));
    const auto told = place.reye({"run", scene, "--out", out});
    ASSERT_EQ(told.code, 0) << told.err;
    EXPECT_EQ((told.out + told.err + test::read(place / (out + "/log.txt"))).find('\x1b'), std::string::npos);
    EXPECT_FALSE(test::holds(told.out, "two\nlines"));
    for (const char* file : {"/summary.json", "/.reye.json"})
      EXPECT_TRUE(nlohmann::json::accept(test::read(place / (out + file)))) << name;
    const auto page = test::read(place / (out + "/report.html"));
    EXPECT_FALSE(test::holds(page, "<b>"));
    for (std::size_t i = 0; i < page.size();) {
      const auto length = base::utf8_length(page, i);
      ASSERT_GT(length, 0U) << name;
      i += length;
    }
    EXPECT_EQ(test::lines(place / (out + "/history.csv")), test::lines(place / "whole/history.csv"));
    EXPECT_TRUE(test::holds(test::read(place / (out + "/history.csv")), "\n'=w  ,"));
    EXPECT_EQ(place.reye({"run", scene, "--out", out, "--restart", "--quiet"}).code, 0);
    EXPECT_EQ(place.reye({"report", out, "--animation"}).code, 0);
    const auto refused = place.reye({"run", "wearing.toml", "--out", out});
    EXPECT_EQ(refused.code, 2);
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
    EXPECT_EQ(refused.err.find_first_of("\x1b\xff"), std::string::npos);
    const auto missing = place.reye({"check", name + "/none.toml"});
    EXPECT_EQ(missing.code, 2);
    EXPECT_EQ(std::count(missing.err.begin(), missing.err.end(), '\n'), 1) << missing.err;
  }
}

// A checkpoint that was altered under a right checksum must be refused with a sentence or resumed from; it crashes
// nothing.
TEST(Process, AlteredCheckpoints) { test::expect_sentences(test::wearing_interrupted(), 12); }
