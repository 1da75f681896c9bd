#include "command.hpp"

using namespace reye;

namespace {

using test::Changes;

/// geo/life_band with some texts replaced.
struct WithScene : test::Place {
  explicit WithScene(const Changes& changes = {}) {
    const auto folder = test::fs::path(REYE_SOURCE_DIR) / "geo/life_band";
    write("disc_on_flat.geo", test::read(folder / "disc_on_flat.geo"));
    write("band.toml", test::changed(test::read(folder / "scene.toml"), changes));
  }
};

/// The number behind the name in the summary, searched from `after` on.
double figure(const std::string& summary, const std::string& after, const std::string& name) {
  const auto at = summary.find('"' + name + "\": ", summary.find('"' + after + '"'));
  if (at == std::string::npos) throw std::runtime_error("the summary does not say " + name);
  return std::stod(summary.substr(at + name.size() + 4));
}

std::string text_of(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

/// The life of a run of its own at so many times the coefficients, its jumps that much shorter.
double direct_life(double factor) {
  const WithScene place(Changes{{"= 3.0e-5", "= " + text_of(factor * 3.0e-5)},
                                {"= 2.0e-5", "= " + text_of(factor * 2.0e-5)},
                                {"cycles = 2000", "cycles = " + text_of(2000.0 / factor)},
                                {"jump = 100", "jump = " + text_of(100.0 / factor)}});
  EXPECT_EQ(place.reye({"run", "band.toml", "--out", "o", "--quiet"}).code, 0);
  return figure(test::read(place / "o/summary.json"), "life_cycles", "life");
}

}  // namespace

// The ends of the band must be the lives of runs at these coefficients themselves, with jumps that remove the same
// volume.
TEST(LifeBand, EndsAreThoseOfDirectRuns) {
  const WithScene place(Changes{{"[0.5, 2.0]", "[0.5, 3.0]"}});
  ASSERT_EQ(place.reye({"run", "band.toml", "--out", "o", "--quiet"}).code, 0);
  const auto summary = test::read(place / "o/summary.json");
  const double life = figure(summary, "life_cycles", "life");
  EXPECT_GT(life, 300.0);  // some blocks of wear lie behind it
  EXPECT_DOUBLE_EQ(figure(summary, "life_band", "shortest_cycles"), life / 3.0);
  EXPECT_NEAR(figure(summary, "life_band", "shortest_cycles") / direct_life(3.0), 1.0, 1e-9);
  EXPECT_NEAR(figure(summary, "life_band", "longest_cycles") / direct_life(0.5), 1.0, 1e-9);
  const auto plan = place.reye({"plan", "band.toml"});
  EXPECT_TRUE(
      test::holds(plan.out, "limit \"life\": all wear coefficients times 0.5 to 3; the band is life / factor, since "))
      << plan.out;
}

// Where lives do not go as 1 / coefficient a band must be refused with the cause.
TEST(LifeBand, RefusedWhereItDoesNotHold) {
  const std::vector<std::pair<std::pair<std::string, std::string>, std::string>> cases = {
      {{"law = \"energy\",", "law = \"energy\", threshold_mJ_per_mm2 = 1.0,"},
       "contact \"pad\" has a threshold of wear"},
      {{"friction  = 0.75", "friction  = { cycles = [0, 100], value = [0.6, 0.9] }"},
       "the friction of contact \"pad\" changes over the cycles"},
      {{"increments = 2\nwear = false", "increments = 2"}, "more than one step wears"},
      {{"increments = 2\nwear = false", "increments = 2\nwear = false\ncycles = 10"},
       "cycles are counted before the step that wears"},
      {{"cycles = 2000\njump = 100\n", ""}, "the step that wears has no cycles"},
  };
  for (const auto& [change, cause] : cases) {
    const WithScene place(Changes{change});
    const auto told = place.reye({"check", "band.toml"});
    EXPECT_EQ(told.code, 2);
    EXPECT_TRUE(test::holds(
        told.err, "limit.life.wear_factor = [0.5, 2.0]: " + cause +
                      ", so that lives do not scale as 1 / factor; vary the coefficients in a sweep instead\n"))
        << told.err;
  }
  EXPECT_TRUE(test::holds(WithScene(Changes{{"[0.5, 2.0]", "[2.0, 0.5]"}}).reye({"check", "band.toml"}).err,
                          "limit.life.wear_factor = [2.0, 0.5]: must be [lowest, highest]\n"));
}
