#include <gtest/gtest.h>

#include <charconv>

#include "output/folder/files.hpp"
#include "output/folder/text.hpp"
#include "output/report/run_data.hpp"
#include "sample_run.hpp"

using namespace reye::output;

// A file is replaced as a whole and nothing else is left in its folder.
TEST(AtomicWrite, ReplacesTheWholeFile) {
  sample::TemporaryFolder dir;
  atomic_write(dir / "a.txt", "a long first text");
  atomic_write(dir / "a.txt", "short");
  EXPECT_EQ(read_text(dir / "a.txt"), "short");
  EXPECT_EQ(std::distance(sample::fs::directory_iterator(dir.str()), {}), 1);
}

// A folder that is not there is an error that names the path and the reason.
TEST(AtomicWrite, SaysWhyItFails) {
  sample::TemporaryFolder dir;
  try {
    atomic_write(dir / "none/a.txt", "x");
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("none/a.txt: No such file or directory"), std::string::npos);
  }
}

// A full disk is an error, for whole files and for rows alike.
TEST(AtomicWrite, FullDiskThrows) {
  ASSERT_TRUE(sample::fs::exists("/dev/full"));
  EXPECT_THROW(append_text("/dev/full", "row\n"), std::runtime_error);
}

// Every double reads back to itself.
TEST(Number, RoundTripsEveryDouble) {
  for (const double value : {0.1, 1.0 / 3.0, 1e-300, 5e-324, -2.5e17, 123456789.123456789, 0.0}) {
    const std::string text = number(value);
    double back = 1.0;
    std::from_chars(text.data(), text.data() + text.size(), back);
    EXPECT_EQ(back, value) << text;
  }
}

// history.csv has exactly the columns of the contract, then six per contact, then two per support and a moment of rigid
// edges, then four per bond.
TEST(History, HasTheColumnsOfTheContract) {
  using reye::base::Analysis;
  EXPECT_EQ(
      history_header({{"pad"}, {{"holder", true}}}, Analysis::plane_stress),
      "step,cycle,progress,newton,pressure_max_MPa,depth_max_secondary_mm,depth_max_primary_mm,"
      "energy_mJ_per_mm,pad_pressure_max_MPa,pad_depth_max_secondary_mm,pad_depth_max_primary_mm,pad_energy_mJ_per_mm,"
      "pad_normal_force_N_per_mm,pad_tangential_force_N_per_mm,holder_force_x_N_per_mm,holder_force_y_N_per_mm,"
      "holder_moment_N_mm_per_mm\n");
  EXPECT_EQ(history_header({{}, {{"a"}, {"b"}}}, Analysis::axisymmetric),
            "step,cycle,progress,newton,pressure_max_MPa,depth_max_secondary_mm,depth_max_primary_mm,"
            "energy_mJ,a_force_x_N,a_force_y_N,b_force_x_N,b_force_y_N\n");
  EXPECT_EQ(history_header({{}, {}, {"glue"}}, Analysis::plane_strain),
            "step,cycle,progress,newton,pressure_max_MPa,depth_max_secondary_mm,depth_max_primary_mm,"
            "energy_mJ_per_mm,glue_tension_max_MPa,glue_shear_max_MPa,glue_tension_mean_MPa,glue_shear_mean_MPa\n");
}

// A history row reads back to the same doubles, whatever the step is called.
TEST(History, RowReadsBack) {
  auto record = sample::increment(7, 1000.0 / 3.0);
  record.step = "press, \"hard\"\nand long";
  record.support_moments[1] = 2.0 / 3.0;
  record.bonds.resize(1);
  record.bonds[0].shear.MPa = 1.0 / 7.0;
  record.bonds[0].mean_tension_MPa = -1.0 / 9.0;
  auto columns = sample::columns;
  columns.bonds = {"glue"};
  columns.supports[1].moment = true;
  const Table table = parse_csv(history_header(columns, reye::base::Analysis::plane_strain) + history_row(record));
  ASSERT_EQ(table.rows(), 1u);
  EXPECT_EQ(table.word(table.column("step")[0]), "press, \"hard\" and long");
  EXPECT_EQ(table.column("cycle")[0], record.cycle);
  EXPECT_EQ(table.column("pressure_max_MPa")[0], record.pressure_max_MPa);
  EXPECT_EQ(table.column("shaker_force_x_N_per_mm")[0], record.support_forces[1].x());
  EXPECT_EQ(table.column("shaker_moment_N_mm_per_mm")[0], *record.support_moments[1]);
  EXPECT_EQ(table.column("pad_tangential_force_N_per_mm")[0], record.contacts[0].tangential_force);
  EXPECT_EQ(table.column("glue_shear_max_MPa")[0], record.bonds[0].shear.MPa);
  EXPECT_EQ(table.column("glue_tension_mean_MPa")[0], record.bonds[0].mean_tension_MPa);
}

// A step whose name looks like a number is still a name.
TEST(History, StepMayBeCalledByANumber) {
  auto record = sample::increment(1, 0.0);
  record.step = "2";
  const Table table =
      parse_csv(history_header(sample::columns, reye::base::Analysis::plane_strain) + history_row(record));
  EXPECT_EQ(table.word(table.column("step")[0]), "2");
}

// Surface tables have exactly the columns of the contract, the status in words, and read back to the same doubles.
TEST(Surface, HasTheColumnsOfTheContractAndReadsBack) {
  EXPECT_EQ(surface_header(),
            "frame,cycle,body,arc_length_mm,x_mm,y_mm,pressure_MPa,shear_MPa,slip_mm,wear_depth_mm,status\n");
  const auto frame = sample::frame(9000.0);
  const auto& record = frame.surfaces[0];
  const Table table = parse_csv(surface_header() + surface_rows(3, frame, record));
  ASSERT_EQ(table.rows(), record.x_mm.size());
  EXPECT_EQ(table.column("pressure_MPa"), record.pressure_MPa);
  EXPECT_EQ(table.column("wear_depth_mm"), record.wear_depth_mm);
  const char* words[] = {"inactive", "stick", "slip"};
  EXPECT_EQ(table.column("frame"), std::vector<double>(table.rows(), 3.0));
  EXPECT_EQ(table.column("cycle"), std::vector<double>(table.rows(), 9000.0));
  for (std::size_t i = 0; i < table.rows(); ++i) EXPECT_EQ(table.word(table.column("body")[i]), frame.bodies[0].name);
  for (std::size_t i = 0; i < table.rows(); ++i)
    EXPECT_EQ(table.word(table.column("status")[i]), words[record.status[i]]);
}

// remesh.csv has exactly these columns, the residue named as what it is in the analysis.
TEST(Remesh, HasItsColumns) {
  using reye::base::Analysis;
  const std::string first =
      "step,cycle,body,nodes_before,nodes_after,scaled_jacobian_before,scaled_jacobian_after,projection_mm,";
  const std::string last = ",gap_moved_mm,gap_left_mm,pressure_jump,peak_jump,force_jump,energy_jump,reason\n";
  EXPECT_EQ(remesh_header(Analysis::plane_strain), first + "area_residue_mm2" + last);
  EXPECT_EQ(remesh_header(Analysis::plane_stress), first + "area_residue_mm2" + last);
  EXPECT_EQ(remesh_header(Analysis::axisymmetric), first + "volume_residue_mm3" + last);
}

// A row of remesh.csv reads back to the same doubles, whatever body and reason are called, and holds no times.
TEST(Remesh, RowReadsBack) {
  auto record = sample::remesh(1000.0 / 3.0);
  const std::string row = remesh_row(record);
  const Table table = parse_csv(remesh_header(reye::base::Analysis::plane_strain) + row);
  ASSERT_EQ(table.rows(), 1u);
  EXPECT_EQ(table.word(table.column("step")[0]), record.step);
  EXPECT_EQ(table.word(table.column("body")[0]), record.body);
  EXPECT_EQ(table.word(table.column("reason")[0]), record.reason);
  const std::pair<const char*, double> numbers[] = {{"cycle", record.cycle},
                                                    {"nodes_before", 120.0},
                                                    {"nodes_after", 135.0},
                                                    {"scaled_jacobian_before", record.scaled_jacobian_before},
                                                    {"scaled_jacobian_after", record.scaled_jacobian_after},
                                                    {"projection_mm", record.projection_mm},
                                                    {"area_residue_mm2", record.area_residue},
                                                    {"gap_moved_mm", record.gap_moved_mm},
                                                    {"gap_left_mm", record.gap_left_mm},
                                                    {"pressure_jump", record.pressure_jump},
                                                    {"peak_jump", record.peak_jump},
                                                    {"force_jump", record.force_jump},
                                                    {"energy_jump", record.energy_jump}};
  for (const auto& [column, value] : numbers) EXPECT_EQ(table.column(column).at(0), value) << column;
  record.seconds = record.mesh_seconds = 99.0;
  EXPECT_EQ(remesh_row(record), row);
}

// A file name never leaves the folder, whatever the contact is called.
TEST(Surface, FileNameIsPlain) {
  EXPECT_EQ(surface_file("pad", reye::sim::Side::primary), "surface_pad_primary.csv");
  EXPECT_EQ(surface_file("../a b", reye::sim::Side::secondary), "surface_.._a_b_secondary.csv");
}

// Cutting a table keeps the header and so many rows, drops half a row, and refuses to invent rows.
TEST(KeepRows, CutsToWholeRows) {
  sample::TemporaryFolder dir;
  const std::string path = dir / "t.csv";
  atomic_write(path, "a,b\n1,2\n3,4\n5,");
  keep_rows(path, 2);
  EXPECT_EQ(read_text(path), "a,b\n1,2\n3,4\n");
  EXPECT_THROW(keep_rows(path, 3), std::runtime_error);
  keep_rows(path, 0);
  EXPECT_EQ(read_text(path), "a,b\n");
  atomic_write(path, "a,b\n1,2\n3,4");
  EXPECT_THROW(keep_rows(path, 2), std::runtime_error);
}

// Half a last line of a killed run is not read; a row of another width is an error.
TEST(ParseCsv, KnowsWholeRows) {
  EXPECT_EQ(parse_csv("a,b\n1,2\n3").rows(), 1u);
  EXPECT_THROW(parse_csv("a,b\n1,2,3\n"), std::runtime_error);
}

// The worn amount of a table is depth times full nodal length, so it returns the removed volume.
TEST(WornAmount, IsDepthTimesNodalLength) {
  SurfaceTable surface{
      reye::sim::Side::secondary,
      parse_csv(surface_header() + "0,0,b,0,1,0,0,0,0,0,slip\n0,0,b,1,2,0,0,0,0,2,slip\n0,0,b,3,4,0,0,0,0,0,slip\n"),
      {{0.0, 0, 3}}};
  EXPECT_DOUBLE_EQ(worn_amount(surface, surface.frames[0], reye::base::Analysis::plane_strain), 3.0);
  EXPECT_DOUBLE_EQ(worn_amount(surface, surface.frames[0], reye::base::Analysis::axisymmetric), 12.0 * M_PI);
}
