#include <gtest/gtest.h>

#include "contact/complementarity.hpp"

namespace {

using namespace reye;
using contact::conditions;
using contact::ContactStatus;
using wear::LawKind;

/// Pressure 10, shear 2 and slip 0.5 at a node whose normal is 30 degrees off the x axis.
contact::NodeScalars<double> node() {
  const double c = std::sqrt(0.75), s = 0.5;
  contact::NodeScalars<double> n;
  n.normal = {c, s};
  n.lambda = {10.0 * c - 2.0 * s, 10.0 * s + 2.0 * c};
  n.motion = {-0.5 * s + 7.0 * c, 0.5 * c + 7.0 * s};
  n.gap = 0.25;
  n.D = 4.0;
  n.worn_others = 0.125;
  return n;
}

contact::NodeConstants constants() {
  contact::NodeConstants c;
  c.friction = 0.3;
  c.sign = 1.0;
  c.depth = 0.01;
  c.depth_per_volume = 0.02;
  c.law.kind = LawKind::energy;
  c.law.secondary = 1.0;
  return c;
}

// A sticking node must have slip as its tangential condition, no work, and only earlier wear in its gap.
TEST(conditions, stick) {
  const auto r = conditions(node(), constants(), ContactStatus::stick);
  EXPECT_NEAR(r.lambda_n, 10.0, 1e-14);
  EXPECT_NEAR(r.lambda_t, 2.0, 1e-14);
  EXPECT_NEAR(r.tangential, 0.5, 1e-14);
  EXPECT_EQ(r.worn.secondary, 0.0);
  EXPECT_NEAR(r.normal, 0.25 + 4.0 * 0.01 + 0.125, 1e-14);
}

// A slipping node must have lambda_t = mu lambda_n sign, and the wear of its own work in its gap.
TEST(conditions, slip_with_either_law) {
  auto c = constants();
  auto r = conditions(node(), c, ContactStatus::slip);
  EXPECT_NEAR(r.tangential, 2.0 - 0.3 * 10.0, 1e-14);
  EXPECT_NEAR(r.worn.secondary, 2.0 * 0.5, 1e-14);
  EXPECT_NEAR(r.normal, 0.25 + 4.0 * (0.01 + 0.02 * 1.0) + 0.125, 1e-14);
  c.sign = -1.0;
  c.law.kind = LawKind::archard;
  r = conditions(node(), c, ContactStatus::slip);
  EXPECT_NEAR(r.tangential, 2.0 + 0.3 * 10.0, 1e-14);
  EXPECT_NEAR(r.normal, 0.25 + 4.0 * (0.01 + 0.02 * 5.0) + 0.125, 1e-14);
}

// Factors of pressure and speed and the threshold must act on the work that stands in the gap.
TEST(conditions, slip_with_the_whole_law) {
  auto c = constants();
  c.law.pressure_exponent = 0.5;
  c.law.pressure_ref = 2.5;
  c.law.speed_exponent = 1.0;
  c.law.speed_ref = 0.05;
  c.law.threshold = 7.0;
  c.start = {
      .jump = 4.0, .duration_s = 1.25, .energy = 12.0, .area = 2.0};  // 2 of 4 x 1 mJ are still lacking; 0.1 mm/s
  const auto r = conditions(node(), c, ContactStatus::slip);
  EXPECT_NEAR(r.worn.secondary, 4.0 * 0.5 * 2.0 * 2.0, 4e-14);
  EXPECT_NEAR(r.normal, 0.25 + 4.0 * (0.01 + 0.02 * 8.0) + 0.125, 1e-14);
}

// Imposed sliding must be a number times the covered length, whatever the motion.
TEST(conditions, imposed_sliding) {
  auto c = constants();
  c.imposed = true;
  c.imposed_slip = -3.0;
  const auto r = conditions(node(), c, ContactStatus::slip);
  EXPECT_NEAR(r.slip, -12.0, 1e-14);
  EXPECT_NEAR(r.worn.secondary, 2.0 * 12.0, 1e-13);
}

// Sliding out of the plane must leave no shear in the plane, and work with mu times the pressure.
TEST(conditions, sliding_out_of_the_plane) {
  auto c = constants();
  c.imposed = c.out_of_plane = true;
  c.imposed_slip = 3.0;
  c.sign = 0.0;
  auto r = conditions(node(), c, ContactStatus::slip);
  EXPECT_NEAR(r.tangential, 2.0, 1e-14);
  EXPECT_NEAR(r.drag, 0.3 * 10.0, 1e-14);
  EXPECT_NEAR(r.worn.secondary, 0.3 * 10.0 * 12.0, 1e-13);
  c.law.kind = LawKind::archard;
  EXPECT_NEAR(conditions(node(), c, ContactStatus::slip).worn.secondary, 10.0 * 12.0, 1e-13);
}

// A node that neither side moves along the surface must keep its shear while it sticks, within the friction bound.
TEST(conditions, unmoved) {
  auto c = constants();
  c.unmoved = true;
  c.held_shear = 1.5;
  EXPECT_NEAR(conditions(node(), c, ContactStatus::stick).tangential, 2.0 - 1.5, 1e-14);
  c.held_shear = -5.0;
  EXPECT_NEAR(conditions(node(), c, ContactStatus::stick).tangential, 2.0 + 3.0, 1e-14);
  EXPECT_NEAR(conditions(node(), c, ContactStatus::slip).tangential, 2.0 - 3.0, 1e-14);
}

// A node that has just closed, at zero pressure, must wear with the pressure that comes, whichever way it slides.
TEST(conditions, wear_of_a_node_that_just_closed) {
  using One = base::Dual<1>;
  for (double slip : {0.7, -0.7}) {
    const One work = wear::plain_work(wear::Law{.kind = LawKind::archard},
                                      wear::along_a_line(One::variable(0.0, 0), One(0.0), One(slip), One(1.0)));
    EXPECT_DOUBLE_EQ(work.d[0], 0.7);
  }
}

// Held shear must be taken as given, cut to the friction bound, shared by the anchor; the anchor itself sticks.
TEST(conditions, held_shear) {
  auto c = constants();
  c.held = true;
  c.held_shear = 1.5;
  EXPECT_NEAR(conditions(node(), c, ContactStatus::slip).tangential, 2.0 - 1.5, 1e-14);
  EXPECT_EQ(conditions(node(), c, ContactStatus::slip).worn.secondary, 0.0);
  c.held_shear = -5.0;
  EXPECT_NEAR(conditions(node(), c, ContactStatus::stick).tangential, 2.0 + 3.0, 1e-14);
  auto n = node();
  n.share = 4.0;
  EXPECT_NEAR(conditions(n, c, ContactStatus::stick).tangential, 2.0 + 1.0, 1e-14);
  c.anchor = true;
  EXPECT_NEAR(conditions(n, c, ContactStatus::stick).tangential, 0.5, 1e-14);
}

}  // namespace
