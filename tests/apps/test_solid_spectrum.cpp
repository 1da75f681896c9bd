#include <nlohmann/json.hpp>
#include <sstream>

#include "solid_scenes.hpp"

using namespace reye;

namespace {

/// The worn rubbing ball with these steps after the one that presses, and beside its stroke one half as long.
std::string rubbed(const std::string& steps) {
  return test::changed(
      test::worn_rubbing(),
      {{"[[step]]\nname = \"rub\"\nplay = [\"stroke\"]\nincrements = 8\ncycles = 3\n", steps},
       {"{ motion_mm = 0.002, history = \"stroke\" }",
        "[{ motion_mm = 0.002, history = \"stroke\" }, { motion_mm = 0.002, history = \"half\" }]"},
       {"[[step]]\nname = \"press\"",
        "half   = [[0.0, 0.0], [0.25, 0.5], [0.75, -0.5], [1.0, 0.0]]\nnothing = [[0.0, 0.0], [1.0, 0.0]]\n\n"
        "[[step]]\nname = \"press\""}});
}

std::string step(const std::string& name, const std::string& history, int cycles) {
  return "[[step]]\nname = \"" + name + "\"\nplay = [\"" + history +
         "\"]\nincrements = 8\ncycles = " + std::to_string(cycles) + "\n\n";
}

nlohmann::json summary_of(const test::Place& place, const std::string& name) {
  const auto told = place.reye({"run", name + ".toml", "--out", name, "--quiet"});
  EXPECT_EQ(told.code, 0) << told.err;
  return nlohmann::json::parse(test::read(place / (name + "/summary.json")));
}

}  // namespace

// A spectrum of solids must be the steps that it stands for, at its levels and as often as it says, to the last bit.
TEST(SolidSpectrum, IsTheStepsItStandsFor) {
  const test::Place place;
  place.write("rubbing.geo", test::rubbing_geo);
  place.write("levels.csv", "level,cycles\n1,2\n0.5,1\n");
  place.write("spectrum.toml", rubbed(step("rub", "stroke", 1) +
                                      "[spectrum]\nsteps = [\"rub\"]\nlevels = \"levels.csv\"\ntimes = 2\n\n"));
  place.write("steps.toml",
              rubbed(step("a", "stroke", 2) + step("b", "half", 1) + step("c", "stroke", 2) + step("d", "half", 1)));
  const auto spectrum = summary_of(place, "spectrum"), steps = summary_of(place, "steps");
  EXPECT_EQ(spectrum.at("cycles").get<double>(), 6.0);
  EXPECT_GT(spectrum.at("contacts").at("pad").at("secondary").at("worn_volume_mm3").get<double>(), 0.0);
  EXPECT_EQ(spectrum.at("contacts").dump(), steps.at("contacts").dump());
}

// Cycles in which nothing moves must end, though points rest on the cone where round-off says by turns that they stick
// and slip, without a cut-back and with at most three iterations an increment. The first increment may take as many as
// one that rubs: it settles what the last stroke wore off, and how many it needs depends on the mesh.
TEST(SolidSpectrum, AStepAtRestRests) {
  const test::Place place;
  place.write("rubbing.geo", test::rubbing_geo);
  place.write("rest.toml", rubbed(step("rub", "stroke", 2) + step("rest", "nothing", 3)));
  const auto summary = summary_of(place, "rest");
  EXPECT_EQ(summary.at("counts").at("cutbacks").get<int>(), 0);
  const auto rows = test::lines(place / "rest/history.csv");
  EXPECT_EQ(rows, 1 + 4 + 8 * 5);
  std::istringstream history(test::read(place / "rest/history.csv"));
  int resting = 0;
  for (std::string row; std::getline(history, row);) {
    if (row.rfind("rest,", 0) != 0) continue;
    std::istringstream cells(row);
    std::string cell;
    for (int k = 0; k < 4; ++k) std::getline(cells, cell, ',');
    EXPECT_LE(std::stoi(cell), resting++ == 0 ? 8 : 3) << row.substr(0, 40);
  }
  EXPECT_EQ(resting, 8 * 3);
}
