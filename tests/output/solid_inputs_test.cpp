#include "output/solid/solid_inputs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/errors.hpp"
#include "output/solid/solid_history.hpp"
#include "output/solid/solid_words.hpp"
#include "solid_sample.hpp"

using namespace reye::output;
using reye::base::Vec3;

namespace {

using Values = std::vector<std::array<double, 2>>;

SolidRunData history_of(const reye::scene::SolidScene& scene, const std::vector<std::array<double, 2>>& rows) {
  SolidRunData data;
  data.inputs = inputs_of(scene);
  std::string csv = "step,cycle,progress,newton,shaker_force_x_N,shaker_force_y_N,shaker_force_z_N\n";
  for (const auto& [progress, force] : rows)
    csv += "rub,0," + std::to_string(progress) + ",3," + std::to_string(force) + ",0,-100\n";
  data.run.history = parse_csv(csv);
  return data;
}

const Figure* figure_named(const std::vector<Figure>& all, const std::string& id) {
  for (const auto& figure : all)
    if (figure.id == id) return &figure;
  return nullptr;
}

}  // namespace

// An imposed motion is its parts times their histories: level included, held in steps that do not play it.
TEST(SolidInputs, MotionOverTheSteps) {
  auto scene = solid_sample::scene();
  scene.steps[1].level = 2.0;
  scene.histories["slide"].back()[1] = 0.5;
  scene.steps.push_back(scene.steps[0]);
  scene.steps.back().name = "release";
  const auto motions = inputs_of(scene).motions;
  ASSERT_EQ(motions.size(), 1u);
  EXPECT_EQ(motions[0].label, "motion along x of shaker");
  EXPECT_EQ(motions[0].columns, "shaker_force_");
  ASSERT_EQ(motions[0].steps.size(), 3u);
  EXPECT_EQ(motions[0].steps[0].values, (Values{{0.0, 0.0}, {1.0, 0.0}}));
  EXPECT_EQ(motions[0].steps[1].values, (Values{{0.0, 0.0}, {0.25, 0.04}, {0.75, -0.04}, {1.0, 0.02}}));
  EXPECT_EQ(motions[0].steps[2].values, (Values{{0.0, 0.02}, {1.0, 0.02}}));
}

// A sliding that is imposed on a contact is a motion, too, whose force is what resists it.
TEST(SolidInputs, ImposedSliding) {
  auto scene = solid_sample::scene();
  scene.contacts[0].sliding = {{Vec3::UnitY(), Vec3::Zero(), Vec3::Zero(), {{3.0, "slide"}}},
                               {Vec3::Zero(), Vec3::Zero(), Vec3::UnitZ(), {{0.1, "slide"}}}};
  const auto motions = inputs_of(scene).motions;
  ASSERT_EQ(motions.size(), 2u);
  EXPECT_EQ(motions[1].direction, Vec3(0.0, -1.0, 0.0));
  EXPECT_EQ(motions[1].steps[1].values[1][1], 3.0);
  EXPECT_EQ(sliding_in_words(scene.contacts[0].sliding[0]), "3 mm × slide along y");
  EXPECT_EQ(sliding_in_words(scene.contacts[0].sliding[1]), "0.1 rad × slide about z through (0, 0, 0)");
}

// Inputs come back from their file as they were; another file is refused.
TEST(SolidInputs, ReadBack) {
  const reye::support::TemporaryFolder dir;
  const auto inputs = inputs_of(solid_sample::scene());
  atomic_write(dir / "inputs.json", inputs_json(inputs));
  const auto read = read_inputs(dir / "inputs.json");
  EXPECT_EQ(read.contacts, inputs.contacts);
  EXPECT_EQ(read.supports, inputs.supports);
  ASSERT_EQ(read.tables.size(), 5u);
  EXPECT_EQ(read.tables[2].rows, inputs.tables[2].rows);
  EXPECT_EQ(inputs_json(read), inputs_json(inputs));
  for (const char* other : {"{}", "nonsense", "[1, 2]"}) {
    replace_text(dir / "inputs.json", other);
    EXPECT_THROW(read_inputs(dir / "inputs.json"), reye::base::InputError) << other;
  }
  EXPECT_THROW(read_inputs(dir / "missing.json"), reye::base::InputError);
}

// The loop draws the force along the motion over the motion of that moment.
TEST(SolidInputs, LoopOfForceOverMotion) {
  const auto all = solid_history_figures(
      history_of(solid_sample::scene(), {{0.25, 30.0}, {0.5, -30.0}, {0.75, -30.0}, {1.0, 30.0}}));
  const Figure* loop = figure_named(all, "loop-1");
  ASSERT_NE(loop, nullptr);
  const auto& line = loop->lines.front();
  const std::vector<double> um{20.0, 0.0, -20.0, 0.0};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(line.x[i], um[i], 1e-9) << i;
  EXPECT_EQ(line.y, (std::vector<double>{30.0, -30.0, -30.0, 30.0}));
}

// Where two steps have one name no one knows which of them a row is of: there is no loop.
TEST(SolidInputs, NoLoopWhereNamesRepeat) {
  auto scene = solid_sample::scene();
  scene.steps[0].name = scene.steps[1].name;
  EXPECT_EQ(figure_named(solid_history_figures(history_of(scene, {{0.5, 1.0}, {1.0, 2.0}})), "loop-1"), nullptr);
}

// Motions are said with axes, values, springs and histories; what is free is left out.
TEST(SolidWords, SupportsAndLoads) {
  using reye::body::Drive;
  reye::body::SolidSupport support;
  EXPECT_EQ(solid_support_in_words(support), "free");
  support.normal.drive = Drive::fixed;
  EXPECT_EQ(solid_support_in_words(support), "normal fixed");
  support.rigid = true;
  support.about[2] = {Drive::moved, {{0.1, "turn"}, {0.2, ""}}, 0.0};
  support.along[1] = {Drive::loaded, {}, 50.0};
  support.axes.col(0) = Vec3(0.0, 1.0, 0.0);
  support.axes.col(1) = Vec3(-0.6, 0.0, 0.8);
  EXPECT_EQ(solid_support_in_words(support),
            "normal fixed, y a spring of 50 N per mm, rotation about z 0.1 rad × turn and 0.2 rad; as one rigid face; "
            "axes x y, y (-0.6, 0, 0.8)");
  reye::body::SolidLoad load;
  load.traction_MPa = Vec3(1.0, 0.0, 0.0);
  load.force_N = Vec3(0.0, 2.0, 0.0);
  load.history = "push";
  EXPECT_EQ(solid_load_in_words(load), "traction (1, 0, 0) MPa, force (0, 2, 0) N × push");
  EXPECT_EQ(direction_in_words(Vec3(0.0, -2.0, 0.0)), "-y");
}
