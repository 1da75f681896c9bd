#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

#include "base/errors.hpp"
#include "problem_of.hpp"

using namespace reye;

namespace {

std::string text_of(const std::string& file) {
  std::ifstream in(std::string(REYE_SOURCE_DIR) + "/geo/two_pins/" + file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

sim::Problem two_pins(const std::string& geometry, const std::string& scene) {
  return support::problem_from({{"two_pins.geo", geometry}, {"scene.toml", scene}});
}

const std::string second_name = "[contact.second]\nsecondary = \"track\"";

}  // namespace

// The plan must say which contacts wear one boundary, and whose the depths there are.
TEST(SharedWear, IsToldInThePlan) {
  const auto problem = two_pins(text_of("two_pins.geo"), text_of("scene.toml"));
  const auto& lines = problem.plan.lines;
  EXPECT_EQ(std::count(lines.begin(), lines.end(),
                       "contacts first, second wear the same boundary, track: depths there are the sum over all of "
                       "them, areas and energies are counted per contact"),
            1);
}

// One edge under two names must be refused where one of the contacts wears it: its wear is booked under one name alone.
// Where none does, the two are as good as one.
TEST(SharedWear, AnEdgeUnderTwoNamesIsRefused) {
  const auto geometry = text_of("two_pins.geo") + "Physical Curve(\"lane\") = {3};\n";
  const auto scene = test::with(text_of("scene.toml"), {{second_name, "[contact.second]\nsecondary = \"lane\""}});
  try {
    two_pins(geometry, scene);
    ADD_FAILURE() << "accepted";
  } catch (const base::InputError& error) {
    EXPECT_NE(std::string(error.what())
                  .find("contact.second.secondary = \"lane\": has edges in common with \"track\" of contact "
                        "\"first\", and what wears there is booked by boundary: give both contacts the same one"),
              std::string::npos)
        << error.what();
  }
  const auto unworn = test::with(scene, {{"wear      = { law = \"energy\", secondary_mm3_per_J = 1e-3 }\n", ""},
                                         {"wear      = { law = \"energy\", secondary_mm3_per_J = 3e-3 }\n", ""}});
  EXPECT_NO_THROW(two_pins(geometry, unworn));
}
