#include <cmath>

#include "confined_column.hpp"
#include "sim/problem/records.hpp"
#include "support/scene_words.hpp"
#include "wear_scene.hpp"

/// Sliding that is imposed with sign and history: what slides forth and back wears as what slides forth alone.
namespace reye::verification {

namespace {

const std::string rub = "press = [[0.0, 0.0], [1.0, 1.0]]\nrub = [[0.0, 0.0], [0.25, 1.0], [0.75, -1.0], [1.0, 0.0]]";

/// geo/column slid by 100 mm in each of ten increments of ten, in one play.
Played slid_column(const std::string& sliding) {
  return played(
      scene_text("column", {{"imposed_sliding_mm = 1000.0", "imposed_sliding_mm = " + sliding},
                            {"press = [[0.0, 0.0], [1.0, 1.0]]", rub + "\nhalf = [[0.0, 0.0], [0.5, 1.0], [1.0, 0.0]]"},
                            {"increments = 10\n", "increments = 10\nplay = [\"half\"]\n"}}));
}

/// geo/sliding_block of ordinary steel, all sides free, slid forth and back with the given sign; ten cycles in one
/// block.
Played rubbed_block(const std::string& value, const std::string& law) {
  return played(
      scene_text("sliding_block",
                 {{"imposed_sliding_mm = 100.0", "imposed_sliding_mm = { value = " + value + ", history = \"rub\" }"},
                  {"E_MPa = 200e6", "E_MPa = 200e3"},
                  {"traction_MPa = [0.0, 3.0]", "traction_MPa = [0.0, 0.0]"},
                  {"traction_MPa = [0.0, -3.0]", "traction_MPa = [0.0, 0.0]"},
                  {"motion_mm = 3.0e-7", "motion_mm = 0.0"},
                  {"far_size_mm = 0.7", "far_size_mm = 0.5"},
                  {"press = [[0.0, 0.0], [1.0, 1.0]]", rub},
                  {"law = \"energy\", secondary_mm3_per_J = 1.0e-4, primary_mm3_per_J = 0.5e-4", law},
                  {"cycles = 10", "cycles = 10\njump = 10\nplay = [\"rub\"]\nincrements = 8"}}));
}

/// Two teeth, R = 10 and 20, pressed with 200 N/mm and slid by 0.05 mm a cycle without friction.
const std::string teeth_geometry = R"(SetFactory("OpenCASCADE");
R1 = 10; R2 = 20; w = 2; d = 2;
y1 = Sqrt(R1^2 - w^2) - R1; y2 = R2 - Sqrt(R2^2 - w^2);
Point(1) = {-w, -d, 0}; Point(2) = {w, -d, 0}; Point(3) = {w, y1, 0}; Point(4) = {-w, y1, 0}; Point(5) = {0, -R1, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Circle(3) = {3, 5, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Point(11) = {-w, d, 0}; Point(12) = {w, d, 0}; Point(13) = {w, y2, 0}; Point(14) = {-w, y2, 0}; Point(15) = {0, R2, 0};
Line(11) = {11, 14}; Circle(12) = {14, 15, 13}; Line(13) = {13, 12}; Line(14) = {12, 11};
Curve Loop(2) = {11, 12, 13, 14}; Plane Surface(2) = {2};
Physical Surface("lower") = {1}; Physical Surface("upper") = {2};
Physical Curve("foot") = {1}; Physical Curve("crown") = {3}; Physical Curve("tread") = {12}; Physical Curve("hub") = {14};
)";

const std::string teeth =
    "geometry = [\"reye_teeth.geo\"]\n" +
    support::steel_bodies({{"lower", "far_size_mm = 0.5"}, {"upper", "far_size_mm = 0.5"}}, "210e3") +
    R"([contact.flank]
secondary = "crown"
primary   = ["tread"]
imposed_sliding_mm = 0.05
friction  = 0.0
wear      = { law = "archard", secondary_per_MPa = 1e-9, primary_per_MPa = 1e-9 }
fine_zone = { centre_mm = [0.0, 0.0], half_width_mm = 0.45, depth_mm = 0.15, size_mm = 0.03 }
[support.low]
edge     = "foot"
x        = "fixed"
y        = "fixed"
rotation = "fixed"
[support.up]
edge     = "hub"
x        = "fixed"
rotation = "fixed"
y        = { force_N_per_mm = -200.0, history = "press" }
)" + support::press_step(4) +
    R"([[step]]
name = "mesh"
cycles = 4e4
jump = 4000
)";

const std::string energy_law = "law = \"energy\", secondary_mm3_per_J = 1.0e-4, primary_mm3_per_J = 0.5e-4";
const std::string archard_law = "law = \"archard\", secondary_per_MPa = 0.3e-7, primary_per_MPa = 0.15e-7";

}  // namespace

/// A column that is slid forth and back wears by the same backward Euler values as one that is slid forth alone: p0 /
/// (1 + k K ds)^n.
TEST(SlidingHistory, ForthAndBackAsForthAlone) {
  const double p = Column::K * Column::compression / std::pow(1.0 + Column::k * Column::K * 100.0, 10.0);
  int newton = 0;
  for (const char* sliding :
       {"1000.0", "{ value = 500.0, history = \"half\" }", "{ value = -500.0, history = \"half\" }",
        "[{ value = 200.0, history = \"half\" }, { value = 300.0, history = \"half\" }]"}) {
    const Played run = slid_column(sliding);
    EXPECT_LT(worst(run.surface(sim::Side::secondary).pressure_MPa, p), 1e-9) << sliding;
    EXPECT_LT(worst(run.surface(sim::Side::secondary).wear_depth_mm, Column::compression - p / Column::K), 1e-9)
        << sliding;
    int own = 0;
    for (const auto& row : run.records) own += row.newton;
    if (newton == 0) newton = own;
    EXPECT_EQ(own, newton) << sliding << " takes as many solves";
  }
}

/// By either law the volume is exact, the two ways of rubbing wear mirror images with as many solves, and no
/// reversal costs smaller increments.
TEST(SlidingHistory, EitherSignWearsTheMirrorImage) {
  for (const auto& law : {energy_law, archard_law}) {
    const Played forth = rubbed_block("25.0", law), back = rubbed_block("-25.0", law);
    for (const auto* run : {&forth, &back}) {
      EXPECT_NEAR(run->contact().secondary.worn_area / 3e-3, 1.0,
                  2e-5);  // alpha mu P s, s = 4 x 25 mm x 10 cycles; the surfaces lean
      EXPECT_NEAR(run->contact().primary.worn_area / 1.5e-3, 1.0, 2e-5);
      EXPECT_NEAR(run->contact().dissipated_energy / 30000.0, 1.0, 2e-5);
    }
    EXPECT_NEAR(back.contact().secondary.worn_area, forth.contact().secondary.worn_area, 1e-9);
    ASSERT_EQ(back.records.size(), forth.records.size());
    EXPECT_EQ(forth.summary.counts.cutbacks + back.summary.counts.cutbacks, 0)
        << "a reversal costs no smaller increments";
    for (std::size_t i = 0; i < forth.records.size(); ++i) {
      EXPECT_NEAR(back.records[i].newton, forth.records[i].newton, 1) << i;  // which end opens first is rounding
      EXPECT_NEAR(back.records[i].support_forces[0].x(), -forth.records[i].support_forces[0].x(), 1e-6) << i;
    }
    const auto& right = forth.surface(sim::Side::secondary).wear_depth_mm;
    const auto& left = back.surface(sim::Side::secondary).wear_depth_mm;
    for (std::size_t i = 0; i < right.size(); ++i) EXPECT_NEAR(left[left.size() - 1 - i], right[i], 1e-9) << i;
  }
}

/// Archard's law wears by the way alone, so that a contact without friction, whose front moves on as it wears, takes as
/// many solves slid one way as the other, and no smaller increments, to the same depths.
TEST(SlidingHistory, ArchardKnowsNoDirection) {
  std::ofstream(support::temporary_folder() + "reye_teeth.geo") << teeth_geometry;
  const Played forth = played(teeth),
               back = played(replaced(teeth, {{"imposed_sliding_mm = 0.05", "imposed_sliding_mm = -0.05"}}));
  EXPECT_EQ(back.summary.counts.newton_iterations, forth.summary.counts.newton_iterations);
  EXPECT_EQ(back.summary.counts.cutbacks + forth.summary.counts.cutbacks, 0);
  EXPECT_NEAR(forth.contact().secondary.worn_area / 4e-4, 1.0, 1e-4);  // k P s N
  EXPECT_NEAR(back.contact().secondary.worn_area, forth.contact().secondary.worn_area, 1e-12);
  EXPECT_NEAR(back.contact().secondary.max_depth_mm, forth.contact().secondary.max_depth_mm, 1e-9);
}

/// Shear follows the direction of sliding through its reversals, and what rests keeps its own.
TEST(SlidingHistory, FrictionPointsTheWayThatIsSlid) {
  const Played run = rubbed_block("25.0", energy_law);
  for (const auto& row : run.records) {
    const bool forth = row.step == "press" || row.progress <= 0.25 || row.progress > 0.75;
    EXPECT_NEAR(std::abs(row.support_forces[0].x()), 30.0, 1e-2) << row.progress;  // the surfaces lean by 1e-4
    EXPECT_EQ(row.support_forces[0].x() * run.records.front().support_forces[0].x() > 0.0, forth) << row.progress;
  }
}

}  // namespace reye::verification
