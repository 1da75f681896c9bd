#include <gtest/gtest.h>

#include "sim/measure/stick_zone.hpp"

using namespace reye;

namespace {

/// Half of a contact sticks, ten elements wide.
constexpr sim::StickZone half{5.0, 10.0, 0.5};

}  // namespace

// The depths of the end must be those of the limit profiles: of cylinders 0.2255 a^2 / 2R at Q = mu P / 2 (references
// B4), of balls 0.18897 and 0.011158 a^2 / 2R at Q = 0.5 and 0.1 mu P.
TEST(StickZone, LimitDepths) {
  EXPECT_NEAR(sim::limit_depth_of_cylinders(std::sqrt(0.5)), 0.225466, 1e-6);
  EXPECT_NEAR(sim::limit_depth_of_cylinders(0.5), 0.547596, 1e-6);
  EXPECT_NEAR(sim::limit_depth_of_balls(std::cbrt(0.5)), 2.0 * 0.094485, 2e-6);
  EXPECT_NEAR(sim::limit_depth_of_balls(std::cbrt(0.9)), 2.0 * 0.005579, 2e-6);
}

// A stick zone must be compared with the widest that was seen, and what it loses be reported from the bound on.
TEST(StickZone, LossIsReported) {
  sim::StickZone widest;
  const auto after = [&](double stick) {
    return sim::receding_stick("contact pad", {stick, 10.0, 0.5}, widest, 2.0, 7.0, sim::limit_depth_of_balls);
  };
  EXPECT_FALSE(after(4.0));
  EXPECT_FALSE(after(5.0));
  EXPECT_EQ(widest.stick_mm, 5.0);
  EXPECT_FALSE(after(4.01));
  const auto warning = after(3.9);
  ASSERT_TRUE(warning);
  EXPECT_EQ(warning->kind, "stick_zone");
  EXPECT_NE(warning->text.find("receded from 5 to 3.9 mm by cycle 7"), std::string::npos) << warning->text;
  const auto gone = after(0.0);
  ASSERT_TRUE(gone);
  EXPECT_NE(gone->text.find("without bound"), std::string::npos) << gone->text;
}

// A contact that sticks as a whole has no edge to lose, and one without a stick zone none to resolve.
TEST(StickZone, WithoutAnEdgeNothingIsSaid) {
  sim::StickZone whole{10.0, 10.0, 0.5};
  EXPECT_FALSE(sim::receding_stick("", {2.0, 10.0, 0.5}, whole, 2.0, 1.0, sim::limit_depth_of_balls));
  EXPECT_FALSE(sim::unresolved_stick("", whole, sim::limit_depth_of_balls));
  EXPECT_FALSE(sim::unresolved_stick("", {}, sim::limit_depth_of_balls));
}

// An edge that is known to one element must be reported while the depth hangs on it, with a size that would do.
TEST(StickZone, CoarseEdgeIsReported) {
  const auto warning = sim::unresolved_stick("", half, sim::limit_depth_of_balls);
  ASSERT_TRUE(warning);
  EXPECT_EQ(warning->kind, "stick_elements");
  EXPECT_NE(warning->text.find("has 10 elements"), std::string::npos) << warning->text;
  EXPECT_FALSE(sim::unresolved_stick("", {half.stick_mm, half.contact_mm, 0.02}, sim::limit_depth_of_balls));
}
