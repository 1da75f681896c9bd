#include "sim/warnings.hpp"

#include <gtest/gtest.h>

namespace {

using namespace reye::sim;

// Of one kind about one thing the most severe warning stays, in its first place; the log reports it once.
TEST(Warnings, TheMostSevereStays) {
  State state;
  std::vector<std::string> said;
  Observer observer;
  observer.log = [&](const std::string& text) { said.push_back(text); };
  warn(state, observer, {"strain", "body pin", "strain of 2 %", 0.02});
  warn(state, observer, {"overlap", "", "bodies overlap by 1 um", 1.0});
  warn(state, observer, {"strain", "body pin", "strain of 4 %", 0.04});
  warn(state, observer, {"strain", "body pin", "strain of 3 %", 0.03});
  warn(state, observer, {"strain", "body block", "strain of 3 %", 0.03});
  ASSERT_EQ(state.warnings.size(), 3u);
  EXPECT_EQ(state.warnings[0].text, "strain of 4 %");
  EXPECT_EQ(said, (std::vector<std::string>{"warning: strain, body pin: strain of 2 %", "warning: overlap: bodies overlap by 1 um",
                                            "warning: strain, body block: strain of 3 %"}));
}

}  // namespace
