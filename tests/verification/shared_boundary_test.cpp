#include <cmath>
#include <numbers>
#include <numeric>

#include "mesh/measure.hpp"
#include "output/run/state_archive.hpp"
#include "sim/problem/observer.hpp"
#include "sim/study/run.hpp"
#include "support/problem.hpp"
#include "wear_scene.hpp"

/// A boundary that two contacts wear: geo/two_pins, and a shaft between two pads.
namespace reye::verification {

namespace {

struct TwoPins {
  static constexpr double way = 4.0, cycles = 40.0;  ///< way in mm
  static constexpr double first_rate = 1e-6 * 0.2 * 20.0,
                          second_rate = 3e-6 * 0.1 * 10.0;  ///< alpha mu F [mm^2 per mm of way]
};

const Replacements shorter{{"cycles     = 100", "cycles     = 40"}, {"jump       = 20", "jump       = 10"}};

/// The pins deform and carry the multipliers, the flat is the primary side of both contacts.
const Replacements exchanged{
    {"secondary = \"track\"\nprimary   = [\"first_foot\"]", "secondary = \"first_foot\"\nprimary   = [\"track\"]"},
    {"secondary = \"track\"\nprimary   = [\"second_foot\"]", "secondary = \"second_foot\"\nprimary   = [\"track\"]"},
    {"rigid = true\nmesh  = { far_size_mm = 0.05 }", "material = \"polymer\"\nmesh  = { far_size_mm = 0.045 }"},
    {"secondary_mm3_per_J", "primary_mm3_per_J"}};

/// Mean depth where both pins have gone over and neither turned, by the table of one contact.
double depth_in_the_middle(const sim::SurfaceRecord& s, double from, double to) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < s.x_mm.size(); ++i)
    if (s.x_mm[i] > from && s.x_mm[i] < to) {
      sum += s.wear_depth_mm[i];
      ++count;
    }
  EXPECT_GE(count, 3);
  return sum / count;
}

double area_lost(const Played& run, int body) {
  return mesh::area(run.problem.shapes[body]->mesh) - mesh::area(run.state.shapes[body]->mesh);
}

const char* name_of(sim::Side side) { return side == sim::Side::secondary ? "secondary" : "primary"; }

/// The figures of both contacts, each by itself and in sum; `side` of them is the flat.
void expect_two_tracks(const Played& run, sim::Side side, double tolerance) {
  const auto& all = run.summary.contacts;
  const auto worn = [&](int c) { return side == sim::Side::secondary ? all[c].secondary : all[c].primary; };
  const double alpha[] = {1e-6, 3e-6}, rate[] = {TwoPins::first_rate, TwoPins::second_rate};
  for (int c : {0, 1}) {
    EXPECT_NEAR(worn(c).worn_area / (alpha[c] * all[c].dissipated_energy), 1.0, 1e-12) << c;
    EXPECT_NEAR(worn(c).worn_area / (TwoPins::cycles * rate[c] * TwoPins::way), 1.0, 0.02)
        << c;  // elastic way at the turns
    EXPECT_LT(all[c].ledger_relative_error.value(), 1e-10) << c;
  }
  EXPECT_NEAR(area_lost(run, 0) / (worn(0).worn_area + worn(1).worn_area), 1.0, 1e-9);
  const double both = TwoPins::cycles * 2.0 * (TwoPins::first_rate + TwoPins::second_rate);
  for (int c : {0, 1}) {
    const auto& s = run.frame.surfaces.at(2 * static_cast<std::size_t>(c) + (side == sim::Side::secondary ? 0 : 1));
    EXPECT_NEAR(depth_in_the_middle(s, 3.9, 4.1) / both, 1.0, tolerance) << c;  // of both, in the table of either
  }
  const auto& first = run.frame.surfaces.at(side == sim::Side::secondary ? 0 : 1);
  EXPECT_NEAR(depth_in_the_middle(first, 2.88, 3.22) / (TwoPins::cycles * 2.0 * TwoPins::first_rate), 1.0, tolerance);
  for (const auto& row : run.records) {  // supports: base, first, second
    base::Vec2 sum = base::Vec2::Zero();
    for (const auto& force : row.support_forces) sum += force;
    EXPECT_LT(sum.norm(), 1e-8);
    for (std::size_t c : {0U, 1U})
      EXPECT_NEAR(std::hypot(row.contacts[c].normal_force, row.contacts[c].tangential_force),
                  row.support_forces[c + 1].norm(), 1e-8);
  }
}

}  // namespace

/// Two pins that run over one track must each wear it by their own work, and its depth must be the sum in the tables of
/// both.
TEST(SharedBoundary, TwoPinsOnASecondaryTrack) {
  expect_two_tracks(played(scene_text("two_pins", shorter)), sim::Side::secondary, 0.01);
}

/// So they must where the track is the primary side of both.
TEST(SharedBoundary, TwoPinsOnAPrimaryTrack) {
  expect_two_tracks(played(scene_text("two_pins", shorter + exchanged)), sim::Side::primary, 0.02);
}

/// Remeshes must carry what each has worn.
TEST(SharedBoundary, AcrossRemeshes) {
  const Replacements remesh{{"[history]", "[remesh]\nevery_blocks = 2\n\n[history]"}};
  for (const auto side : {sim::Side::secondary, sim::Side::primary}) {
    const auto run =
        played(scene_text("two_pins", shorter + remesh + (side == sim::Side::secondary ? Replacements{} : exchanged)));
    EXPECT_GE(run.summary.counts.remeshes, 1);
    expect_two_tracks(run, side, 0.02);
  }
}

/// A limit of depth must watch what all have worn, whichever contact it names.
TEST(SharedBoundary, ALimitWatchesTheSum) {
  const double half = 0.5 * TwoPins::cycles * 2.0 * (TwoPins::first_rate + TwoPins::second_rate);
  const Replacements limit{
      {"[history]", "[limit.deep]\ncontact = \"second\"\ndepth_mm = " + std::to_string(half) + "\n\n[history]"}};
  const auto run = played(scene_text("two_pins", shorter + limit));
  ASSERT_TRUE(run.summary.life_cycles.at("deep").has_value());
  EXPECT_NEAR(*run.summary.life_cycles.at("deep"), 0.5 * TwoPins::cycles, 0.6);
}

/// What one pin has left in the gap the other must find gone: with all wear waiting there a pin sinks as far as into a
/// worn shape.
TEST(SharedBoundary, WearThatWaitsIsSeenByBoth) {
  const Replacements deep{{"mm3_per_J = 1e-3", "mm3_per_J = 2e-2"},
                          {"mm3_per_J = 3e-3", "mm3_per_J = 6e-2"},
                          {"[history]", "[output.probes]\nhead = { body = \"first\", at_mm = [2.4, 1] }\n\n[history]"}};
  const Replacements in_gap{{"title ", "shape = \"off\"\ntitle "}};
  // Where the run ends both pins stand on what both have worn.
  const Replacements halfway{
      {"stroke = [[0, 0], [0.5, 1], [1, 0]]", "stroke = [[0, 0], [0.25, 0.5], [0.75, -0.5], [1, 0]]"},
      {"motion_mm = 2.0", "motion_mm = 3.0"},
      {"increments = 80", "increments = 120"}};
  for (const auto side : {sim::Side::secondary, sim::Side::primary}) {
    const auto roles = side == sim::Side::secondary ? Replacements{} : exchanged;
    const auto shaped = played(scene_text("two_pins", shorter + roles + deep + halfway));
    const auto waiting = played(scene_text("two_pins", shorter + roles + deep + halfway + in_gap));
    const double worn = shaped.contact().secondary.max_depth_mm + shaped.contact().primary.max_depth_mm;
    EXPECT_GT(worn, 4e-3);
    EXPECT_NEAR(waiting.summary.probes.at("head").y(), shaped.summary.probes.at("head").y(), 0.05 * worn)
        << name_of(side);
    EXPECT_NEAR(waiting.contact().secondary.max_depth_mm + waiting.contact().primary.max_depth_mm, worn, 0.02 * worn)
        << name_of(side);
  }
}

/// A jump that is chosen by its error must count each contact's wear once.
TEST(SharedBoundary, UnderATolerance) {
  const Replacements chosen{{"jump       = 20", "jump       = { tolerance = 0.1 }"},
                            {"increments = 80", "increments = 40"},
                            {"cycles     = 100", "cycles     = 40"}};
  expect_two_tracks(played(scene_text("two_pins", chosen)), sim::Side::secondary, 0.05);
}

/// One contact may be without friction and wear, and one only.
TEST(SharedBoundary, OneWithoutFriction) {
  const auto run = played(scene_text(
      "two_pins",
      shorter + Replacements{{"friction  = 0.1\nwear      = { law = \"energy\", secondary_mm3_per_J = 3e-3 }",
                              "friction  = 0.0"}}));
  const auto& all = run.summary.contacts;
  EXPECT_NEAR(all[0].secondary.worn_area / (TwoPins::cycles * TwoPins::first_rate * TwoPins::way), 1.0, 0.02);
  EXPECT_EQ(all[1].secondary.worn_area, 0.0);
  EXPECT_EQ(all[1].dissipated_energy, 0.0);
  EXPECT_NEAR(all[1].normal_force, 10.0, 1e-3);
}

/// At finite strain each contact must balance its pin and count its work, too.
TEST(SharedBoundary, AtFiniteStrain) {
  const Replacements finite{
      {"material = \"polymer\"\nmesh     = { far_size_mm = 0.5 }",
       "material = \"polymer\"\nkinematics = \"finite\"\nmesh     = { far_size_mm = 0.7 }"},
      {"nu    = 0.4", "nu    = 0.4\nlaw = \"neo_hookean\""},
      {"half_width_mm = 3, depth_mm = 0.2, size_mm = 0.05", "half_width_mm = 2, depth_mm = 0.1, size_mm = 0.1"},
      {"increments = 80", "increments = 10"},
      {"motion_mm = 2.0", "motion_mm = 0.5"},
      {"cycles     = 100", "cycles     = 20"},
      {"jump       = 20", "jump       = 10"}};
  const auto run = played(scene_text("two_pins", finite));
  const double alpha[] = {1e-6, 3e-6};
  for (std::size_t c : {0U, 1U}) {
    const auto& contact = run.summary.contacts[c];
    EXPECT_GT(contact.dissipated_energy, 0.0);
    EXPECT_NEAR(contact.secondary.worn_area / (alpha[c] * contact.dissipated_energy), 1.0, 1e-10);
    for (const auto& row : run.records)
      EXPECT_NEAR(std::hypot(row.contacts[c].normal_force, row.contacts[c].tangential_force),
                  row.support_forces[c + 1].norm(), 1e-6);
  }
}

/// A run that resumes from its bytes must leave the bytes of one that was never interrupted.
TEST(SharedBoundary, GoesOnFromItsBytes) {
  const auto text = scene_text("two_pins", shorter);
  const auto whole = played(text);
  const auto problem = prepared(text);
  auto state = sim::initial_state(problem);
  int increments = 0;
  sim::Observer breaking;
  breaking.increment = [&](const sim::IncrementRecord&) { ++increments; };
  std::string bytes;
  breaking.block = [&](const sim::State& at) {
    if (bytes.empty() && at.counts.blocks == 3) bytes = output::state_to_bytes(at);
  };
  breaking.interrupted = [&] { return !bytes.empty(); };
  ASSERT_EQ(sim::run(problem, state, breaking).status, sim::RunStatus::interrupted);
  auto again = output::state_from_bytes(bytes);
  sim::Observer showing;
  showing.frame = [](const sim::Frame&) {};
  ASSERT_EQ(sim::run(problem, again, showing).status, sim::RunStatus::done);
  EXPECT_TRUE(output::state_to_bytes(again) == output::state_to_bytes(whole.state));
}

namespace {

/// A shaft of R = 10 that turns between two pads, pressed from above with 40 N/mm.
Played between_pads(const std::string& lower, const std::string& upper) {
  const auto problem = support::problem_from({{"pads.geo", R"(SetFactory("OpenCASCADE");
Disk(1) = {0, 10, 0, 10};
Disk(2) = {0, 10, 0, 4};
BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };
Rectangle(4) = {-3, -3, 0, 6, 3};
Rectangle(5) = {-3, 20, 0, 6, 3};
Physical Surface("shaft") = {3};
Physical Surface("low") = {4};
Physical Surface("high") = {5};
)"},
                                              {"scene.toml", R"(geometry = ["pads.geo"]
[material.steel]
E_MPa = 210e3
nu = 0.3
[material.pom]
E_MPa = 2800
nu = 0.38
[body.shaft]
material = "steel"
mesh = { far_size_mm = 0.5 }
[body.low]
material = "pom"
mesh = { far_size_mm = 0.35 }
[body.high]
material = "pom"
mesh = { far_size_mm = 0.35 }
[boundary]
journal = { body = "shaft", nearest_mm = [0, 0] }
hub = { body = "shaft", nearest_mm = [0, 6] }
low_top = { body = "low", nearest_mm = [0, 0] }
low_base = { body = "low", nearest_mm = [0, -3] }
high_foot = { body = "high", nearest_mm = [0, 20] }
high_head = { body = "high", nearest_mm = [0, 23] }
)" + lower + upper + R"([support.low]
edge = "low_base"
x = "fixed"
y = "fixed"
[support.high]
edge = "high_head"
x = "fixed"
rotation = "fixed"
y = { force_N_per_mm = -40, history = "press" }
[support.shaft]
edge = "hub"
x = "fixed"
rotation = { motion_rad = 6.283185307179586, history = "turn" }
[history]
press = [[0, 0], [1, 1]]
turn = [[0, 0], [1, 1]]
[[step]]
name = "press"
play = ["press"]
increments = 10
wear = false
[[step]]
name = "turns"
play = ["turn"]
increments = 24
cycles = 4
jump = 1
)"}});
  Played p;
  p.problem = problem;
  p.state = sim::initial_state(p.problem);
  sim::Observer watch;
  watch.frame = [&](const sim::Frame& f) { p.frame = f; };
  p.summary = sim::run(p.problem, p.state, watch);
  EXPECT_EQ(p.summary.status, sim::RunStatus::done) << p.summary.reason;
  return p;
}

std::string pad(const std::string& name, const std::string& edge, double friction, bool journal_is_secondary,
                double k) {
  const std::string journal = "\"journal\"", other = '"' + edge + '"';
  return "[contact." + name + "]\nsecondary = " + (journal_is_secondary ? journal : other) + "\nprimary = [" +
         (journal_is_secondary ? other : journal) + "]\nfriction = " + std::to_string(friction) +
         "\nwear = { law = \"archard\", " + (journal_is_secondary ? "secondary" : "primary") +
         "_per_MPa = " + std::to_string(k) + " }\n";
}

}  // namespace

/// Every place of a shaft that turns comes under both pads in turn, on either side of the contacts: each wears
/// coefficient x load x way, and the shape loses the sum.
TEST(SharedBoundary, AShaftTurningUnderTwoPads) {
  const double k[] = {1e-5, 3e-5}, sliding = 4.0 * 2.0 * std::numbers::pi * 10.0;
  for (const bool secondary : {true, false}) {
    const auto run =
        between_pads(pad("low", "low_top", 0.2, secondary, k[0]), pad("high", "high_foot", 0.1, secondary, k[1]));
    double sum = 0.0;
    for (std::size_t c : {0U, 1U}) {
      const auto& contact = run.summary.contacts.at(c);
      const auto& worn = secondary ? contact.secondary : contact.primary;
      EXPECT_NEAR(worn.worn_area / (k[c] * 40.0 * sliding), 1.0, 0.02) << c << secondary;
      EXPECT_LT(contact.ledger_relative_error.value(), 1e-9) << c << secondary;
      sum += worn.worn_area;
      // Both tables report the same depth where both have worn.
      const auto& s = run.frame.surfaces.at(2 * c + (secondary ? 0 : 1));
      double content = 0.0;
      for (std::size_t i = 1; i < s.x_mm.size(); ++i)
        content += 0.5 * (s.wear_depth_mm[i] + s.wear_depth_mm[i - 1]) * (s.arc_length_mm[i] - s.arc_length_mm[i - 1]);
      EXPECT_NEAR(content / (4.0 * 10.0 * 40.0 * 2.0 * std::numbers::pi * (k[0] + k[1])), 1.0, 0.05) << c << secondary;
    }
    EXPECT_NEAR(area_lost(run, 0) / sum, 1.0, 1e-8) << secondary;
  }
}

}  // namespace reye::verification
