#include <gtest/gtest.h>

#include <functional>

#include "support/contacts.hpp"

namespace {

using namespace reye;
using base::Vector;
using contact::ContactStatus;
using support::ContactCase;
using support::ContactOptions;
using support::FacingOptions;
using support::frictional;
using wear::LawKind;

/// Checks that rows and forces of the case agree with central differences, and that the error falls at rate 2.
void expect_rate_two(const ContactCase& c, int iteration, ContactStatus wanted, const std::string& what) {
  auto face = support::interface_of(c, iteration);
  int found = 0;
  for (auto status : face.status()) found += status == wanted;
  EXPECT_GT(found, 0) << what;
  const int columns = face.dofs() + 2 * static_cast<int>(c.xs.size());
  Vector direction = support::random_direction(columns, 3);
  direction.tail(2 * static_cast<int>(c.xs.size())) *= 1000.0;
  const Vector slope = support::slope_along(face, c, direction);
  const auto error = [&](double h) -> double {
    const Vector plus = support::equations(face, c, direction, h), minus = support::equations(face, c, direction, -h);
    return ((plus - minus) / (2 * h) - slope).norm();
  };
  EXPECT_LT(error(1e-5), 1e-5 * slope.norm()) << what;
  EXPECT_NEAR(std::log2(error(4e-4) / error(2e-4)), 2.0, 0.1) << what;
}

FacingOptions state(unsigned seed, bool partly) {
  FacingOptions o;
  o.seed = seed;
  o.secondary = 4;
  o.primary = 3 + static_cast<int>(seed % 4);
  o.angle = 0.8 * seed;
  if (partly) {
    o.from = 0.12;
    o.to = 0.83;
  }
  return o;
}

constexpr double alpha = 2e-4;  ///< so large that wear weighs as much as the gap

/// Checks the linearisation over seeds, whole and partly covered; `change` may alter the case.
void over_states(const ContactOptions& options, int iteration, ContactStatus wanted,
                 const std::function<void(ContactCase&)>& change = {},
                 base::Analysis analysis = base::Analysis::plane_strain) {
  for (unsigned seed = 1; seed <= 4; ++seed)
    for (bool partly : {false, true}) {
      auto o = state(seed, partly);
      o.analysis = analysis;
      auto c = support::random_case(o, options);
      if (change) change(c);
      expect_rate_two(c, iteration, wanted, "seed " + std::to_string(seed) + (partly ? ", partly covered" : ""));
    }
}

// Sticking nodes: rows and forces must be linearised exactly.
TEST(linearisation, stick) { over_states(frictional(0.4), 0, ContactStatus::stick); }

// Slipping and frictionless nodes without wear.
TEST(linearisation, slip) {
  over_states(frictional(0.1), 1, ContactStatus::slip);
  over_states(frictional(0.0), 1, ContactStatus::slip);
}

// Slip with wear on the secondary side, by either law.
TEST(linearisation, wear_on_the_secondary_side) {
  over_states(frictional(0.1, {LawKind::energy, alpha, 0.0}), 1, ContactStatus::slip);
  over_states(frictional(0.1, {LawKind::archard, alpha, 0.0}), 1, ContactStatus::slip);
}

// Wear on both sides: the primary's own field couples neighbours through T and M.
TEST(linearisation, wear_on_both_sides) {
  over_states(frictional(0.1, {LawKind::energy, alpha, 3.0 * alpha}), 1, ContactStatus::slip);
  over_states(frictional(0.1, {LawKind::archard, 0.0, 2.0 * alpha}), 1, ContactStatus::slip);
}

// The linearisation must be exact in axisymmetry and with explicit wear.
TEST(linearisation, ring_and_explicit_wear) {
  auto options = frictional(0.1, {LawKind::energy, alpha, 3.0 * alpha});
  over_states(options, 1, ContactStatus::slip, {}, base::Analysis::axisymmetric);
  options.implicit_wear = false;
  over_states(options, 1, ContactStatus::slip);
}

constexpr double m = 0.6, n = -0.4, p_ref = 80.0, v_ref = 2.0;

// Rates that depend on pressure and speed, on both sides, by either law, imposed sliding included.
TEST(linearisation, exponents) {
  const auto timed = [](ContactCase& c) { c.increment.duration_s = 0.02; };
  over_states(frictional(0.1, {LawKind::energy, alpha, 3.0 * alpha, m, p_ref, n, v_ref}), 1, ContactStatus::slip,
              timed);
  over_states(frictional(0.1, {LawKind::archard, alpha, 2.0 * alpha, n, p_ref, m, v_ref}), 1, ContactStatus::slip,
              timed);
  auto options = frictional(0.2, {LawKind::archard, alpha, alpha, m, p_ref, n, v_ref});
  options.imposed = true;
  over_states(options, 1, ContactStatus::slip, [](ContactCase& c) {
    c.increment.duration_s = 0.02;
    c.increment.imposed_slip = -0.05;
  });
}

// The increment in which every slipping node crosses the threshold of wear.
TEST(linearisation, threshold) {
  const auto crossing = [](ContactCase& c) {
    const auto face = support::interface_of(c, 1);
    constexpr double threshold = 5.0, beyond = 0.4;  // of this increment's energy
    for (std::size_t j = 0; j < c.lambda.size(); ++j) {
      const auto& at = face.condition(static_cast<int>(j));
      c.before.energy_secondary[j] =
          threshold * c.setup.secondary.area[j] - (1.0 - beyond) * c.increment.jump * std::abs(at.lambda_t * at.slip);
    }
    c.setup.options.wear.threshold = threshold;
  };
  over_states(frictional(0.1, {LawKind::energy, alpha, 3.0 * alpha}), 1, ContactStatus::slip, crossing);
}

// Sliding imposed as a number.
TEST(linearisation, imposed_sliding) {
  auto options = frictional(0.2, {LawKind::archard, alpha, alpha});
  options.imposed = true;
  over_states(options, 1, ContactStatus::slip, [](ContactCase& c) { c.increment.imposed_slip = -0.05; });
}

// Sliding out of the plane, as a length and as a turn about the axis, by either law.
TEST(linearisation, sliding_out_of_the_plane) {
  for (auto law : {LawKind::energy, LawKind::archard}) {
    auto options = frictional(0.2, {law, alpha, alpha});
    options.imposed = options.out_of_plane = true;
    const auto slides = [](ContactCase& c) {
      c.increment.imposed_slip = 0.05;
      c.increment.imposed_turn = 0.02;
    };
    over_states(options, 1, ContactStatus::slip, slides, base::Analysis::axisymmetric);
  }
}

// Nodes without multiplier: their neighbours' rows hold the share that acts on them.
TEST(linearisation, cut_nodes) {
  const auto cut = [](ContactCase& c) { c.setup.cut[0] = c.setup.cut[3] = 1; };
  over_states(frictional(0.1, {LawKind::energy, alpha, 3.0 * alpha}), 1, ContactStatus::slip, cut);
  over_states(frictional(0.4), 0, ContactStatus::stick, cut);
}

/// Shear partly beyond the friction bound, pressures as loaded.
void hold(ContactCase& c) {
  c.increment.held = true;
  for (std::size_t j = 0; j < c.lambda.size(); ++j) {
    c.increment.held_shear.push_back(j % 2 == 0 ? 8.0 : -45.0);
    c.increment.held_pressure.push_back(90.0 + 10.0 * static_cast<double>(j));
  }
}

// Shear held as a given load, below and beyond the friction bound.
TEST(linearisation, held_shear) {
  over_states(frictional(0.2, {LawKind::energy, alpha, alpha}), 1, ContactStatus::stick, hold);
}

// Held shear with an anchor: all rows depend on the anchor's multiplier and normal.
TEST(linearisation, held_shear_with_anchor) {
  over_states(frictional(0.2), 1, ContactStatus::stick, [](ContactCase& c) {
    hold(c);
    c.increment.anchor = 2;
  });
}

/// Checks the linearisation with curved facets, either kind of multipliers, and over length on X or on x.
void over_curved_states(ContactOptions options, int iteration, ContactStatus wanted,
                        const std::function<void(ContactCase&)>& change = {}) {
  for (auto dual : {contact::DualOrder::quadratic, contact::DualOrder::linear})
    for (auto measure : {base::Kinematics::small, base::Kinematics::finite})
      for (unsigned seed = 1; seed <= 2; ++seed)
        for (bool partly : {false, true}) {
          auto o = state(seed, partly);
          o.secondary_order = 2;
          o.primary_order = seed == 1 ? 2 : 1;
          o.measure = measure;
          options.dual = dual;
          auto c = support::random_case(o, options);
          if (change) change(c);
          expect_rate_two(c, iteration, wanted,
                          std::string(dual == contact::DualOrder::linear ? "linear" : "quadratic") +
                              (measure == base::Kinematics::finite ? ", on x" : ", on X") +
                              (partly ? ", partly covered, seed " : ", seed ") + std::to_string(seed));
        }
}

// Curved facets: sticking nodes, and slip with wear on both sides.
TEST(linearisation, curved_facets) {
  over_curved_states(frictional(0.4), 0, ContactStatus::stick);
  over_curved_states(frictional(0.1, {LawKind::energy, alpha, 3.0 * alpha}), 1, ContactStatus::slip);
}

// Wear of the secondary side alone: with linear multipliers it reaches the gap of neighbours through control points.
TEST(linearisation, curved_facets_with_wear_on_the_secondary_side) {
  over_curved_states(frictional(0.1, {LawKind::archard, 3.0 * alpha, 0.0}), 1, ContactStatus::slip);
}

// Straight facets over length on x, where D follows the stretch.
TEST(linearisation, length_on_x) {
  for (unsigned seed = 1; seed <= 4; ++seed)
    for (const auto& [friction, iteration, wanted] :
         {std::tuple{0.4, 0, ContactStatus::stick}, {0.1, 1, ContactStatus::slip}}) {
      auto o = state(seed, seed % 2 == 0);
      o.measure = base::Kinematics::finite;
      const auto c = support::random_case(o, frictional(friction, {LawKind::energy, alpha, 3.0 * alpha}));
      expect_rate_two(c, iteration, wanted, "seed " + std::to_string(seed));
    }
}

// Sliding imposed as a number on curved facets: it counts for the control points, too.
TEST(linearisation, imposed_sliding_of_curved_facets) {
  auto options = frictional(0.2, {LawKind::archard, alpha, alpha});
  options.imposed = true;
  over_curved_states(options, 1, ContactStatus::slip, [](ContactCase& c) { c.increment.imposed_slip = -0.05; });
}

/// Layers that stand in the gap with other than their thickness on X.
void thicken(ContactCase& c) {
  for (std::size_t j = 0; j < c.xs.size(); ++j)
    c.increment.thickness_secondary.push_back(0.5 + 0.1 * static_cast<double>(j));
  for (std::size_t l = 0; l < c.xm.size(); ++l)
    c.increment.thickness_primary.push_back(1.5 - 0.1 * static_cast<double>(l));
}

// The linearisation must be exact where depth on X and depth in the gap differ from node to node.
TEST(linearisation, thickness_of_layers) {
  over_states(frictional(0.1, {LawKind::energy, alpha, 3.0 * alpha}), 1, ContactStatus::slip, thicken);
  over_curved_states(frictional(0.1, {LawKind::energy, alpha, 3.0 * alpha}), 1, ContactStatus::slip, thicken);
}

}  // namespace
