#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "places.hpp"
#include "scenes.hpp"
#include "solid_scenes.hpp"

using namespace reye;

namespace {

using test::changed;
using test::Changes;
using Rows = std::vector<std::array<double, 2>>;

using Row = std::vector<std::string>;

std::vector<Row> rows_of(const std::string& table) {
  std::vector<Row> rows;
  std::istringstream in(table);
  for (std::string line; std::getline(in, line);) {
    std::istringstream split(line);
    rows.emplace_back();
    for (std::string cell; std::getline(split, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

/// The scar of a surface table at a cycle: x [mm] and depth [mm].
std::vector<std::array<double, 2>> scar_at(const std::string& table, double cycle) {
  std::vector<std::array<double, 2>> scar;
  for (const auto& row : rows_of(table))
    if (row[0] != "frame" && std::stod(row[1]) == cycle) scar.push_back({std::stod(row[4]), std::stod(row[9])});
  std::sort(scar.begin(), scar.end());
  return scar;
}

/// What a profilometer has of a side of the run in `truth`: an offset, a tilt and an origin of its own, five traces
/// away, and noise of 2 % of the depth.
void write_scar(const test::Place& place, const std::string& side, double cycle, const std::string& file) {
  const auto scar = scar_at(test::read(place / ("truth/surface_pad_" + side + ".csv")), cycle);
  double deepest = 0.0;
  for (const auto& [x, depth] : scar) deepest = std::max(deepest, depth);
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 0.02 * deepest);
  std::ostringstream text;
  text.precision(12);
  text << "x_mm,depth_mm\n";
  for (int i = 0; i <= 300; ++i) {
    const double x = -0.09 + 0.0006 * i;
    const auto above = std::lower_bound(scar.begin(), scar.end(), std::array{x, -1.0});
    const auto below = above - 1;
    const double depth = (*below)[1] + ((*above)[1] - (*below)[1]) * (x - (*below)[0]) / ((*above)[0] - (*below)[0]);
    text << x + 0.9 << ',' << depth + 3e-4 + 1e-3 * x + noise(random) << '\n';
  }
  place.write(file, text.str());
}

/// The place of a column in a table.
std::size_t column(const std::vector<Row>& rows, const std::string& name) {
  return static_cast<std::size_t>(std::find(rows.at(0).begin(), rows[0].end(), name) - rows[0].begin());
}

/// The loop of the last cycle: tangential force over the motion of the shaker, whose zero is the sensor's own.
void write_loop(const test::Place& place, const std::string& file) {
  const auto rows = rows_of(test::read(place / "truth/history.csv"));
  std::ostringstream text;
  text.precision(12);
  text << "stroke_mm,force_N_per_mm\n";
  for (std::size_t i = rows.size() - 16; i < rows.size(); ++i) {
    const double t = std::stod(rows[i].at(column(rows, "progress")));
    const double stroke = t < 0.25 ? 4.0 * t : t < 0.75 ? 2.0 - 4.0 * t : 4.0 * t - 4.0;
    text << 1.0 + 0.004 * stroke << ',' << 7.0 - std::stod(rows[i].at(column(rows, "pad_tangential_force_N_per_mm")))
         << '\n';
  }
  place.write(file, text.str());
}

/// Ten blocks to the life of the rig's scar.
const std::string& finer() {
  static const std::string text = changed(test::wearing, Changes{{"jump = 100", "jump = 40"}});
  return text;
}
constexpr int increments_of_a_run = 162;

/// Both coefficients as the rig has them: 1.3 and 1.6 times those of the scene.
struct Rig : test::WithWearing {
  explicit Rig(const Changes& law = {{"= 2.0e-5", "= 3.2e-5"}}) : WithWearing(finer()) {
    write("truth.toml", changed(changed(finer(), Changes{{"= 3.0e-5", "= 3.9e-5"}}), law));
    EXPECT_EQ(reye({"run", "truth.toml", "--out", "truth", "--quiet"}).code, 0);
    write_scar(*this, "secondary", 400.0, "flat.csv");
    write_scar(*this, "secondary", 200.0, "half.csv");
    write_scar(*this, "primary", 400.0, "disc.csv");
    write_loop(*this, "loop.csv");
  }
  nlohmann::json result() const { return nlohmann::json::parse(test::read(*this / "out/calibration.json")); }
};

}  // namespace

// The coefficients of both sides must be found from a profile of each, and the scene with them must run.
TEST(Calibrate, BothSides) {
  const Rig rig;
  rig.write("scars.toml",
            "[[scar]]\nfile = \"flat.csv\"\nside = \"secondary\"\n[[scar]]\nfile = \"disc.csv\"\nside = \"primary\"\n");
  const auto told = rig.reye({"calibrate", "wearing.toml", "--measured", "scars.toml", "--at", "400", "--out", "out"});
  ASSERT_EQ(told.code, 0) << told.err;
  const auto result = rig.result();
  ASSERT_EQ(result["values"].size(), 2u);
  for (const int k : {0, 1}) {
    const auto& fitted = result["values"][k];
    const double truth = k == 0 ? 3.9e-5 : 3.2e-5;
    EXPECT_NEAR(fitted["fitted"].get<double>() / truth, 1.0, 0.02) << fitted;
    EXPECT_LT(fitted["low_95"].get<double>(), truth * 1.005);
    EXPECT_GT(fitted["high_95"].get<double>(), truth * 0.995);
  }
  EXPECT_NEAR(result["scars"][0]["moved_mm"][0].get<double>(), -0.9, 2e-4);
  EXPECT_NEAR(result["scars"][0]["tilt"][0].get<double>(), 1e-3, 1e-4);
  EXPECT_TRUE(result["poor"].is_null()) << result["poor"];
  EXPECT_LE(result["increments"].get<int>(), 4 * increments_of_a_run);
  EXPECT_TRUE(test::holds(test::read(rig / "out/calibration.html"), "scar-1"));
  EXPECT_EQ(rig.reye({"check", "out/scene.toml"}).code, 0);
  EXPECT_TRUE(test::holds(test::read(rig / "out/scene.toml"), "wear_factor"));
}

// From one side the common factor must be found, and the page must say that the ratio is the scene's.
TEST(Calibrate, OneSide) {
  const Rig rig;
  const auto told = rig.reye(
      {"calibrate", "wearing.toml", "--measured", "flat.csv", "--side", "secondary", "--at", "400", "--out", "out"});
  ASSERT_EQ(told.code, 0) << told.err;
  const auto result = rig.result();
  EXPECT_NEAR(result["values"][0]["fitted"].get<double>() / result["values"][1]["fitted"].get<double>(), 1.5, 1e-6);
  EXPECT_TRUE(test::holds(told.out, "Only the secondary side was measured"));
  EXPECT_LE(result["increments"].get<int>(), 1.5 * increments_of_a_run);
}

// One coefficient must be found from guesses a thousand times too small and too large.
TEST(Calibrate, AnyGuess) {
  const Rig rig;
  for (const std::string exponent : {"e-8", "e-2"}) {
    rig.write("guess.toml", changed(finer(), Changes{{"3.0e-5", "3.0" + exponent},
                                                     {"2.0e-5", "2.0" + exponent},
                                                     {"jump = 40", "jump = { tolerance = 0.02 }"}}));
    const auto told = rig.reye({"calibrate", "guess.toml", "--measured", "flat.csv", "--side", "secondary", "--at",
                                "400", "--out", "out", "--force"});
    ASSERT_EQ(told.code, 0) << told.err;
    const auto result = rig.result();
    EXPECT_NEAR(result["values"][0]["fitted"].get<double>() / 3.9e-5, 1.0, 0.06) << exponent;
    EXPECT_LE(result["runs"].get<int>(), 4) << exponent;
  }
}

// A number with its scatter must give its interval; without it the interval is refused with the reason.
TEST(Calibrate, ANumber) {
  const Rig rig;
  const auto summary = nlohmann::json::parse(test::read(rig / "truth/summary.json"));
  const auto area = summary["contacts"]["pad"]["secondary"]["worn_area_mm2"].dump();
  const auto scar = "[[figure]]\nside = \"secondary\"\ncycles = 400\narea_mm2 = " + area + "\n";
  rig.write("bare.toml", scar);
  const auto refused = rig.reye({"calibrate", "wearing.toml", "--measured", "bare.toml", "--out", "out"});
  EXPECT_EQ(refused.code, 1) << refused.out;
  EXPECT_TRUE(test::holds(refused.err, "scatter")) << refused.err;
  EXPECT_FALSE(test::fs::exists(rig / "out"));
  rig.write("number.toml", scar + "scatter = 0.1\n");
  const auto told = rig.reye({"calibrate", "wearing.toml", "--measured", "number.toml", "--out", "out"});
  ASSERT_EQ(told.code, 0) << told.err;
  const nlohmann::json fitted = rig.result()["values"][0];
  const double value = fitted["fitted"], low = fitted["low_95"], high = fitted["high_95"];
  EXPECT_LT(low, value);
  EXPECT_LT(value, high);
  EXPECT_NEAR(std::log(high / low), 2.0 * 1.96 * 0.1, 0.08);  // area in proportion to the coefficient, nearly
}

// Bad input must be refused before anything runs: where nothing wears, and in a folder of something else.
TEST(Calibrate, Refusals) {
  const Rig rig;
  rig.write("mild.toml", changed(finer(), Changes{{"wear      = {", "#"}}));
  const auto unworn =
      rig.reye({"calibrate", "mild.toml", "--measured", "flat.csv", "--side", "secondary", "--at", "400"});
  EXPECT_EQ(unworn.code, 2);
  EXPECT_TRUE(test::holds(unworn.err, "mild.toml:")) << unworn.err;
  EXPECT_TRUE(test::holds(unworn.err, "no contact of the scene wears")) << unworn.err;
  const auto other = rig.reye(
      {"calibrate", "wearing.toml", "--measured", "flat.csv", "--side", "secondary", "--at", "400", "--out", "truth"});
  EXPECT_EQ(other.code, 2);
  EXPECT_TRUE(test::holds(other.err, "holds something else")) << other.err;
}

// A threshold of wear, for which no two coefficients have the same scars, must be found by runs of its own.
TEST(Calibrate, AThresholdByRuns) {
  const Changes law{{"primary_mm3_per_J = 2.0e-5", "primary_mm3_per_J = 2.0e-5, threshold_mJ_per_mm2 = 300.0"}};
  const Rig rig(law);
  rig.write("start.toml", changed(finer(), Changes{{"primary_mm3_per_J = 2.0e-5",
                                                    "primary_mm3_per_J = 2.4e-5, threshold_mJ_per_mm2 = 200.0"}}));
  rig.write("scars.toml",
            "[[scar]]\nfile = \"flat.csv\"\nside = \"secondary\"\n[[scar]]\nfile = \"half.csv\"\nside = "
            "\"secondary\"\ncycles = 200\n");
  const auto told = rig.reye({"calibrate", "start.toml", "--measured", "scars.toml", "--at", "400", "--out", "out",
                              "--free", "contact.pad.wear.threshold_mJ_per_mm2=0:800"});
  ASSERT_EQ(told.code, 0) << told.err;
  const auto values = rig.result()["values"];
  EXPECT_NEAR(values[0]["fitted"].get<double>() / 3.9e-5, 1.0, 0.05) << values;
  EXPECT_NEAR(values[2]["fitted"].get<double>() / 300.0, 1.0, 0.15) << values;
}

// Friction must be found from the energy of a measured loop alone.
TEST(Calibrate, FrictionFromALoop) {
  const Rig rig;
  rig.write("loops.toml", "[[loop]]\nfile = \"loop.csv\"\ncycles = 400\nscatter = 0.01\n");
  const auto told = rig.reye({"calibrate", "wearing.toml", "--measured", "loops.toml", "--out", "out", "--free",
                              "contact.pad.friction=0.2:0.9"});
  ASSERT_EQ(told.code, 0) << told.err;
  const auto values = rig.result()["values"];
  ASSERT_EQ(values.size(), 1u);
  EXPECT_NEAR(values[0]["fitted"].get<double>(), 0.5, 0.02) << values;
}

// A map of a solid's face must give the coefficient with which the ball has worn it, wherever the instrument's zero
// lies.
TEST(Calibrate, AMapOfASolid) {
  const test::WithRubbing place;
  const auto worn = [](const char* coefficient) {
    return changed(test::rubbing,
                   Changes{{"friction  = 0.3\n",
                            std::string("friction  = 0.3\nwear = { law = \"energy\", secondary_mm3_per_J = ") +
                                coefficient + " }\n"},
                           {"increments = 4\n", "increments = 4\nwear = false\n"},
                           {"cycles = 3", "cycles = 20\njump = 2"},
                           {"last_block = true", "every_cycles = 20"}});
  };
  place.write("truth.toml", worn("1.25e-2"));
  place.write("guess.toml", worn("1e-2"));
  ASSERT_EQ(place.reye({"run", "truth.toml", "--out", "truth", "--quiet"}).code, 0);
  const auto rows = rows_of(test::read(place / "truth/surface_pad_secondary.csv"));
  std::ostringstream map;
  map << "x_mm,y_mm,height_um\n";
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 1e-3);
  for (const auto& row : rows) {
    if (row[0] == "frame" || std::stod(row[1]) != 20.0) continue;
    const double x = std::stod(row[column(rows, "x_mm")]), y = std::stod(row[column(rows, "y_mm")]);
    const double depth = 1e3 * std::stod(row[column(rows, "wear_depth_mm")]);
    map << x << ',' << y << ',' << 0.3 + 0.5 * x - depth + noise(random) << '\n';
  }
  place.write("map.csv", map.str());
  const auto told = place.reye({"calibrate", "guess.toml", "--measured", "map.csv", "--at", "20", "--out", "out"});
  ASSERT_EQ(told.code, 0) << told.err;
  const auto result = nlohmann::json::parse(test::read(place / "out/calibration.json"));
  EXPECT_NEAR(result["values"][0]["fitted"].get<double>() / 1.25e-2, 1.0, 0.03) << result.dump(1);
  EXPECT_TRUE(test::fs::exists(place / "out/figures/scar-0-b.svg"));
}
