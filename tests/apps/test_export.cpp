#include <array>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>

#include "command.hpp"
#include "places.hpp"
#include "scenes.hpp"
#include "solid_scenes.hpp"

using namespace reye;
using test::holds;
namespace fs = std::filesystem;

namespace {

/// Areas of the bodies of an exported table, by the shoelace formula.
std::map<std::string, double> exported_areas(const fs::path& file) {
  std::map<std::string, double> areas;
  std::istringstream lines(test::read(file));
  std::string line, last;
  double x = 0.0, y = 0.0;
  for (int k = 0; std::getline(lines, line); ++k) {
    if (k < 2) continue;
    std::istringstream cells(line);
    std::string body, loop, x_cell, y_cell;
    for (auto* cell : {&body, &loop, &x_cell, &y_cell}) std::getline(cells, *cell, ',');
    const double x1 = std::stod(x_cell), y1 = std::stod(y_cell);
    if (body + loop == last) areas[body] += 0.5 * (x * y1 - y * x1);
    last = body + loop;
    x = x1;
    y = y1;
  }
  return areas;
}

/// Volume inside the triangles of a binary STL.
double stl_volume(const fs::path& file) {
  const std::string bytes = test::read(file);
  double sum = 0.0;
  for (std::size_t at = 84; at + 50 <= bytes.size(); at += 50) {
    std::array<float, 12> n{};
    std::memcpy(n.data(), bytes.data() + at, sizeof n);
    const auto v = [&](int i) { return std::array<double, 3>{n[3 * i], n[3 * i + 1], n[3 * i + 2]}; };
    const auto a = v(1), b = v(2), c = v(3);
    sum +=
        (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) /
        6.0;
  }
  return sum;
}

nlohmann::json summary_in(const fs::path& dir) { return nlohmann::json::parse(test::read(dir / "summary.json")); }

}  // namespace

namespace {

/// What bodies have lost from frame 0 to the last one, and what the summary counts, by side.
struct Losses {
  std::map<std::string, double> area, before, worn;
};

Losses losses_of(const test::Place& place) {
  for (const auto& words : {std::vector<std::string>{"--frame", "0", "--out", "first.csv"}, {"--out", "last.csv"}}) {
    std::vector<std::string> all{"export", "wearing.out", "--format", "csv"};
    all.insert(all.end(), words.begin(), words.end());
    const auto told = place.reye(all);
    EXPECT_EQ(told.code, 0) << told.err;
    EXPECT_EQ(told.err, "");
    EXPECT_TRUE(holds(told.out, "stress-free (not deformed)"));
  }
  Losses losses{exported_areas(place / "last.csv"), exported_areas(place / "first.csv"), {}};
  const auto contact = summary_in(place / "wearing.out")["contacts"]["pad"];
  for (const char* side : {"secondary", "primary"}) losses.worn[side] = contact[side]["worn_area_mm2"];
  return losses;
}

}  // namespace

// The exported outlines must have lost between the first and the last frame what the run has removed from each side.
TEST(Export, WornAreaOfBothSides) {
  const test::WithWearing place;
  ASSERT_EQ(place.reye({"run", "wearing.toml", "--quiet"}).code, 0);
  auto losses = losses_of(place);
  ASSERT_GT(losses.worn["secondary"], 1e-7);
  EXPECT_NEAR(losses.before["flat"] - losses.area["flat"], losses.worn["secondary"], 1e-14);
  EXPECT_NEAR(losses.before["disc"] - losses.area["disc"], losses.worn["primary"], 1e-14);
}

// Over remeshes a body with straight edges must have lost it, too; a STEP file of the outlines must be read as geometry
// with their areas.
TEST(Export, WornAreaOverRemeshes) {
  const test::WithWearing place(test::worn_pin);
  ASSERT_EQ(place.reye({"run", "wearing.toml", "--quiet"}).code, 0);
  auto losses = losses_of(place);
  auto& after = losses.area;
  ASSERT_GT(losses.worn["primary"], 1e-5);
  EXPECT_NEAR(losses.before["flat"] - after["flat"], losses.worn["primary"], 1e-13);
  ASSERT_EQ(place.reye({"export", "wearing.out", "--format", "step", "--out", "worn.step"}).code, 0);
  place.write("again.toml", test::changed(test::worn_pin, {{"wearing.geo", "worn.step"}}) +
                                "[boundary]\nround = { body = \"disc\", box_mm = [-0.9, -0.1, 0.9, 0.9] }\n"
                                "top = { body = \"disc\", box_mm = [-2.0, 0.99, 2.0, 1.01] }\n"
                                "face = { body = \"flat\", box_mm = [-2.0, -0.1, 2.0, 0.1] }\n"
                                "bottom = { body = \"flat\", box_mm = [-2.0, -1.01, 2.0, -0.99] }\n");
  const auto checked = place.reye({"check", "again.toml"});
  EXPECT_EQ(checked.code, 0) << checked.err;
  std::array<char, 64> line{};
  std::snprintf(line.data(), line.size(), "body flat: area %.6g mm^2", after["flat"]);
  EXPECT_TRUE(holds(checked.out, line.data())) << line.data() << '\n' << checked.out;
}

// An exported solid must have lost the volume that the history counts.
TEST(Export, WornVolumeOfSolids) {
  const test::WithRubbing place;
  place.write("rubbing.toml", test::worn_rubbing());
  ASSERT_EQ(place.run("out").code, 0);
  ASSERT_EQ(place.reye({"export", "out", "--format", "stl"}).code, 0);
  ASSERT_EQ(place.reye({"export", "out", "--format", "stl", "--frame", "0"}).code, 0);
  double gone = 0.0;
  for (const char* body : {"ball", "flat"})
    gone += stl_volume(place / ("out_frame_0_" + std::string(body) + ".stl")) -
            stl_volume(place / ("out_cycle_3_" + std::string(body) + ".stl"));
  const auto contact = summary_in(place / "out")["contacts"]["pad"];
  const double worn =
      contact["secondary"]["worn_volume_mm3"].get<double>() + contact["primary"]["worn_volume_mm3"].get<double>();
  ASSERT_GT(worn, 1e-6);
  EXPECT_NEAR(gone, worn, 0.02 * worn) << "of numbers of single precision";
  const auto told = place.reye({"export", "out", "--format", "csv", "--body", "flat", "--out", "flat.csv"});
  ASSERT_EQ(told.code, 0) << told.err;
  const auto table = test::read(place / "flat.csv");
  EXPECT_TRUE(holds(table, "contact,side,body,x_mm,y_mm,z_mm,wear_depth_mm\npad,secondary,flat,"));
  EXPECT_FALSE(holds(table, ",ball,"));
}

// What a run, a format or a file does not allow must be refused with the reason, all at once, and nothing written.
TEST(Export, Refusals) {
  const test::WithWearing place;
  ASSERT_EQ(place.reye({"run", "wearing.toml", "--quiet"}).code, 0);
  place.write("mine.csv", "my own\n");
  const auto before = place.files();
  const auto refusal = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"export", "wearing.out"});
    const auto told = place.reye(words);
    EXPECT_EQ(told.code, 2) << told.out;
    EXPECT_EQ(told.out, "");
    return told.err;
  };
  EXPECT_EQ(refusal({}), "--format: name csv, dxf, step or stl; of solids stl or csv\n");
  EXPECT_TRUE(holds(refusal({"--format", "dfx", "--thickness", "-1"}), "did you mean \"dxf\"?\n--thickness = -1: "));
  EXPECT_TRUE(holds(refusal({"--format", "stl"}), "--thickness: stl has three dimensions"));
  EXPECT_TRUE(holds(refusal({"--format", "stl", "--thickness", "2", "--out", "one.stl"}), "choose one with --body"));
  EXPECT_TRUE(holds(refusal({"--format", "csv", "--body", "flad"}), "did you mean \"flat\"?"));
  EXPECT_TRUE(holds(refusal({"--format", "csv", "--cycle", "17"}), "the run has no frame there, but at 0, 200, 400"));
  EXPECT_TRUE(holds(refusal({"--format", "csv", "--out", "mine.csv"}), "it exists and is no former export"));
  EXPECT_TRUE(holds(refusal({"--format", "csv", "--out", "no/folder.csv"}), "it cannot be written in "));
  EXPECT_TRUE(holds(place.reye({"export", ".", "--list"}).err, "holds no run of reye"));
  EXPECT_EQ(place.files(), before);
  ASSERT_EQ(place.reye({"export", "wearing.out", "--format", "csv", "--out", "mine.csv", "--force"}).code, 0);
  EXPECT_EQ(place.reye({"export", "wearing.out", "--format", "dxf", "--out", "mine.csv"}).code, 0) << "a former export";
  EXPECT_EQ(place.reye({"export", "wearing.out", "--list"}).out,
            "frame 0: cycle 0\nframe 1: cycle 0\nframe 2: cycle 200\nframe 3: cycle 400\n");
}

// A frame whose shape does not hold the wear must be refused: with shape = "off" wear only opens the gap.
TEST(Export, ShapeThatIsOff) {
  const test::WithWearing place("shape = \"off\"\n" + test::wearing);
  ASSERT_EQ(place.reye({"run", "wearing.toml", "--quiet"}).code, 0);
  const auto told = place.reye({"export", "wearing.out", "--format", "dxf"});
  EXPECT_EQ(told.code, 2);
  EXPECT_TRUE(holds(told.err, "its scene has shape = \"off\"")) << told.err;
}

// A frame within a block, whose shape does not hold the wear of the block yet, must be refused with the frame whose
// shape it is.
TEST(Export, FrameWithinABlock) {
  const test::WithWearing place(test::changed(
      test::wearing,
      {{"every_cycles = 200", "last_block = true"}, {"cycles = 400\njump = 100", "cycles = 100\njump = 100"}}));
  ASSERT_EQ(place.reye({"run", "wearing.toml", "--quiet"}).code, 0);
  const auto told = place.reye({"export", "wearing.out", "--format", "dxf", "--frame", "9"});
  EXPECT_EQ(told.code, 2);
  EXPECT_TRUE(holds(told.err, "the shapes of frame 9 are those of frame 0: of its depth of ")) << told.err;
  EXPECT_TRUE(holds(told.err, "choose another frame")) << told.err;
  EXPECT_EQ(place.reye({"export", "wearing.out", "--format", "dxf"}).code, 0);
}

// A run that was interrupted must be exported at the frames it has.
TEST(Export, InterruptedRun) {
  const test::WithWearing place;
  auto run = place.start_reye({"run", "wearing.toml", "--quiet"});
  ASSERT_TRUE(run.signal_when(SIGTERM, [&] { return fs::exists(place / "wearing.out/frames/surface_000002.vtp"); }));
  ASSERT_EQ(run.wait().code, 130);
  const auto told = place.reye({"export", "wearing.out", "--format", "dxf", "--cycle", "200"});
  EXPECT_EQ(told.code, 0) << told.err;
  EXPECT_TRUE(fs::exists(place / "wearing_cycle_200.dxf"));
}
