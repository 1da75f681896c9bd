#include <gtest/gtest.h>

#include "support/contacts.hpp"

namespace {

using namespace reye;
using base::Vec2;
using contact::ContactStatus;
using support::ContactCase;
using support::FacingOptions;
using support::frictional;
using wear::LawKind;

/// Straight touching sides; the gap between them may be opened.
ContactCase flat(const support::ContactOptions& options, double gap = 0.0) {
  FacingOptions o;
  o.bend = o.strain = 0.0;
  o.gap = gap;
  return support::case_of(support::facing(o), options);
}

int count(const support::Interface& face, ContactStatus status) {
  int n = 0;
  for (auto s : face.status()) n += s == status;
  return n;
}

// Nodes that touch at zero gap must start active and stick; nodes apart must not.
TEST(decision, touching_nodes_start_in_stick) {
  auto closed = flat(frictional(0.3)), open = flat(frictional(0.3), 1e-3);
  EXPECT_EQ(count(support::interface_of(closed, 0), ContactStatus::stick), 6);
  EXPECT_EQ(count(support::interface_of(open, 0), ContactStatus::inactive), 6);
}

// A loaded node must stay active however much the wear of this very increment opens it, for every c0.
TEST(decision, own_wear_stays_out) {
  for (double c0 : {0.1, 1.0, 10.0})
    for (double slip : {1.0, 1e3, 1e6})
      for (int iteration : {1, 7}) {
        auto options = frictional(0.3);
        options.imposed = true;
        options.wear = {LawKind::archard, 1e-6, 0.0};
        options.c_normal = options.c_tangential = c0;
        auto c = flat(options);
        c.increment.imposed_slip = slip;
        support::press(c, 100.0, 30.0);
        auto face = support::interface_of(c, 0);
        face.decide(c.lambda, iteration);
        EXPECT_EQ(count(face, ContactStatus::slip), 6) << c0 << " " << slip;
      }
}

// The factors c must steer the first iterations only: from the sixth on what they would throw out or keep is decided by
// the natural scale, or an iteration under a large one never ends.
TEST(decision, factors_steer_the_first_iterations) {
  for (double c0 : {1e-6, 1.0, 1e6}) {
    auto options = frictional(0.3);
    options.c_normal = c0;
    auto c = flat(options, 1e-3);
    c.setup.stiffness.assign(c.xs.size(), 1e4);  // lambda - c E / h gap: 100 - 10 c
    support::press(c, 100.0, 0.0);
    c.before.status.assign(c.xs.size(), ContactStatus::stick);
    for (int iteration : {1, 7}) {
      auto face = support::interface_of(c, 0);
      face.decide(c.lambda, iteration);
      EXPECT_EQ(count(face, ContactStatus::inactive), c0 > 1.0 && iteration == 1 ? 6 : 0) << c0 << " " << iteration;
    }
  }
}

// Wear of earlier increments must open a node: it counts as gap.
TEST(decision, earlier_wear_opens) {
  auto c = flat(frictional(0.3));
  support::press(c, 10.0, 0.0);
  EXPECT_EQ(count(support::interface_of(c, 1), ContactStatus::inactive), 0);
  for (std::size_t j = 0; j < c.xs.size(); ++j) c.before.pending_secondary[j] = 0.02 * c.setup.secondary.area[j];
  EXPECT_EQ(count(support::interface_of(c, 1), ContactStatus::inactive), 6);
}

// Stick and slip must be decided by |lambda_t + c slip| against mu lambda_n, the direction by its sign.
TEST(decision, friction_bound) {
  for (double shear : {-31.0, -29.0, 29.0, 31.0}) {
    auto c = flat(frictional(0.3));
    support::press(c, 100.0, shear);
    const auto face = support::interface_of(c, 1);
    const bool slips = std::abs(shear) > 30.0;
    EXPECT_EQ(count(face, ContactStatus::slip), slips ? 6 : 0);
    if (slips) {
      EXPECT_NEAR(face.residual_tangential(2), shear - std::copysign(30.0, shear), 1e-12);
    }
  }
}

// A node that carries no multiplier, or is covered by less than a thousandth, must never be active.
TEST(decision, cut_and_uncovered_nodes_stay_out) {
  FacingOptions o;
  o.bend = o.strain = o.gap = o.jitter = 0.0;
  o.from = 0.5;
  auto c = support::case_of(support::facing(o), frictional(0.3));
  c.setup.cut[1] = 1;
  support::press(c, 100.0, 0.0);
  const auto face = support::interface_of(c, 1);
  EXPECT_TRUE(face.active(0));
  EXPECT_FALSE(face.active(1));
  EXPECT_TRUE(face.active(2));
  EXPECT_FALSE(face.active(4));
  EXPECT_FALSE(face.active(5));
}

// Imposed sliding must start in slip, in the direction of the number.
TEST(decision, imposed_sliding_starts_in_slip) {
  for (double sliding : {-2.0, 2.0}) {
    auto options = frictional(0.25);
    options.imposed = true;
    auto c = flat(options);
    c.increment.imposed_slip = sliding;
    support::press(c, 100.0, 0.0);
    const auto face = support::interface_of(c, 0);
    EXPECT_EQ(count(face, ContactStatus::slip), 6);
    EXPECT_NEAR(face.residual_tangential(0), -std::copysign(25.0, sliding), 1e-12);
  }
}

}  // namespace
