#include <cmath>

#include "confined_column.hpp"
#include "wear_scene.hpp"

/// Laws that a scene writes as formulas, beside the built-in ones and closed forms.
namespace reye::verification {

namespace {

/// geo/line_contact_gross_slip, coarse: ten cycles.
Played sliding_line(Replacements words) {
  words.insert(words.begin(), {{"size_mm = 0.0018", "size_mm = 0.006"},
                               {"far_size_mm = 0.8", "far_size_mm = 2.0"},
                               {"increments = 5", "increments = 2"}});
  std::string text = scene_text("line_contact_gross_slip", {});
  text = text.substr(0, text.find("[[step]]\nname = \"to S = 1\""));
  words.push_back({"cycles = 50\njump = 1", "cycles = 12\njump = 3\nperiod_s = 0.2"});
  return played(replaced(text, words));
}

/// Both runs must end with the same worn volumes, node by node, after as many iterations.
void expect_equal(const Played& a, const Played& b) {
  const auto &x = a.state.solution.contacts.at(0), &y = b.state.solution.contacts.at(0);
  const auto close = [](const std::vector<double>& u, const std::vector<double>& v) {
    ASSERT_EQ(u.size(), v.size());
    const double scale = u.empty() ? 0.0 : *std::max_element(u.begin(), u.end());
    for (std::size_t j = 0; j < u.size(); ++j) EXPECT_NEAR(u[j], v[j], 1e-12 * scale) << j;
  };
  EXPECT_GT(x.law_volume, 0.0);
  close(x.removed_secondary, y.removed_secondary);
  close(x.removed_primary, y.removed_primary);
  close(x.energy_secondary, y.energy_secondary);
  EXPECT_EQ(a.summary.counts.newton_iterations, b.summary.counts.newton_iterations);
}

const std::string built_in = R"({ law = "archard", secondary_per_MPa = 2.0e-8, primary_per_MPa = 1.0e-8 })";

Played law(const std::string& words) { return sliding_line({{built_in, words}}); }

/// The column of references B6 under a coating of 2 um, with steps of ds and `more` in the scene.
Played coated_column(const Replacements& more) {
  return played(scene_text(
      "column",
      Replacements{{"secondary_per_MPa = 1.0e-7", "secondary_per_MPa = \"depth_mm < 0.002 ? 2e-8 : 1e-7\""}} + more));
}

}  // namespace

// Formulas must be the built-in laws to 1e-12, with the same iterations: constants, powers of pressure and of speed,
// and the whole rate.
TEST(FormulaLaw, EqualsArchard) {
  expect_equal(law(built_in), law(R"({ law = "archard", secondary_per_MPa = "2.0e-8", primary_per_MPa = "1.0e-8" })"));
  expect_equal(
      law(built_in),
      law(R"({ law = "rate", secondary_mm_per_mm = "2.0e-8*pressure_MPa", primary_mm_per_mm = "1.0e-8*pressure_MPa" })"));
}

TEST(FormulaLaw, EqualsPowersOfPressureAndSpeed) {
  expect_equal(
      law(R"({ law = "archard", secondary_per_MPa = 2.0e-8, primary_per_MPa = 1.0e-8, pressure_exponent = 0.5, pressure_ref_MPa = 300.0, speed_exponent = -0.3, speed_ref_mm_per_s = 2.0 })"),
      law(R"({ law = "archard", secondary_per_MPa = "2.0e-8*(pressure_MPa/300)^0.5*(speed_mm_per_s/2)^-0.3", primary_per_MPa = "1.0e-8*sqrt(pressure_MPa/300)/(speed_mm_per_s/2)^0.3" })"));
}

// Friction as a formula must be the number, and a table over the cycles, to 1e-12.
TEST(FormulaLaw, EqualsFriction) {
  const auto run = [](const std::string& friction, const std::string& alpha) {
    return sliding_line(
        {{"imposed_sliding_mm = 0.021756417", "friction = " + friction},
         {built_in, "{ law = \"energy\", secondary_mm3_per_J = " + alpha + " }"},
         {"x        = \"fixed\"\nrotation = \"fixed\"\ny        = { force",
          "x        = { motion_mm = 0.02, history = \"stroke\" }\nrotation = \"fixed\"\ny        = { force"},
         {"[history]\n", "[history]\nstroke = [[0.0, 0.0], [0.25, 1.0], [0.75, -1.0], [1.0, 0.0]]\n"},
         {"cycles = 50", "play = [\"stroke\"]\nincrements = 12\ncycles = 50"}});
  };
  expect_equal(run("0.6", "3.0e-5"), run("\"0.6\"", "\"3.0e-5\""));
  expect_equal(run("{ cycles = [0.0, 12.0], value = [0.6, 0.9] }", "3.0e-5"), run("\"0.6 + 0.3*cycle/12\"", "3.0e-5"));
}

// A coating of two coefficients on the column: backward Euler with the transition located inside its increment, in
// closed form, to 1e-9 at jump 1.
TEST(FormulaLaw, CoatingInTheColumn) {
  const Played run = coated_column({});
  constexpr double coat = 0.002, k1 = 2e-8, k2 = 1e-7, ds = 100.0;
  double w = 0.0;
  for (int step = 0; step < 10; ++step) {
    const double k = w < coat ? k1 : k2;
    double next = (w + k * Column::K * ds * Column::compression) / (1.0 + k * Column::K * ds);
    if (w < coat && next > coat)
      next = (coat + k2 * (Column::K * ds * Column::compression - (coat - w) / k1)) / (1.0 + k2 * Column::K * ds);
    w = next;
  }
  ASSERT_GT(w, 1.5 * coat);
  const double p = Column::K * (Column::compression - w);
  EXPECT_LT(worst(run.surface(sim::Side::secondary).pressure_MPa, p), 1e-9);
  EXPECT_LT(worst(run.surface(sim::Side::secondary).wear_depth_mm, w), 1e-9);
  EXPECT_LT(run.contact().ledger_relative_error.value(), 1e-12);
  for (const auto& record : run.records) EXPECT_LE(record.newton, 6);
}

// Under a tolerance the life of the coated column must be that of the differential equation, within the tolerance.
TEST(FormulaLaw, CoatedLifeUnderATolerance) {
  const Played run =
      coated_column({{"increments = 10\ncycles = 1",
                      "cycles = 4000\njump = { tolerance = 0.01 }\n[limit.half]\ncontact = \"foot\"\ndepth_mm = 0.005"},
                     {"imposed_sliding_mm = 1000.0", "imposed_sliding_mm = 1.0"}});
  const double exact = std::log(0.010 / 0.008) / (2e-8 * Column::K) + std::log(0.008 / 0.005) / (1e-7 * Column::K);
  EXPECT_NEAR(run.summary.life_cycles.at("half").value() / exact, 1.0, 0.01);
}

// A formula that falls below zero in the run must end it with the formula and the place.
TEST(FormulaLaw, NegativeValueEndsTheRun) {
  const auto text =
      scene_text("column", {{"secondary_per_MPa = 1.0e-7", "secondary_per_MPa = \"1e-7*(1 - path_mm/450)\""}});
  auto problem = prepared(text);
  auto state = sim::initial_state(problem);
  const auto summary = sim::run(problem, state, {});
  EXPECT_EQ(summary.status, sim::RunStatus::failed);
  EXPECT_NE(summary.reason.find("the formula \"1e-7*(1 - path_mm/450)\" is -"), std::string::npos) << summary.reason;
  EXPECT_NE(summary.reason.find("path_mm = 450"), std::string::npos) << summary.reason;
}

}  // namespace reye::verification
