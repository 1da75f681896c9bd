#include <gtest/gtest.h>

#include "support/contacts.hpp"

namespace {

using namespace reye;
using base::Vec2;
using base::Vector;
using contact::ContactStatus;
using support::ContactCase;
using support::ContactOptions;
using support::FacingOptions;
using support::frictional;
using wear::LawKind;

/// Straight sides that touch, non-matching, turned by `angle`.
FacingOptions closed(double from, double to, double angle) {
  FacingOptions o;
  o.bend = o.gap = o.strain = 0.0;
  o.from = from;
  o.to = to;
  o.angle = angle;
  return o;
}

double largest_slip(const support::Interface& face) {
  double slip = 0.0;
  for (const auto& s : face.status()) EXPECT_NE(s, ContactStatus::slip);
  for (int j = 0; j < static_cast<int>(face.rows().size()); ++j)
    slip = std::max(slip, std::abs(face.condition(j).slip));
  return slip;
}

// A common rigid motion, rotations of 1 rad and more included, must give no slip at all, at any gap and curve.
TEST(slip, none_in_rigid_motion) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    FacingOptions o;
    o.seed = seed;
    o.gap = 0.0;
    o.from = seed % 2 == 0 ? 0.15 : -0.1;
    auto c = support::case_of(support::facing(o), frictional(0.5));
    support::turn(c, 0.9 * seed, {0.7, -0.3});
    support::press(c, 100.0, 0.0);
    EXPECT_LT(largest_slip(support::interface_of(c, 0)), 1e-12) << seed;
  }
}

// The drift form must be blind to rigid motion too, where the contact is closed.
TEST(slip, none_in_rigid_motion_of_newly_covered_nodes) {
  auto c = support::case_of(support::facing(closed(0.13, 0.78, 0.4)), frictional(0.5));
  for (auto& row : c.before.reference) row = {};
  support::turn(c, 1.3, {0.7, -0.3});
  support::press(c, 100.0, 0.0);
  EXPECT_LT(largest_slip(support::interface_of(c, 0)), 1e-12);
}

/// Slides the secondary side by 0.21 mm (more than half a facet), against the primary one, along the contact.
void slide(ContactCase& c, double angle) {
  for (Vec2& x : c.xs) x += 0.21 * support::turned(Vec2(-1, 0), angle);
}

// Every active node must report the true slip, also where nodes are newly covered or being uncovered.
TEST(slip, exact_where_coverage_changes) {
  for (double angle : {0.0, 0.5})
    for (const auto& [from, to] : {std::pair{-0.3, 1.3}, {0.13, 0.78}, {-0.2, 0.6}, {0.4, 1.2}}) {
      auto c = support::case_of(support::facing(closed(from, to, angle)), frictional(0.5));
      slide(c, angle);
      support::press(c, 100.0, 0.0);
      const auto face = support::interface_of(c, 0);
      for (int j = 0; j < static_cast<int>(c.xs.size()); ++j)
        if (face.active(j)) {
          EXPECT_NEAR(face.condition(j).slip / face.rows()[j].D, 0.21, 1e-12) << from << " node " << j;
        }
    }
}

// An accepted state must be the next increment's slip reference: no motion, no slip.
TEST(slip, next_increment_counts_its_own) {
  auto c = support::case_of(support::facing({}), frictional(0.5));
  c.setup.stiffness.assign(c.xs.size(), 10.0);
  slide(c, 0.0);
  support::press(c, 100.0, 0.0);
  const auto first = support::interface_of(c, 0);
  EXPECT_NEAR(first.condition(2).slip / first.rows()[2].D, 0.21, 0.02);
  c.before = first.accepted(c.lambda);
  c.xs0 = c.xs;
  c.xm0 = c.xm;
  EXPECT_LT(largest_slip(support::interface_of(c, 0)), 1e-15);
}

struct Balance {
  Vec2 force = Vec2::Zero();
  double moment = 0.0;
  double sum = 0.0;  ///< of all nodal forces
};

Balance balance(const ContactCase& c, const support::Interface& face) {
  const Vector f = face.forces(c.lambda);
  Balance b;
  for (int k = 0; k < f.size() / 2; ++k) {
    const int ns = static_cast<int>(c.xs.size());
    const Vec2 x = k < ns ? c.xs[k] : c.xm[k - ns], force = f.segment<2>(2 * k);
    b.force += force;
    b.moment += base::cross(x, force);
    b.sum += force.norm();
  }
  return b;
}

// Forces of both sides must cancel at any state, cut nodes included.
TEST(balance, forces_cancel) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    FacingOptions o;
    o.seed = seed;
    o.from = seed % 2 == 0 ? 0.15 : -0.1;
    auto c = support::random_case(o, frictional(0.3));
    c.setup.cut[1] = 1;
    const auto b = balance(c, support::interface_of(c, 0));
    EXPECT_GT(b.sum, 1.0);
    EXPECT_LT(b.force.norm(), 1e-12 * b.sum);
  }
}

// Moments must cancel where the contact is closed, with friction, partly covered, at any angle.
TEST(balance, moments_cancel_in_closed_contact) {
  for (double angle : {0.0, 0.5, 2.5})
    for (const auto& [from, to] : {std::pair{-0.3, 1.3}, {0.13, 0.78}}) {
      auto c = support::case_of(support::facing(closed(from, to, angle)), frictional(0.5));
      support::press(c, 100.0, 35.0);
      const auto b = balance(c, support::interface_of(c, 0));
      EXPECT_LT(std::abs(b.moment), 1e-12 * b.sum);
    }
}

double total(const std::vector<double>& v) {
  double sum = 0.0;
  for (double x : v) sum += x;
  return sum;
}

/// Volumes removed in one accepted increment against coefficient times work, on both sides.
void expect_volume_is_paid(const ContactCase& c) {
  const auto face = support::interface_of(c, 1);
  const auto after = face.accepted(c.lambda);
  const auto& law = c.setup.options.wear;
  double work = 0.0, frictional_work = 0.0;
  for (int j = 0; j < static_cast<int>(c.xs.size()); ++j) {
    const auto& node = face.condition(j);
    if (face.status()[j] != ContactStatus::slip) continue;
    work += c.increment.jump * std::abs((law.kind == LawKind::energy ? node.lambda_t : node.lambda_n) * node.slip);
    frictional_work += c.increment.jump * std::abs(node.lambda_t * node.slip);
  }
  ASSERT_GT(work, 0.0);
  const auto removed = [&](const auto& now, const auto& then) { return total(now) - total(then); };
  const double asked = (law.secondary + law.primary) * work;
  EXPECT_NEAR(after.law_volume, asked, 1e-14 * asked);
  EXPECT_NEAR(after.worn_work, frictional_work, 1e-14 * frictional_work);
  EXPECT_NEAR(after.frictional_work, frictional_work, 1e-14 * frictional_work);
  EXPECT_NEAR(total(after.removed_secondary), law.secondary * work, 1e-14 * law.secondary * work);
  EXPECT_NEAR(total(after.removed_primary), law.primary * work, 2e-14 * law.primary * work);
  EXPECT_NEAR(removed(after.pending_primary, c.before.pending_primary), law.primary * work, 1e-12 * law.primary * work);
}

// Removed volume must be coefficient times work to round-off: both laws, both sides, whole and cut facets, rings.
TEST(volume, is_coefficient_times_work) {
  for (unsigned seed = 1; seed <= 10; ++seed)
    for (LawKind kind : {LawKind::energy, LawKind::archard}) {
      FacingOptions o;
      o.seed = seed;
      o.angle = seed;
      o.from = seed % 2 == 0 ? 0.15 : -0.1;
      if (seed % 3 == 0) o.analysis = base::Analysis::axisymmetric;
      auto c = support::random_case(o, frictional(0.1, {kind, 1e-3, 2e-3}));
      if (seed % 4 == 0) c.setup.cut[1] = 1;
      expect_volume_is_paid(c);
    }
}

// Volume must be paid where a facet is covered by a sliver, less than a thousandth of it.
TEST(volume, is_paid_beside_a_sliver) {
  const double facet = 1.0 / 5.0;
  for (double from : {2.0 * facet - 5e-5, 0.1}) {
    auto o = closed(from, 1.0, 0.0);
    o.jitter = 0.0;
    auto c = support::case_of(support::facing(o), frictional(0.1, {LawKind::energy, 1e-3, 2e-3}));
    for (Vec2& x : c.xs) x.x() -= 1e-5;
    support::press(c, 100.0, 40.0);
    expect_volume_is_paid(c);
  }
}

// Without wear an increment must book its frictional work and remove nothing.
TEST(volume, nothing_is_removed_while_wear_is_off) {
  auto c = support::random_case({}, frictional(0.1, {LawKind::energy, 1e-3, 2e-3}));
  c.increment.wear = false;
  const auto after = support::interface_of(c, 1).accepted(c.lambda);
  EXPECT_GT(after.frictional_work, 0.0);
  EXPECT_EQ(after.worn_work, 0.0);
  EXPECT_EQ(total(after.removed_secondary) + total(after.removed_primary), 0.0);
}

// Each node must keep the frictional work it has seen, wear on or off, and add that of the next increment.
TEST(volume, energy_of_each_node) {
  auto c = support::random_case({}, frictional(0.1, {LawKind::archard, 1e-3, 2e-3}));
  c.before.energy_secondary.assign(c.xs.size(), 0.5);
  for (bool wear : {false, true}) {
    c.increment.wear = wear;
    const auto face = support::interface_of(c, 1);
    const auto after = face.accepted(c.lambda);
    EXPECT_GT(after.frictional_work, 0.0);
    for (int j = 0; j < static_cast<int>(c.xs.size()); ++j) {
      const double own = face.status()[j] == ContactStatus::slip
                             ? 3.0 * std::abs(face.condition(j).lambda_t * face.condition(j).slip)
                             : 0.0;
      EXPECT_NEAR(after.energy_secondary[j], 0.5 + own, 1e-15);
    }
  }
}

// With exponents and a threshold, too, removed volume must be coefficient times the law's work, which is not the plain
// one.
TEST(volume, is_coefficient_times_the_work_of_the_whole_law) {
  auto c = support::random_case({}, frictional(0.1, {LawKind::energy, 1e-3, 2e-3, 0.5, 30.0, -0.5, 1.0, 0.5}));
  c.increment.duration_s = 0.02;
  const auto after = support::interface_of(c, 1).accepted(c.lambda);
  EXPECT_GT(std::abs(after.law_volume / (3e-3 * after.frictional_work) - 1.0), 0.01);
  EXPECT_NEAR(total(after.removed_secondary) / after.law_volume * 3.0, 1.0, 1e-14);
  EXPECT_NEAR(total(after.removed_primary) / after.law_volume * 1.5, 1.0, 2e-14);
}

// An increment's own friction must stand in its conditions in place of the contact's, and in the accepted state.
TEST(conditions, friction_of_the_increment) {
  auto c = support::random_case({}, frictional(0.1));
  const auto at = [&] { return support::interface_of(c, 1); };
  EXPECT_EQ(at().accepted(c.lambda).friction, 0.1);
  const auto own = at();
  c.increment.friction = 0.05;
  const auto given = at();
  EXPECT_EQ(given.accepted(c.lambda).friction, 0.05);
  int found = 0;
  for (int j = 0; j < static_cast<int>(c.xs.size()); ++j) {
    if (own.status()[j] != ContactStatus::slip || given.status()[j] != ContactStatus::slip) continue;
    ++found;
    EXPECT_NEAR(std::abs(given.residual_tangential(j) - own.residual_tangential(j)), 0.05 * own.condition(j).lambda_n,
                1e-12);
  }
  EXPECT_GT(found, 0);
  c.increment.friction = 0.0;  // frictionless: slip whatever the motion
  const auto without = at();
  for (const auto& status : without.status()) EXPECT_NE(status, ContactStatus::stick);
}

/// The depth that stands in this increment's gap against the one that the accepted state holds.
void expect_counted_once(wear::Law law) {
  auto c = support::random_case({}, frictional(0.1, law));
  c.increment.duration_s = 0.02;
  const auto face = support::interface_of(c, 1);
  const auto after = face.accepted(c.lambda);
  support::Interface next;
  next.begin(c.setup, after, c.xs, c.xm, {});
  next.integrate(c.xs, c.xm);
  for (int j = 0; j < static_cast<int>(c.xs.size()); ++j) {
    if (!face.active(j)) continue;
    EXPECT_NEAR(face.residual_normal(j), next.gap()[j] + next.worn_gap(j), 1e-13);
  }
}

// The depth in the gap must be what the accepted state then holds: nothing is counted twice.
TEST(volume, gap_of_this_increment_becomes_the_pending_one) {
  expect_counted_once({LawKind::energy, 1e-4, 3e-4});
  expect_counted_once({LawKind::energy, 1e-4, 3e-4, 0.5, 30.0, -0.5, 1.0, 0.5});
}

/// Curved facets with one kind of multipliers.
struct Curved {
  FacingOptions facing;
  ContactOptions options;
};

/// Both kinds of multipliers, both measures, curved against curved and against straight.
std::vector<Curved> curved_cases(const FacingOptions& facing, const ContactOptions& options) {
  std::vector<Curved> cases;
  for (auto dual : {contact::DualOrder::quadratic, contact::DualOrder::linear})
    for (auto measure : {base::Kinematics::small, base::Kinematics::finite})
      for (int primary : {1, 2}) {
        Curved c{facing, options};
        c.facing.secondary_order = 2;
        c.facing.primary_order = primary;
        c.facing.measure = measure;
        c.options.dual = dual;
        cases.push_back(c);
      }
  return cases;
}

// Forces of curved sides must cancel at any state; so must moments where the contact is closed.
TEST(balance, of_curved_facets) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    FacingOptions o;
    o.seed = seed;
    o.from = seed % 2 == 0 ? 0.15 : -0.1;
    for (const auto& [facing, options] : curved_cases(o, frictional(0.3))) {
      auto c = support::random_case(facing, options);
      c.setup.cut[2] = 1;
      const auto b = balance(c, support::interface_of(c, 0));
      EXPECT_GT(b.sum, 1.0);
      EXPECT_LT(b.force.norm(), 1e-12 * b.sum);
    }
  }
  for (const auto& [from, to] : {std::pair{-0.3, 1.3}, {0.13, 0.78}})
    for (const auto& [facing, options] : curved_cases(closed(from, to, 0.5), frictional(0.5))) {
      auto c = support::case_of(support::facing(facing), options);
      support::press(c, 100.0, 35.0);
      const auto b = balance(c, support::interface_of(c, 0));
      EXPECT_LT(std::abs(b.moment), 1e-12 * b.sum) << from;
    }
}

// A common rigid motion of curved sides must give no slip at any gap, and a true slide the slip it is.
TEST(slip, of_curved_facets) {
  FacingOptions o;
  o.gap = 0.0;
  for (const auto& [facing, options] : curved_cases(o, frictional(0.5))) {
    auto c = support::case_of(support::facing(facing), options);
    support::turn(c, 0.9, {0.7, -0.3});
    support::press(c, 100.0, 0.0);
    EXPECT_LT(largest_slip(support::interface_of(c, 0)), 1e-12);
  }
  for (const auto& [facing, options] : curved_cases(closed(0.13, 0.78, 0.5), frictional(0.5))) {
    auto c = support::case_of(support::facing(facing), options);
    slide(c, 0.5);
    support::press(c, 100.0, 0.0);
    const auto face = support::interface_of(c, 0);
    for (int j = 0; j < static_cast<int>(c.xs.size()); ++j)
      if (face.active(j)) {
        EXPECT_NEAR(face.condition(j).slip / face.rows()[j].carried(), 0.21, 1e-11) << "node " << j;
      }
  }
}

// A stretch changes D over length on x, but not what is covered: the objective slip stays in use.
TEST(slip, stretch_is_no_change_of_coverage) {
  FacingOptions o = closed(-0.3, 1.3, 0.0);
  for (const auto& [facing, options] : curved_cases(o, frictional(0.5))) {
    auto c = support::case_of(support::facing(facing), options);
    for (auto* side : {&c.xs, &c.xm})
      for (Vec2& x : *side) x *= 1.2;
    support::press(c, 100.0, 0.0);
    const auto face = support::interface_of(c, 0);
    const double stretch = facing.measure == base::Kinematics::finite ? 1.2 : 1.0;
    for (int j = 0; j < static_cast<int>(c.xs.size()); ++j) {
      const auto &now = face.rows()[j], &then = c.before.reference[j];
      EXPECT_NEAR(now.covered, then.covered, 1e-13);
      EXPECT_NEAR(now.D, stretch * then.D, 1e-13);
      EXPECT_TRUE(face.touching(j) || c.setup.cut[j]);
    }
    EXPECT_LT(largest_slip(face), 1e-13);
  }
}

// Removed volume must be coefficient times work on curved facets, too, and what stands in the gap the next increment's.
TEST(volume, of_curved_facets) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    FacingOptions o;
    o.seed = seed;
    o.angle = seed;
    o.from = seed % 2 == 0 ? 0.15 : -0.1;
    for (const auto& [facing, options] : curved_cases(o, frictional(0.1, {LawKind::energy, 1e-4, 3e-4}))) {
      const auto c = support::random_case(facing, options);
      expect_volume_is_paid(c);
      const auto face = support::interface_of(c, 1);
      const auto after = face.accepted(c.lambda);
      support::Interface next;
      next.begin(c.setup, after, c.xs, c.xm, {});
      next.integrate(c.xs, c.xm);
      for (int j = 0; j < static_cast<int>(c.xs.size()); ++j)
        if (face.active(j)) {
          EXPECT_NEAR(face.residual_normal(j), next.gap()[j] + next.worn_gap(j), 1e-13);
        }
    }
  }
}

// Depth that is the same everywhere must open every node by its D and share, with either kind of multipliers; and a
// thickness factor scales what it opens.
TEST(volume, even_depth_opens_evenly) {
  for (const auto& [facing, options] :
       curved_cases(closed(-0.3, 1.3, 0.0), frictional(0.1, {LawKind::energy, 1.0, 1.0}))) {
    auto c = support::case_of(support::facing(facing), options);
    for (std::size_t j = 0; j < c.xs.size(); ++j) c.before.pending_secondary[j] = 0.01 * c.setup.secondary.area[j];
    for (std::size_t l = 0; l < c.xm.size(); ++l) c.before.pending_primary[l] = 0.02 * c.setup.primary.area[l];
    c.increment.thickness_secondary.assign(c.xs.size(), 2.0);
    c.increment.thickness_primary.assign(c.xm.size(), 0.5);
    const auto face = support::interface_of(c, 0);
    for (int j = 0; j < static_cast<int>(c.xs.size()); ++j)
      if (!c.setup.cut[j]) {
        EXPECT_NEAR(face.worn_gap(j), 0.03 * face.rows()[j].carried(), 1e-14);
      }
  }
}

}  // namespace
