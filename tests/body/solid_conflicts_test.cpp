#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "body/solid/solid_conflicts.hpp"
#include "body/solid_inputs.hpp"

namespace reye::support::solids {

namespace {

/// The first conflict's text, or "none".
std::string conflict(const SolidInput& input) {
  const auto found = body::solid_support_conflicts(input);
  return found.empty() ? "none" : found.front().text;
}

// Supports that contradict each other must be found, and equal ones not; a body with a conflict is not made.
TEST(solid_conflicts, found_where_they_are) {
  SolidInput input = input_of(SolidKind::hex8);
  const auto with = [&](std::vector<SolidSupport> supports) {
    input.supports = std::move(supports);
    return conflict(input);
  };
  const auto says = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  const SolidSupport clamp = by_node("x0", {fixed, fixed, fixed});
  EXPECT_EQ(with({clamp, along_normal("y0"), along_normal("z0")}), "none");
  EXPECT_EQ(with({by_node("x0", {moved(0.1, "h"), fixed, fixed}), by_node("y0", {moved(0.1, "h"), fixed, Motion{}})}),
            "none");
  says(with({by_node("x0", {moved(0.1, "h"), fixed, fixed}), by_node("y0", {moved(0.1, "g"), fixed, Motion{}})}),
       "another motion than support \"x0\"");
  says(with({clamp, along_normal("y0", moved(0.1))}), "another motion than support \"x0\"");
  EXPECT_THROW(SolidBody(input, {}), base::InputError);
  says(with({rigid_face("x0", {fixed, fixed, moved(1)}, {fixed, fixed, fixed}),
             rigid_face("y0", {fixed, fixed, fixed}, {fixed, fixed, fixed})}),
       "both are rigid faces");
  says(with({rigid_face("x0", {fixed, fixed, loaded(1)}, {fixed, fixed, fixed}), along_normal("z0")}),
       "whose z is loaded");
  EXPECT_EQ(with({rigid_face("x0", {moved(1), fixed, fixed}, {fixed, fixed, fixed}), along_normal("z0")}), "none");
  says(with({by_node("x0", {loaded(1), fixed, fixed})}), "cannot be loaded");
  SolidSupport turning = clamp;
  turning.about[0] = fixed;
  says(with({turning}), "turns only where it is rigid");
  SolidSupport normal = rigid_face("x0", {fixed, fixed, fixed}, {fixed, fixed, fixed});
  normal.normal = fixed;
  says(with({normal}), "no motion along its normal");
  input.supports = {by_node("nowhere", {fixed, fixed, fixed})};
  EXPECT_THROW(body::solid_support_conflicts(input), base::InputError);
  input.rigid = true;
  says(with({rigid_face("", {fixed, fixed, moved(1)}, {fixed, fixed, fixed}),
             rigid_face("x0", {Motion{}, Motion{}, fixed}, {})}),
       "drives the rigid body");
  EXPECT_EQ(with({rigid_face("", {fixed, fixed, Motion{}}, {fixed, fixed, fixed}),
                  rigid_face("x0", {Motion{}, Motion{}, moved(1)}, {})}),
            "none");
}

}  // namespace

}  // namespace reye::support::solids
