#include "output/solid/solid_tables.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "output/report/run_data.hpp"
#include "solid_sample.hpp"

using namespace reye::output;
namespace sim = reye::sim;

// The header names each column with its unit, contacts before supports in the order of the scene.
TEST(SolidTables, HeaderNamesEveryColumn) {
  EXPECT_EQ(solid_history_header({{"pad"}, {"ground"}}),
            "step,cycle,progress,newton,pad_pressure_max_MPa,pad_area_mm2,pad_stick_area_mm2,pad_force_x_N,"
            "pad_force_y_N,pad_force_z_N,pad_normal_force_N,pad_tangential_force_N,pad_energy_mJ,"
            "pad_depth_max_secondary_mm,pad_depth_max_primary_mm,pad_volume_secondary_mm3,pad_volume_primary_mm3,"
            "ground_force_x_N,ground_force_y_N,ground_force_z_N,"
            "ground_moment_x_N_mm,ground_moment_y_N_mm,ground_moment_z_N_mm\n");
}

// A row reads back to the same numbers under the names of its columns.
TEST(SolidTables, RowsReadBack) {
  const SolidColumns columns{{"pad"}, {"ground", "shaker"}};
  auto record = solid_sample::increment("a, b", 1.25, 0.1);
  record.contacts[0].pressure_max_MPa = 1.0 / 3.0;
  const Table table = parse_csv(solid_history_header(columns) + solid_history_row(record, columns));
  ASSERT_EQ(table.rows(), 1u);
  EXPECT_EQ(table.word(table.column("step")[0]), "a, b");
  for (const auto& [column, value] :
       {std::pair("cycle", 1.25), std::pair("newton", 4.0), std::pair("pad_pressure_max_MPa", 1.0 / 3.0),
        std::pair("pad_volume_secondary_mm3", 0.25), std::pair("pad_force_x_N", -30.0),
        std::pair("pad_force_z_N", -100.0), std::pair("pad_stick_area_mm2", 0.5),
        std::pair("pad_tangential_force_N", 30.0), std::pair("ground_force_z_N", 100.0),
        std::pair("ground_moment_y_N_mm", 2.0), std::pair("shaker_force_x_N", 30.0)})
    EXPECT_EQ(table.column(column).at(0), value) << column;
}

// An increment with other contacts or supports than the header is refused: its numbers would stand in wrong columns.
TEST(SolidTables, OtherContactsAreRefused) {
  const auto record = solid_sample::increment("rub", 0.0, 1.0);
  EXPECT_THROW(solid_history_row(record, {{"pad", "other"}, {"ground", "shaker"}}), std::logic_error);
  EXPECT_THROW(solid_history_row(record, {{"pad"}, {"ground"}}), std::logic_error);
}

// A row of a remesh reads back to the same values, its words with commas in them, too.
TEST(SolidTables, RemeshesReadBack) {
  sim::SolidRemeshRecord record;
  record.step = "rub";
  record.cycle = 12.5;
  record.body = "pin & co";
  record.reason = "the facet at (1, 2, 3) mm has shape 0.1, below 0.3";
  record.nodes_before = 10;
  record.nodes_after = 20;
  record.quality_before = 0.1;
  record.quality_after = 0.4;
  record.fresh_facets = 7;
  record.volume_residue_mm3 = -1e-9;
  record.correction_mm = 2e-7;
  record.pressure_change = 1.0 / 3.0;
  record.fit_mm = 3e-6;
  const Table table = parse_csv(solid_remesh_header() + solid_remesh_row(record));
  ASSERT_EQ(table.rows(), 1u);
  for (const auto& [column, value] :
       {std::pair("cycle", 12.5), std::pair("nodes_before", 10.0), std::pair("nodes_after", 20.0),
        std::pair("quality_before", 0.1), std::pair("quality_after", 0.4), std::pair("fresh_facets", 7.0),
        std::pair("volume_residue_mm3", -1e-9), std::pair("correction_mm", 2e-7),
        std::pair("pressure_change", 1.0 / 3.0), std::pair("fit_mm", 3e-6)})
    EXPECT_EQ(table.column(column).at(0), value) << column;
  EXPECT_EQ(table.word(table.column("reason")[0]), record.reason);
  EXPECT_EQ(table.word(table.column("body")[0]), record.body);
}

// A surface table has a row per node with all components, the body's name and the status in words.
TEST(SolidTables, SurfaceRowsReadBack) {
  const auto skin = solid_sample::frame(1.5).surfaces[0];
  const Table table = parse_csv(skin_header() + skin_rows(7, 1.5, {"flat", "pin"}, skin));
  ASSERT_EQ(table.columns.size(), 17u);
  ASSERT_EQ(table.rows(), skin.x_mm.size());
  for (std::size_t i = 0; i < skin.x_mm.size(); ++i) {
    EXPECT_EQ(table.column("frame")[i], 7.0);
    EXPECT_EQ(table.column("cycle")[i], 1.5);
    EXPECT_EQ(table.word(table.column("body")[i]), "flat");
    EXPECT_EQ(table.column("node")[i], skin.node[i]);
    EXPECT_EQ(table.column("z_mm")[i], 1.0);
    EXPECT_EQ(table.column("pressure_MPa")[i], 10.0 * skin.x_mm[i].x());
    EXPECT_EQ(table.column("shear_x_MPa")[i], -2.0 * skin.x_mm[i].x());
    EXPECT_EQ(table.column("shear_y_MPa")[i], 0.5);
    EXPECT_EQ(table.column("area_mm2")[i], 0.25);
    EXPECT_EQ(table.column("wear_depth_mm")[i], 0.002);
    const char* words[] = {"inactive", "stick", "slip"};
    EXPECT_EQ(table.word(table.column("status")[i]), words[skin.status[i]]);
  }
}

// A status that does not exist is an error, not a word from beyond the list.
TEST(SolidTables, UnknownStatusIsRefused) {
  auto skin = solid_sample::frame(1.0).surfaces[0];
  skin.status[1] = 3;
  EXPECT_THROW(skin_rows(0, 1.0, {"flat", "pin"}, skin), std::logic_error);
}
