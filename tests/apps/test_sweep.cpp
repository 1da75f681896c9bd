#include <sstream>

#include "command.hpp"
#include "places.hpp"
#include "scenes.hpp"
#include "support/sanitizers.hpp"

using namespace reye;

namespace {

/// A block that an imposed sliding eats: 1e-5 per MPa is a tenth of it per cycle.
std::string eaten() {
  return test::changed(test::blocks, {{"friction  = 0.3\n", "imposed_sliding_mm = 1000.0\n"},
                                      {R"(law = "energy", secondary_mm3_per_J = 3.0e-5, primary_mm3_per_J = 2.0e-5)",
                                       R"(law = "archard", secondary_per_MPa = 1e-5)"}}) +
         "\n[[step]]\nname = \"wear\"\ncycles = 3\n";
}

struct WithSweeps : test::WithWearing {
  WithSweeps() {
    write("sub/blocks.geo", test::blocks_geo);
    write("sub/eaten.toml", eaten());
  }
};

const std::string coefficient = "contact.pad.wear.secondary_per_MPa=1e-12,1e-5";

/// Rows of the table; their cells hold no comma here.
std::vector<std::vector<std::string>> rows_of(const test::fs::path& file) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream text(test::read(file));
  for (std::string line; std::getline(text, line);) {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

/// The cell of a row under the heading of that name.
std::string cell(const std::vector<std::vector<std::string>>& rows, std::size_t row, const std::string& name) {
  const auto& head = rows.at(0);
  const auto found = std::find(head.begin(), head.end(), name);
  EXPECT_NE(found, head.end()) << name;
  return rows.at(row).at(static_cast<std::size_t>(found - head.begin()));
}

}  // namespace

// A full grid must run every member beside its geometry's folder, continue past the one that fails, name it, end with 1
// and collect all in one table; called again it must run that one only.
TEST(Sweep, GridWithAFailure) {
  const WithSweeps place;
  const std::vector<std::string> words = {
      "sweep", "sub/eaten.toml", "--vary", coefficient, "--vary", "step[1].cycles=1,2,50", "--out", "many", "--quiet"};
  const auto told = place.reye(words);
  EXPECT_EQ(told.code, 1);
  EXPECT_TRUE(
      told.err.starts_with("member_005 (contact.pad.wear.secondary_per_MPa = 1e-5, step[1].cycles = 50): failed: "
                           "many/member_005/scene.toml:40: body slider is worn by 0.8 mm of the 1 mm that it measured"))
      << told.err;
  EXPECT_EQ(std::count(told.err.begin(), told.err.end(), '\n'), 1);
  const auto rows = rows_of(place / "many/sweep.csv");
  ASSERT_EQ(rows.size(), 7U);
  for (std::size_t i = 1; i < 7; ++i) {
    EXPECT_EQ(cell(rows, i, "member"), "member_00" + std::to_string(i - 1));
    EXPECT_EQ(cell(rows, i, "contact.pad.wear.secondary_per_MPa"), i < 4 ? "1e-12" : "1e-5");
    EXPECT_EQ(cell(rows, i, "status"), i == 6 ? "failed" : "done");
  }
  for (std::size_t i = 1; i < 4; ++i)  // Archard's law, k F s: 20 N/mm over 1000 mm per cycle
    EXPECT_NEAR(
        std::stod(cell(rows, i, "contacts.pad.secondary.worn_area_mm2")) / (2e-8 * std::stod(cell(rows, i, "cycles"))),
        1.0, 1e-9);
  EXPECT_TRUE(test::holds(cell(rows, 6, "reason"), "body slider is worn by 0.8 mm"));

  const auto before = place.files("many");
  EXPECT_EQ(place.reye(words).code, 1);
  auto after = place.files("many");
  for (const auto& [file, bytes] : before) {
    if (file == "sweep.csv" || file.starts_with("member_005/")) continue;
    EXPECT_EQ(after[file], bytes) << file;  // with the times in their summaries: they have not run again
  }
}

// A sweep that is done must not run anything again, and its table can be collected again from the folders.
TEST(Sweep, DoneIsDone) {
  const WithSweeps place;
  const std::vector<std::string> words = {"sweep", "sub/eaten.toml", "--vary", "step[1].cycles=1,2"};
  const auto told = place.reye(words);
  EXPECT_EQ(told.code, 0) << told.err;
  EXPECT_EQ(told.out, "2 members, 2 done; table ./eaten.sweep/sweep.csv, page ./eaten.sweep/sweep.html\n");
  const auto before = place.files("eaten.sweep");
  EXPECT_EQ(place.reye(words).err, "");
  EXPECT_EQ(place.files("eaten.sweep"), before);
  test::fs::remove(place / "eaten.sweep/sweep.csv");
  EXPECT_EQ(place.reye({"sweep", "sub/eaten.toml", "--vary", "step[1].cycles=1,2", "--table"}).code, 0);
  EXPECT_EQ(place.files("eaten.sweep"), before);
}

// One member alone must give what the whole sweep gives for it, and leave the table to the others.
TEST(Sweep, OneMember) {
  const WithSweeps place;
  const std::vector<std::string> words = {"sweep", "sub/eaten.toml", "--vary", "step[1].cycles=1,2", "--out",
                                          "o",     "--quiet"};
  auto one = words;
  one.insert(one.end(), {"--member", "1"});
  EXPECT_EQ(place.reye(one).code, 0);
  EXPECT_FALSE(test::fs::exists(place / "o/member_000"));
  EXPECT_FALSE(test::fs::exists(place / "o/sweep.csv"));
  const auto alone = place.files("o/member_001");
  EXPECT_EQ(place.reye(words).code, 0);
  EXPECT_EQ(place.files("o/member_001"), alone);
  one.back() = "2";
  EXPECT_EQ(place.reye(one).err, "--member = 2: the sweep has members 0 to 1\n");
}

/// A sweep of two members by --slurm, with an sbatch of these words: $2 is the script.
auto through(const WithSweeps& place, const std::string& sbatch) {
  place.write("bin/sbatch", "#!/bin/bash\n" + sbatch);
  test::fs::permissions(place / "bin/sbatch", test::fs::perms::owner_all);
  const std::string path = (place / "bin").string() + ':' + std::getenv("PATH");
  return place
      .start({"/usr/bin/env", "PATH=" + path, REYE_COMMAND, "sweep", "sub/eaten.toml", "--vary", "step[1].cycles=1,2",
              "--out", "o", "--quiet", "--slurm"})
      .wait();
}

// Jobs that a sweep submits must run while it holds its folder: here an sbatch that plays them one after the other.
TEST(Sweep, ThroughSlurm) {
  const WithSweeps place;
  const auto told = through(place, "for k in 0 1; do SLURM_ARRAY_TASK_ID=$k bash \"$2\" || exit 1; done\n");
  EXPECT_EQ(told.code, 0) << told.err;
  const auto rows = rows_of(place / "o/sweep.csv");
  for (const std::size_t row : {1, 2}) EXPECT_EQ(cell(rows, row, "status"), "done");
}

// What Slurm reports of a job that it ended must reach the user as the reason of the member.
TEST(Sweep, MemberEndedBySlurm) {
  const WithSweeps place;
  const auto told = through(place,
                            "output=$(sed -n \"s/^#SBATCH --output='\\(.*\\)'$/\\1/p\" \"$2\")\n"
                            "echo 'slurmstepd: error: CANCELLED DUE TO TIME LIMIT' >\"${output/\\%3a/001}\"\n"
                            "SLURM_ARRAY_TASK_ID=0 bash \"$2\"\n");
  EXPECT_EQ(told.code, 1);
  EXPECT_EQ(told.err, "member_001 (step[1].cycles = 2): missing: slurmstepd: error: CANCELLED DUE TO TIME LIMIT\n");
}

// Bad variations, values that a member's scene refuses and folders that hold something else must end with 2 before
// anything is written or run.
TEST(Sweep, BadInput) {
  const WithSweeps place;
  place.write("taken/history.csv", "step,cycle\n");
  const auto before = place.files();
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"--vary", "contact.pad.frction=0.1", "--vary", "step[1].cycles=1:2"},
       "--vary = contact.pad.frction=0.1: unknown key; did you mean friction?\n"
       "--vary = step[1].cycles=1:2: must be key=a:b:n or key=log:a:b:n, numbers a and b (for log both > 0) and a "
       "whole "
       "number n >= 2, or key=v1,v2,...\n"},
      {{"--vary", "material.steel.nu=0.3:0.5:3", "--vary", "step[1].cycles=-1,1"},
       "member_000: step[1].cycles = -1: must be >= 0\n"
       "member_004: material.steel.nu = 0.5: must lie in (-1, 0.5)\n"},
      {{"--vary", "step[1].cycles=1", "--out", "taken"},
       "--out = taken: the output folder taken holds results of an unknown run; choose another folder with --out, or "
       "replace "
       "it with --force\n"},
  };
  for (const auto& [more, message] : cases) {
    std::vector<std::string> words = {"sweep", "sub/eaten.toml"};
    words.insert(words.end(), more.begin(), more.end());
    const auto told = place.reye(words);
    EXPECT_EQ(told.code, 2);
    EXPECT_EQ(told.err, message);
  }
  EXPECT_EQ(place.files(), before);
}

// A member of another sweep in the folder must be refused untouched, unless --force.
TEST(Sweep, AnotherSweep) {
  const WithSweeps place;
  const auto call = [&](const std::string& cycles, const std::string& flag) {
    return place.reye({"sweep", "sub/eaten.toml", "--vary", "step[1].cycles=" + cycles, "--out", "o", flag});
  };
  ASSERT_EQ(call("1,2", "--quiet").code, 0);
  const auto before = place.files("o");
  const auto refused = call("1,3", "--quiet");
  EXPECT_EQ(refused.code, 2);
  EXPECT_TRUE(refused.err.starts_with("member_001: the output folder o/member_001 holds the run of another version"))
      << refused.err;
  EXPECT_EQ(place.files("o"), before);
  EXPECT_EQ(call("1,3", "--force").code, 0);
}

// A member that the geometry refuses must be named with that reason, the others done.
TEST(Sweep, RefusedByItsGeometry) {
  const WithSweeps place;
  const auto told = place.reye({"sweep", "sub/eaten.toml", "--vary", "step[1].cycles=1", "--vary",
                                "contact.pad.secondary=slider_bottom,nothing", "--out", "o", "--quiet"});
  EXPECT_EQ(told.code, 1);
  EXPECT_TRUE(
      told.err.starts_with("member_001 (step[1].cycles = 1, contact.pad.secondary = \"nothing\"): missing: "
                           "o/member_001/scene.toml:"))
      << told.err;
  EXPECT_EQ(cell(rows_of(place / "o/sweep.csv"), 1, "status"), "done");
}

// A sweep that is interrupted must stop its members after their increment and end with 130; called again it must resume
// to the same table as an unbroken one.
TEST(Sweep, Interrupted) {
  const WithSweeps place;
  // Sixteen blocks last a second: a member of four may end before a busy machine lets the signal through.
  place.write("wearing.toml", test::changed(test::wearing, {{"cycles = 400", "cycles = 1600"}}));
  const std::vector<std::string> words = {"sweep", "wearing.toml", "--vary", "contact.pad.friction=0.4,0.5", "--jobs",
                                          "1",     "--quiet",      "--out"};
  const auto into = [&](const std::string& folder) {
    auto all = words;
    all.push_back(folder);
    return all;
  };
  auto running = place.start_reye(into("broken"));
  ASSERT_TRUE(running.signal_when(SIGINT, [&] { return test::lines(place / "broken/member_000/history.csv") > 25; }));
  EXPECT_EQ(running.wait().code, 130);
  EXPECT_TRUE(test::holds(test::read(place / "broken/member_000/summary.json"), R"("status": "interrupted")"));
  EXPECT_FALSE(test::fs::exists(place / "broken/member_001/summary.json"));
  EXPECT_EQ(place.reye(into("broken")).code, 0);
  EXPECT_EQ(place.reye(into("whole")).code, 0);
  auto broken = rows_of(place / "broken/sweep.csv"), whole = rows_of(place / "whole/sweep.csv");
  ASSERT_EQ(broken.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {  // the last three columns are times and memory
    ASSERT_GT(broken[i].size(), 3U);
    broken[i].resize(broken[i].size() - 3);
    whole[i].resize(whole[i].size() - 3);
  }
  EXPECT_EQ(broken, whole);
}

// A member that is killed must be named with its signal; the others are run all the same.
TEST(Sweep, AKilledMember) {
  if (reye::support::address_sanitizer) GTEST_SKIP() << "two seconds are too few for any member";
  const WithSweeps place;
  const std::string limited = "ulimit -S -t 2; exec \"$0\" \"$@\"";  // seconds of CPU: too few for the fine mesh
  const auto told = place
                        .start({"/bin/bash", "-c", limited, REYE_COMMAND, "sweep", "sub/eaten.toml", "--vary",
                                "body.base.mesh.far_size_mm=0.02,0.5", "--vary", "step[1].cycles=2000", "--vary",
                                "contact.pad.wear.secondary_per_MPa=1e-12", "--out", "o", "--quiet"})
                        .wait();
  EXPECT_EQ(told.code, 1);
  EXPECT_TRUE(test::holds(told.err, "member_000 (body.base.mesh.far_size_mm = 0.02, step[1].cycles = 2000, "))
      << told.err;
  EXPECT_TRUE(test::holds(told.err, "ended by signal 24")) << told.err;
  EXPECT_EQ(cell(rows_of(place / "o/sweep.csv"), 2, "status"), "done");
}
