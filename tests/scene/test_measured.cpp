#include "scene/measured.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "example.hpp"
#include "folder.hpp"
#include "scene/read.hpp"

using namespace reye;
using scene::History;

namespace {

double at(const History& h, double x) {
  std::size_t i = 1;
  while (i + 1 < h.size() && h[i][0] < x) ++i;
  return h[i - 1][1] + (h[i][1] - h[i - 1][1]) * (x - h[i - 1][0]) / (h[i][0] - h[i - 1][0]);
}

const std::string stroke = "stroke = [[0.0, 0.0], [0.25, 1.0], [0.75, -1.0], [1.0, 0.0]]";

/// The example with its stroke measured, `csv` in load.csv.
struct Read {
  explicit Read(const std::string& csv, const std::string& table, const std::string& levels = {},
                const std::string& spectrum = {}) {
    const test::Folder folder;
    test::Folder::write("cylinder_on_flat.step", "ISO-10303-21;");
    test::Folder::write("load.csv", csv);
    test::Folder::write("levels.csv", levels);
    test::Folder::write("scene.toml", test::replaced(test::example, stroke, "stroke = " + table) + spectrum);
    try {
      scene = scene::read("scene.toml");
    } catch (const base::InputError& error) {
      refusal = error.what();
    }
  }
  scene::Scene scene;
  std::string refusal;
};

}  // namespace

// Lines between the points that are left must stay within the band of all points, first and last kept; a smooth curve
// must need few of them, and a straight line its ends alone.
TEST(Measured, ThinnedStaysWithinTheBand) {
  History all;
  for (int i = 0; i <= 20000; ++i) {
    const double t = i / 20000.0;
    all.push_back({t, std::sin(20.0 * t) + 0.2 * std::sin(300.0 * t) + 1e-3 * std::sin(1e5 * t)});
  }
  for (const double band : {0.1, 0.01, 0.003}) {
    const auto kept = scene::thinned(all, band);
    EXPECT_EQ(kept.front(), all.front());
    EXPECT_EQ(kept.back(), all.back());
    EXPECT_LT(kept.size(), 800u) << band;
    for (const auto& point : all) EXPECT_LE(std::abs(at(kept, point[0]) - point[1]), band * (1.0 + 1e-9));
  }
  EXPECT_EQ(scene::thinned({{0.0, 0.0}, {0.3, 0.3}, {0.5, 0.5}, {1.0, 1.0}}, 0.0).size(), 2u);
  EXPECT_EQ(scene::thinned({{0.0, 0.0}, {0.5, 0.6}, {1.0, 1.0}}, 0.0).size(), 3u);
}

// A file's time must become progress, its column the factors; the scene must say how many points are left.
TEST(Measured, HistoryOfAFile) {
  const Read read("time_s,other,mm\n10,7,0\n12,7,2\n13,7,3\n16,7,-1\n20,7,0\n",
                  R"({ file = "load.csv", column = "mm" })");
  ASSERT_EQ(read.refusal, "");
  EXPECT_EQ(read.scene.histories.at("stroke"), (History{{0.0, 0.0}, {0.3, 3.0}, {0.6, -1.0}, {1.0, 0.0}}));
  const auto& measured = read.scene.measured.at("stroke");
  EXPECT_EQ(measured.points, 5u);
  EXPECT_EQ(measured.duration_s, 10.0);
  EXPECT_EQ(measured.way_lost, 0.0);
}

// A series that does not end where it began must be closed where that is asked for, and refused with the mend else.
TEST(Measured, Closed) {
  const std::string csv = "time_s,mm\n0,0\n1,2\n2,-1\n3,0.5\n";
  const Read open(csv, R"({ file = "load.csv" })");
  EXPECT_NE(open.refusal.find("ends a cycle at 0.5 and began it at 0; give it the way back: close = true in its table"),
            std::string::npos)
      << open.refusal;
  const Read closed(csv, R"({ file = "load.csv", close = true })");
  ASSERT_EQ(closed.refusal, "");
  EXPECT_EQ(closed.scene.histories.at("stroke"),
            (History{{0.0, 0.0}, {0.25, 2.0}, {0.5, -1.0}, {0.75, 0.5}, {1.0, 0.0}}));
}

// Oscillations that thinning leaves out shorten the way: the scene must warn of it.
TEST(Measured, LostWayIsWarnedOf) {
  std::string csv = "progress,mm\n0,0\n";
  for (int i = 1; i < 1000; ++i)
    csv += std::to_string(i / 1000.0) + ',' + std::to_string(std::sin(0.00628318530718 * i) + 5e-3 * (i % 2)) + '\n';
  csv += "1,0\n";
  const Read read(csv, R"({ file = "load.csv", tolerance = 0.02 })");
  ASSERT_EQ(read.refusal, "");
  EXPECT_GT(read.scene.measured.at("stroke").way_lost, 0.2);
  const auto& warnings = read.scene.warnings;
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const std::string& line) {
    return line.find("its way up and down is") != std::string::npos;
  }));
}

// Files that cannot serve must be refused with line and reason.
TEST(Measured, Refusals) {
  const auto refusal = [](const std::string& csv, const std::string& more = {}) {
    const auto text = Read(csv, R"({ file = "load.csv")" + more + " }").refusal;
    const auto colon = text.rfind("\": ");
    return colon == std::string::npos ? text : text.substr(colon + 3);
  };
  EXPECT_EQ(refusal("t,mm\n0,0\n1,0\n"), "its first column must be time_s or progress, and is \"t\"");
  EXPECT_EQ(refusal("t\x1b[31m,mm\n0,0\n1,0\n"), "its first column must be time_s or progress, and is \"t\\x1b[31m\"");
  EXPECT_EQ(refusal("time_s,mm\n0,0\n2,1\n1,0\n"), "line 4: time_s must increase");
  EXPECT_EQ(refusal("time_s,mm\n0,0\nx,1\n"), "line 3: must be two numbers with a comma between them");
  EXPECT_EQ(refusal("progress,mm\n0,0\n0.5,1\n"), "progress must begin at 0 and end at 1");
  EXPECT_EQ(refusal("time_s\n0\n1\n"), "needs a second column, of factors");
  EXPECT_EQ(refusal("time_s,mm\n0,0\n"), "needs at least two rows of numbers");
  EXPECT_EQ(refusal("time_s,mm,N\n0,0,0\n1,0,0\n", ", column = \"kN\""),
            "has no column \"kN\" of factors, but time_s, mm, N");
  EXPECT_EQ(refusal(""), "is empty");
  const Read none("time_s,mm\n0,0\n1,0\n", R"({ file = "gone.csv" })");
  EXPECT_NE(none.refusal.find("no such file"), std::string::npos);
}

// A spectrum's levels must play its steps at each level in turn, as often as asked, with the cycles of the file.
TEST(Measured, LevelsOfASpectrum) {
  const std::string spectrum = "\n[spectrum]\nsteps = [\"wear\"]\nlevels = \"levels.csv\"\ntimes = 3\n";
  const Read read("", stroke.substr(9), "level,cycles\n1.0,1000\n0.5,20000\n0.2,50\n", spectrum);
  ASSERT_EQ(read.refusal, "");
  ASSERT_EQ(read.scene.steps.size(), 2u + 9u);
  for (int k = 0; k < 3; ++k) {
    const auto* steps = &read.scene.steps[2 + 3 * static_cast<std::size_t>(k)];
    EXPECT_EQ(steps[0].level, 1.0);
    EXPECT_EQ(steps[0].cycles, 1000.0);
    EXPECT_EQ(steps[1].level, 0.5);
    EXPECT_EQ(steps[1].cycles, 20000.0);
    EXPECT_EQ(steps[2].jump, 50.0);
  }
  EXPECT_EQ(read.scene.steps[0].level, 1.0);
  const Read bad("", stroke.substr(9), "level,cycles\n1.0,1000\n-0.5,20000\n", spectrum);
  EXPECT_NE(bad.refusal.find("line 3: level must be > 0"), std::string::npos) << bad.refusal;
}
