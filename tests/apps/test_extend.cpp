#include <nlohmann/json.hpp>

#include "command.hpp"
#include "same_results.hpp"
#include "scenes.hpp"

using namespace reye;

namespace {

using test::Changes;

/// The small wearing contact, whose scene is rewritten with other values.
struct Extended : test::Place {
  Extended() { write("wearing.geo", test::wearing_geo); }

  void scene(const Changes& changes) const { write("wearing.toml", test::changed(test::wearing, changes)); }

  test::Told run(const Changes& changes, const std::string& folder, bool restart = false) const {
    scene(changes);
    std::vector<std::string> words{"run", "wearing.toml", "--out", folder, "--quiet"};
    if (restart) words.push_back("--restart");
    return reye(words);
  }

  nlohmann::json summary(const std::string& folder) const {
    return nlohmann::json::parse(test::read(*this / (folder + "/summary.json")));
  }
};

Changes cycles(const std::string& count) { return {{"cycles = 400", "cycles = " + count}}; }

Changes stop_at(const std::string& depth, const std::string& count = "400") {
  return {{"cycles = 400", "cycles = " + count}, {"depth_mm = 2e-5", "depth_mm = " + depth + "\nstop = true"}};
}

}  // namespace

// A run that has ended and gets more cycles must end with the bytes of a run that had them from the start, whether its
// last block was whole or shortened, and as often as that is done.
TEST(Extend, MoreCyclesSameBytes) {
  const Extended place;
  ASSERT_EQ(place.run(cycles("400"), "whole").code, 0);
  for (const char* first : {"200", "230"}) {
    test::fs::remove_all(place / "o");
    ASSERT_EQ(place.run(cycles(first), "o").code, 0);
    ASSERT_EQ(place.run(cycles("300"), "o", true).code, 0);
    const auto told = place.run(cycles("400"), "o", true);
    ASSERT_EQ(told.code, 0) << told.err;
    test::expect_same(place, "whole", "o");
  }
  EXPECT_TRUE(
      test::holds(test::read(place / "o/log.txt"), "extended: step[1].cycles = 400: was 300 in the run to be resumed"));
}

// A run that ended at a limit and whose limit is raised, or taken away, must resume to the bytes of a run that had it
// so from the start; so must one that gets a limit more, on its way or at its end.
TEST(Extend, OtherLimitsSameBytes) {
  const Extended place;
  const Changes none{{"[limit.life]\ncontact  = \"pad\"\ndepth_mm = 2e-5\n", ""}};
  const std::string extra = "\n[limit.more]\ncontact = \"pad\"\narea_mm2 = ";
  const auto with = [&](const std::string& area) {
    return Changes{{"depth_mm = 2e-5", "depth_mm = 2e-5" + extra + area}, {"cycles = 400", "cycles = 500"}};
  };
  const std::vector<std::pair<Changes, Changes>> cases{
      {stop_at("2e-5"), stop_at("5e-5")}, {stop_at("2e-5"), none}, {cycles("300"), with("3.4e-6")}};
  for (const auto& [before, after] : cases) {
    for (const char* folder : {"whole", "o"}) test::fs::remove_all(place / folder);
    ASSERT_EQ(place.run(after, "whole").code, 0);
    ASSERT_EQ(place.run(before, "o").code, 0);
    const auto told = place.run(after, "o", true);
    ASSERT_EQ(told.code, 0) << told.err;
    test::expect_same(place, "whole", "o");
  }
  EXPECT_FALSE(place.summary("o").at("life_cycles").at("more").is_null()) << "it was to be reached";
}

// Under a tolerance, where the blocks before the end know of it, an extended run must agree with one in one go within
// the tolerance.
TEST(Extend, UnderATolerance) {
  const Extended place;
  const auto controlled = [](const char* count) {
    return Changes{
        {"cycles = 400\njump = 100", std::string("cycles = ") + count + "\njump = { tolerance = 0.02, first = 10 }"}};
  };
  ASSERT_EQ(place.run(controlled("600"), "whole").code, 0);
  ASSERT_EQ(place.run(controlled("250"), "o").code, 0);
  const auto told = place.run(controlled("600"), "o", true);
  ASSERT_EQ(told.code, 0) << told.err;
  const auto whole = place.summary("whole"), extended = place.summary("o");
  EXPECT_EQ(extended.at("cycles").get<double>(), 600.0);
  EXPECT_LE(extended.at("estimated_error").at("cycle_jump").get<double>(), 0.02);
  for (const char* side : {"secondary", "primary"}) {
    const double a = whole.at("contacts").at("pad").at(side).at("max_depth_mm"),
                 b = extended.at("contacts").at("pad").at(side).at("max_depth_mm");
    EXPECT_NEAR(b / a, 1.0, 0.02) << side;
  }
  EXPECT_EQ(test::lines(place / "whole/series.pvd"), test::lines(place / "o/series.pvd"));
}

// Killed while it resumes, an extended run must still resume to the same bytes.
TEST(Extend, KilledOnTheWay) {
  const Extended place;
  ASSERT_EQ(place.run(cycles("500"), "whole").code, 0);
  for (const long rows : {36L, 52L}) {
    test::fs::remove_all(place / "o");
    ASSERT_EQ(place.run(cycles("200"), "o").code, 0);
    place.scene(cycles("500"));
    auto run = place.start_reye({"run", "wearing.toml", "--out", "o", "--restart", "--quiet"});
    ASSERT_TRUE(run.signal_when(SIGKILL, [&] { return test::lines(place / "o/history.csv") > rows; }));
    run.wait();
    const auto told = place.reye({"run", "wearing.toml", "--out", "o", "--restart", "--quiet"});
    ASSERT_EQ(told.code, 0) << told.err;
    test::expect_same(place, "whole", "o");
  }
}

// A run that is over, at its last cycle or at a limit, must play nothing when it resumes unchanged.
TEST(Extend, NothingIsExtended) {
  const Extended place;
  for (const auto& changes : {cycles("200"), stop_at("2e-5")}) {
    test::fs::remove_all(place / "o");
    ASSERT_EQ(place.run(changes, "o").code, 0);
    test::fs::remove_all(place / "before");
    test::fs::copy(place / "o", place / "before", test::fs::copy_options::recursive);
    ASSERT_EQ(place.run(changes, "o", true).code, 0);
    test::expect_same(place, "before", "o");
  }
}

// Changes that a run cannot take when it resumes must be refused with line, key and rule, all of it at once, and
// nothing be written.
TEST(Extend, Refused) {
  const Extended place;
  ASSERT_EQ(place.run(cycles("300"), "o").code, 0);
  const auto before = place.files("o");
  const std::string run =
      " in the run to be resumed; it takes other limits and more cycles of its last step, nothing else";
  const std::string step = "\n[[step]]\nname = \"more\"\nplay = [\"stroke\"]\ncycles = 5\n[limit.life]";
  const std::vector<std::pair<Changes, std::vector<std::string>>> cases{
      {cycles("250"), {"wearing.toml:49: step[1].cycles = 250: the run has played 300 cycles of this step already"}},
      {{{"cycles = 400", "cycles = 300"}, {"depth_mm = 2e-5", "depth_mm = 3e-5"}},
       {"wearing.toml:54: limit.life.depth_mm = 3e-05: the run has passed it already: it stands at "}},
      {{{"E_MPa = 200e3", "E_MPa = 210e3"}, {"jump = 100", "jump = 50"}},
       {"wearing.toml:5: material.steel.E_MPa = 210e3: was 200e3" + run,
        "wearing.toml:50: step[1].jump = 50: was 100" + run}},
      {{{"cycles = 400", "cycles = 300"}, {"\n[limit.life]", step}}, {"wearing.toml:52: step[2]: was not" + run}},
      {{{"nu    = 0.3\n", "nu    = 0.3\n#\n"},
        {"probes = { edge = { body = \"flat\", at_mm = [0.5, 0.0] } }\n", ""},
        {"cycles = 400", "cycles = 300"}},
       {"wearing.toml:57: output.probes: is missing, and was" + run}}};
  for (const auto& [changes, sentences] : cases) {
    const auto told = place.run(changes, "o", true);
    EXPECT_EQ(told.code, 2) << told.err;
    for (const auto& sentence : sentences)
      EXPECT_TRUE(test::holds(told.err, sentence)) << told.err << "\nexpected: " << sentence;
    EXPECT_EQ(place.files("o"), before);
  }
  place.write("wearing.geo", std::string(test::wearing_geo) + "// changed\n");
  const auto told = place.run(cycles("400"), "o", true);
  EXPECT_EQ(told.code, 2);
  EXPECT_TRUE(test::holds(told.err,
                          "wearing.toml:2: geometry: its files, or those of profiles, differ from those of the run to "
                          "be resumed; it takes"))
      << told.err;
}
