#include <nlohmann/json.hpp>

#include "alterations.hpp"
#include "kills.hpp"
#include "same_results.hpp"
#include "solid_scenes.hpp"

using namespace reye;
using test::holds;
using test::WithRubbing;

namespace {

nlohmann::json summary(const test::Place& place, const std::string& folder) {
  return nlohmann::json::parse(test::read(place / (folder + "/summary.json")));
}

test::Changes solid_cycles(const std::string& count) { return {{"cycles = 3", "cycles = " + count}}; }

}  // namespace

// A run of solids must be interrupted in the first step and again later, killed within a cycle, and each time resume to
// the bytes of the unbroken run, in which nodes are added, with the meshes that the run had.
TEST(SolidRestart, SameBytesAsUnbroken) {
  const WithRubbing place;
  const auto whole = place.run("whole");
  ASSERT_EQ(whole.code, 0) << whole.err;
  ASSERT_GE(test::lines(place / "whole/history.csv"), 1 + 4 + 3 * 8);
  ASSERT_TRUE(holds(test::read(place / "whole/log.txt"), "more of them are kept"));
  const auto stopped = place.interrupted("broken", 2, SIGINT);
  EXPECT_EQ(stopped.code, 130) << stopped.err;
  EXPECT_TRUE(holds(stopped.err, "reye: interrupted"));
  EXPECT_EQ(summary(place, "broken").at("status").get<std::string>(), "interrupted");
  EXPECT_EQ(place.interrupted("broken", 8, SIGTERM, true).code, 130);
  EXPECT_EQ(place.interrupted("broken", 14, SIGKILL, true).code, 128 + SIGKILL);
  EXPECT_FALSE(test::fs::exists(place / "broken/summary.json"));
  const auto resumed =
      place.reye({"run", "rubbing.toml", "--out", "broken", "--quiet", "--restart", "--trust-geometry"});
  ASSERT_EQ(resumed.code, 0) << resumed.err;
  test::expect_same(place, "whole", "broken");
}

// A scene must have the same meshes, fresh ones after wear, too, wherever the program is installed: gmsh orders sets by
// addresses of memory and keeps the path of its program before them.
TEST(SolidRestart, SameWhereverInstalled) {
  const WithRubbing place;
  place.write("rubbing.toml", test::worn_rubbing());
  const test::fs::path built = test::fs::path(REYE_COMMAND).parent_path();
  for (const std::string& home : {std::string("a"), std::string(150, 'b')}) {
    for (const char* folder : {"bin", "lib/reye"}) test::fs::create_directories(place / (home + "/" + folder));
    for (const char* file : {"bin/reye", "bin/reye-import", "lib/reye/libreye_gmsh.so"})
      test::fs::copy_file(built.parent_path() / file, place / (home + "/" + file));
    const auto told =
        place.start({place / (home + "/bin/reye"), "run", "rubbing.toml", "--out", home + "/o", "--quiet"}).wait();
    ASSERT_EQ(told.code, 0) << told.err;
  }
  test::expect_same(place, "a/o", std::string(150, 'b') + "/o");
}

// Killed at random moments and resumed, its tables cut besides, a run must end as the unbroken one.
TEST(SolidRestart, Kills) { test::expect_survival(test::rubbing_solids(), 4, true); }

// A run that wears must remesh as often as it is asked to, with a row, a frame and a line of the report for it, and end
// as the unbroken one when it is killed before and after.
TEST(SolidRestart, KillsThroughRemeshes) {
  const WithRubbing place;
  place.write("rubbing.toml", test::worn_rubbing());
  const auto told = place.run("whole");
  ASSERT_EQ(told.code, 0) << told.err;
  const auto end = summary(place, "whole");
  EXPECT_EQ(end.at("counts").at("remeshes").get<double>(), 4);
  EXPECT_LE(end.at("contacts").at("pad").at("ledger_relative_error").get<double>(), 1e-9);
  const auto rows = test::read(place / "whole/remesh.csv");
  EXPECT_EQ(test::lines(place / "whole/remesh.csv"), 1 + 4);
  EXPECT_TRUE(holds(rows, "rub,1,ball,")) << rows;
  EXPECT_TRUE(holds(rows, "every 2 blocks, as asked for"));
  const auto page = test::read(place / "whole/report.html");
  EXPECT_TRUE(holds(page, "<h2>Remeshes</h2>"));
  EXPECT_TRUE(holds(page, "every 2 blocks, as asked for"));
  test::expect_survival(test::worn_solids(), 4, true);
}

// With checkpoints rarer than the run is long, an interrupted run must keep its last increment, a killed one only its
// start; both must resume to the bytes of the unbroken run.
TEST(SolidRestart, RareCheckpoints) {
  const WithRubbing place;
  place.scene({{"checkpoint_s = 0", "checkpoint_s = 1e6"}});
  ASSERT_EQ(place.run("whole").code, 0);
  for (const int signal : {SIGINT, SIGKILL}) {
    test::fs::remove_all(place / "broken");
    place.interrupted("broken", 14, signal);
    const auto rows = test::rows_in(place / "broken/checkpoint/current.bin", output::solid_state_layout());
    EXPECT_EQ(rows.at("history.csv") > 12, signal == SIGINT);
    ASSERT_EQ(place.run("broken", true).code, 0);
    test::expect_same(place, "whole", "broken");
  }
}

// A run that has ended and gets more cycles must end with the bytes of a run that had them from the start, also where
// it was killed within its last cycle; unchanged it must play nothing.
TEST(SolidRestart, MoreCycles) {
  const WithRubbing place;
  ASSERT_EQ(place.run("whole").code, 0);
  place.scene(solid_cycles("2"));
  ASSERT_EQ(place.interrupted("o", 17, SIGKILL).code, 128 + SIGKILL);
  ASSERT_EQ(place.run("o", true).code, 0);
  test::fs::copy(place / "o", place / "before", test::fs::copy_options::recursive);
  ASSERT_EQ(place.run("o", true).code, 0);
  test::expect_same(place, "before", "o");
  place.scene({});
  const auto extended = place.run("o", true);
  ASSERT_EQ(extended.code, 0) << extended.err;
  test::expect_same(place, "whole", "o");
  EXPECT_TRUE(holds(test::read(place / "o/log.txt"), "extended: step[1].cycles = 3: was 2 in the run to be resumed"));
}

// Fewer cycles than were begun, another value and a changed file must be refused with line and reason, and a folder
// without a checkpoint with that; nothing must be written.
TEST(SolidRestart, Refused) {
  const WithRubbing place;
  const auto nothing = place.run("none", true);
  EXPECT_EQ(nothing.code, 2);
  EXPECT_TRUE(
      holds(nothing.err, "--restart = none: no checkpoint to resume from: none/checkpoint/current.bin: missing"))
      << nothing.err;
  ASSERT_EQ(place.interrupted("o", 14, SIGINT).code, 130);
  const auto before = place.files("o");
  const auto refused = [&](const test::Changes& changes) {
    place.scene(changes);
    const auto answer = place.run("o", true);
    EXPECT_EQ(answer.code, 2);
    EXPECT_EQ(place.files("o"), before);
    return answer.err;
  };
  EXPECT_TRUE(holds(refused(solid_cycles("1")),
                    "rubbing.toml:62: step[1].cycles = 1: the run has begun 2 cycles of this step already"));
  EXPECT_TRUE(holds(refused({{"friction  = 0.3", "friction  = 0.4"}}),
                    "rubbing.toml:31: contact.pad.friction = 0.4: was 0.3 in the run to be resumed; it takes other "
                    "limits and more cycles of its last step, nothing else"));
  place.write("rubbing.geo", std::string(test::rubbing_geo) + "// changed\n");
  EXPECT_EQ(refused({}),
            "rubbing.toml:3: geometry = \"rubbing.geo\": its content differs from that in the run to be resumed\n");
}

// A damaged checkpoint must be refused with a sentence, and the one before it taken; altered under a right checksum it
// must be refused, or be another possible state.
TEST(SolidRestart, DamagedCheckpoints) {
  const WithRubbing place;
  ASSERT_EQ(place.run("whole").code, 0);
  ASSERT_EQ(place.interrupted("o", 14, SIGKILL).code, 128 + SIGKILL);
  const auto file = place / "o/checkpoint/current.bin";
  auto bytes = test::read(file);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  output::atomic_write(file.string(), bytes);
  const auto resumed = place.run("o", true);
  EXPECT_EQ(resumed.code, 0);
  EXPECT_TRUE(holds(resumed.err, "checkpoint: o/checkpoint/current.bin: altered: wrong checksum")) << resumed.err;
  test::expect_same(place, "whole", "o");
  test::expect_sentences(test::rubbing_interrupted(), 30);
}
