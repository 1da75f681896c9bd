#include "cad/meshing/step_writing.hpp"

#include "support.hpp"

namespace {

using namespace reye;
using namespace reye::cad;

/// A square of 4 with a square hole of 1, clockwise.
const PlaneFace frame{"frame", {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {1, 2}, {2, 2}, {2, 1}}}, 1};

/// A square of 2 of second order beside it, whose upper edge bulges by 0.3: a parabola over a chord of 2 adds 2/3 x 2 x
/// 0.3.
const PlaneFace hill{"hill's top", {{{6, 0}, {7, 0}, {8, 0}, {8, 1}, {8, 2}, {7, 2.3}, {6, 2}, {6, 1}}}, 2};

GeometryOptions read_back(const std::vector<PlaneFace>& faces) {
  GeometryOptions options;
  options.files = {temporary_file("shape.step", step_text(faces, "a note with 'quotes'; and more"))};
  for (const auto& face : faces) options.bodies.push_back(body(face.name));
  return options;
}

// A file of STEP must hold each face under its name, holes and parabolas of second order with exact areas.
TEST(step_writing, read_back) {
  auto options = read_back({frame, hill});
  options.bodies[1].mesh = {mesh::CellKind::quad4, 0.05, 1.3};
  const Geometry geometry = build(options);
  EXPECT_NEAR(geometry.facts[0].area_mm2, 15.0, 1e-9);
  EXPECT_NEAR(geometry.facts[1].area_mm2, 4.4, 1e-4) << "curves are measured by many chords";
  EXPECT_NEAR(geometry.facts[1].box_mm[3], 2.3, 1e-6);
  EXPECT_EQ(geometry.bodies[0].outline.size(), 2u);
}

// A single face must have its name, too.
TEST(step_writing, single_face) {
  const Geometry geometry = build(read_back({frame}));
  EXPECT_NEAR(geometry.facts[0].area_mm2, 15.0, 1e-9);
}

// The text must hold the note, the unit and no time, so that a shape has one file.
TEST(step_writing, text_repeats) {
  const std::string text = step_text({frame}, "a 'note'");
  EXPECT_NE(text.find("FILE_DESCRIPTION(('a ''note'''),'2;1');"), text.npos);
  EXPECT_NE(text.find("SI_UNIT(.MILLI.,.METRE.)"), text.npos);
  EXPECT_TRUE(text == step_text({frame}, "a 'note'"));
}

}  // namespace
