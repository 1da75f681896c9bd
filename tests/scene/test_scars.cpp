#include <gtest/gtest.h>

#include <string>

#include "base/errors.hpp"
#include "folder.hpp"
#include "scene/scars.hpp"

namespace {

using namespace reye;
using scene::ScarContext;
using scene::ScarSide;

/// Eight rows under a line of names, the depth of row i being i(7 - i).
std::string eight_rows(const std::string& names, const std::string& more = "") {
  std::string text = names + "\n";
  for (int i = 7; i >= 0; --i) text += std::to_string(0.1 * i) + ',' + std::to_string(i * (7 - i)) + more + "\n";
  return text;
}

const ScarContext both_wear{.contacts = {{"pad", true, true}}, .at_cycles = 500.0};
const ScarContext one_wears{.contacts = {{"pad", false, true}}, .at_cycles = 500.0};

/// What reading says against the files of a folder, each issue a line.
std::string errors(const std::string& path, const ScarContext& context) {
  try {
    scene::read_scars(path, context);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

// A profile in micrometres of height must come as depths in mm, its places in increasing order, on the side that wears.
TEST(scars, a_table_of_heights) {
  const test::Folder folder;
  folder.write("scar.csv", eight_rows("x_mm,height_um,scatter_um", ",0.5"));
  const auto read = scene::read_scars("scar.csv", one_wears);
  ASSERT_EQ(read.scars.size(), 1u);
  const auto& scar = read.scars.front();
  EXPECT_EQ(scar.of.contact, "pad");
  EXPECT_EQ(scar.of.side, ScarSide::primary);
  EXPECT_EQ(scar.of.cycles, 500.0);
  EXPECT_DOUBLE_EQ(scar.at[1].x(), 0.1);
  EXPECT_DOUBLE_EQ(scar.depth_mm[1], -6e-3);
  EXPECT_DOUBLE_EQ(scar.scatter_mm[7], 5e-4);
  EXPECT_TRUE(scar.level);
  EXPECT_FALSE(scar.origin_known);
}

// A file of several measurements must keep what each of them says, paths counting from it.
TEST(scars, a_file_of_several) {
  const test::Folder folder;
  folder.write("scar.csv", eight_rows("arc_mm,depth_mm"));
  folder.write("scars.toml", R"(
[[scar]]
file = "scar.csv"
side = "secondary"
cycles = 100
scatter_mm = 0.25
level = false
origin = "known"
[[figure]]
side = "primary"
area_mm2 = 0.002
scatter = 0.1
)");
  const auto read = scene::read_scars("scars.toml", both_wear);
  ASSERT_EQ(read.scars.size(), 1u);
  EXPECT_EQ(read.scars[0].of.cycles, 100.0);
  EXPECT_EQ(read.scars[0].axes, std::vector{scene::ScarAxis::arc});
  EXPECT_EQ(read.scars[0].scatter_mm, base::Vector::Constant(8, 0.25));
  EXPECT_FALSE(read.scars[0].level);
  EXPECT_TRUE(read.scars[0].origin_known);
  ASSERT_EQ(read.figures.size(), 1u);
  EXPECT_EQ(read.figures[0].of.side, ScarSide::primary);
  EXPECT_EQ(read.figures[0].of.cycles, 500.0);
  EXPECT_EQ(read.figures[0].what, scene::ScarFigure::area);
  EXPECT_EQ(read.figures[0].value, 0.002);
  ASSERT_EQ(read.warnings.size(), 1u);  // depths of mm over a length of 0.7 mm
  EXPECT_NE(read.warnings[0].find("is the unit of the column right?"), std::string::npos);
}

// All errors must come at once, each with its line and what to do.
TEST(scars, errors_have_their_lines) {
  const test::Folder folder;
  folder.write("bare.csv", eight_rows("x_mm,depth"));
  folder.write("two.csv", eight_rows("x_mm,y_mm"));
  folder.write("short.csv", "x_mm,depth_mm\n1,2\n");
  folder.write("scars.toml", R"([[scar]]
file = "bare.csv"
side = "secondary"
[[scar]]
file = "two.csv"
[[scar]]
file = "short.csv"
side = "primary"
contact = "lid"
[[scar]]
file = "none.csv"
side = "primary"
[[figure]]
side = "primary"
depth_mm = 1.0
volume_mm3 = 2.0
deep = 3
)");
  EXPECT_EQ(
      errors("scars.toml", both_wear),
      R"(scars.toml:2: scar[0].file: needs one column of depth_mm, depth_um, height_mm or height_um (depth counts into the body)
scars.toml:4: scar[1].side: is missing: both sides of contact "pad" wear; "secondary" or "primary"
scars.toml:5: scar[1].file: needs one of the columns x_mm, y_mm and arc_mm: the place along the surface
scars.toml:7: scar[2].file: has fewer than 8 rows of numbers
scars.toml:9: scar[2].contact = "lid": no contact of that name wears in the scene; "pad" do
scars.toml:11: scar[3].file: no such file
scars.toml:13: figure[0]: takes one number: depth_mm, width_mm, area_mm2 or volume_mm3, energy_mJ_per_mm or energy_mJ; give more numbers as more [[figure]]
scars.toml:16: figure[0].volume_mm3 = 2.0: a plane scene counts per mm of thickness: area_mm2, energy_mJ_per_mm
scars.toml:17: figure[0].deep = 3: unknown key; known here: contact, side, cycles, depth_mm, width_mm, area_mm2, volume_mm3, energy_mJ_per_mm, energy_mJ, scatter)");
}

// A loop must count by the energy that it encloses, whichever way it is run through and wherever its zero lies.
TEST(scars, energy_of_a_loop) {
  const test::Folder folder;
  std::string text = "stroke_mm,force_N_per_mm\n";
  for (const auto& [x, F] :
       {std::pair(0.0, 5.0), {0.1, 5.0}, {0.2, 5.0}, {0.2, 3.0}, {0.2, 1.0}, {0.1, 1.0}, {0.0, 1.0}, {0.0, 3.0}})
    text += std::to_string(x) + ',' + std::to_string(F) + '\n';
  folder.write("loop.csv", text);
  folder.write("loops.toml", "[[loop]]\nfile = \"loop.csv\"\nscatter = 0.02\n[[figure]]\nenergy_mJ_per_mm = 0.9\n");
  const auto read = scene::read_scars("loops.toml", both_wear);
  ASSERT_EQ(read.figures.size(), 2u);
  EXPECT_EQ(read.figures[0].what, scene::ScarFigure::energy);
  EXPECT_NEAR(read.figures[0].value, 0.8, 1e-12);
  EXPECT_EQ(read.figures[0].scatter, 0.02);
  EXPECT_EQ(read.figures[1].value, 0.9);
  auto solids = one_wears;
  solids.volumes = true;
  EXPECT_EQ(errors("loops.toml", solids),
            "loops.toml:2: loop[0].file: needs the columns stroke_mm and force_N\n"
            "loops.toml:5: figure[0].energy_mJ_per_mm = 0.9: this scene counts volumes and whole energies: volume_mm3, "
            "energy_mJ");
}

// Maps belong to solids, and need the two axes of their plane; a profile says one depth at each place.
TEST(scars, places_fit_the_dimension) {
  const test::Folder folder;
  folder.write("line.csv", eight_rows("x_mm,depth_mm"));
  folder.write("twice.csv", eight_rows("x_mm,depth_mm") + "0.1,3\n");
  auto solids = one_wears;
  solids.dimension = 3;
  EXPECT_EQ(errors("line.csv", solids),
            "line.csv:1: needs two of the columns x_mm, y_mm and z_mm: the plane on which the scar is seen");
  EXPECT_EQ(errors("twice.csv", one_wears),
            "twice.csv:1: two rows have the same place; a profile has one depth at each");
  auto timeless = one_wears;
  timeless.at_cycles = 0.0;
  EXPECT_EQ(errors("line.csv", timeless),
            "line.csv:1: cycles: is missing: give the cycles after which it was measured here, or by --at CYCLES");
}

}  // namespace
