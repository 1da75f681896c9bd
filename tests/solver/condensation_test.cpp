#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "solver/blocks.hpp"
#include "solver/uncondensed.hpp"

namespace {

using namespace reye;
using support::Assembly;
using support::BlocksOptions;
using wear::LawKind;

/// Largest difference of displacements, and of multipliers, each over the largest value.
void expect_same(const solver::SolverState& state, const support::Uncondensed& oracle, const std::string& what) {
  EXPECT_LT((state.q.high - oracle.q).lpNorm<Eigen::Infinity>(), 1e-10 * oracle.q.lpNorm<Eigen::Infinity>()) << what;
  double largest = 0.0, difference = 0.0;
  for (std::size_t c = 0; c < oracle.lambda.size(); ++c)
    for (std::size_t j = 0; j < oracle.lambda[c].size(); ++j) {
      largest = std::max(largest, oracle.lambda[c][j].norm());
      difference = std::max(difference, (state.contacts[c].lambda[j] - oracle.lambda[c][j]).norm());
    }
  EXPECT_GT(largest, 1.0) << what;
  EXPECT_LT(difference, 1e-10 * largest) << what;
}

/// Plays increments up to the given factors; after each the state must be that of as many uncondensed steps.
/// Tolerances: `loose` stops as soon as the active set is settled, after steps that are not yet converged.
void expect_condensed_is_exact(const Assembly& a, bool loose, const std::string& what) {
  const auto system = support::system_of(a);
  solver::NewtonOptions options;
  if (loose) options.force_tolerance = options.condition_tolerance = 1e300;
  solver::Newton newton(options);
  auto state = support::fresh(system);
  for (double factor : {1.0, 1.4, 0.8}) {
    const auto controls = support::controls_of(a, system, factor);
    support::Uncondensed oracle(system, state, controls);
    const auto result = newton.solve(system, state, controls);
    ASSERT_TRUE(result.report.converged) << what << ": " << result.report.reason;
    for (int i = 0; i < result.report.solves; ++i) oracle.step(i);
    oracle.decide(result.report.solves);
    expect_same(result.state, oracle, what + ", factor " + std::to_string(factor));
    state = result.state;
  }
}

void expect_exact_both_ways(const Assembly& a, const std::string& what) {
  expect_condensed_is_exact(a, false, what);
  expect_condensed_is_exact(a, true, what + ", not converged");
}

// Eliminating the multipliers must change nothing: friction, stick and slip, on turned curved blocks.
TEST(condensation, friction) {
  for (bool swapped : {false, true}) {
    BlocksOptions o{.friction = 0.3, .drag = 0.01, .angle = 0.4};
    o.upper_secondary = swapped;
    expect_exact_both_ways(support::blocks(o), swapped ? "swapped" : "friction");
  }
}

// Condensation must be exact with wear on both sides in the equations.
TEST(condensation, wear_on_both_sides) {
  BlocksOptions o{.friction = 0.3, .wear = {LawKind::energy, 4e-4, 7e-4}, .drag = 0.06, .angle = 0.4};
  expect_exact_both_ways(support::blocks(o), "wear");
}

// Condensation must be exact with cells of second order and either kind of multipliers: linear ones load control points
// they do not own.
TEST(condensation, second_order) {
  for (auto dual : {contact::DualOrder::quadratic, contact::DualOrder::linear})
    for (auto upper : {mesh::CellKind::tri6, mesh::CellKind::quad4}) {
      BlocksOptions o{.friction = 0.3, .wear = {LawKind::energy, 4e-4, 7e-4}, .drag = 0.06, .angle = 0.4};
      o.lower = mesh::CellKind::quad8;
      o.upper = upper;
      o.dual = dual;
      expect_exact_both_ways(support::blocks(o), dual == contact::DualOrder::linear ? "linear" : "quadratic");
    }
}

// Condensation must be exact against a rigid body that is pushed, dragged and turned.
TEST(condensation, rigid_primary) {
  BlocksOptions o{.friction = 0.2, .wear = {LawKind::energy, 4e-4, 0.0}, .drag = 0.02, .angle = -0.3};
  o.upper_rigid = true;
  o.rotation = 0.01;
  expect_exact_both_ways(support::blocks(o), "rigid");
}

/// The left edge of the lower block held: clamped, its top node carries no multiplier; guided, a normal one.
Assembly held_at_the_left(bool clamped) {
  BlocksOptions o{.friction = 0.3, .wear = {LawKind::energy, 4e-4, 7e-4}, .drag = 0.02};
  o.crown = 0.0;
  auto a = support::blocks(o);
  a.meshes[1] = support::rectangle({.corner = {-0.2, 1}, .size = {1.7, 1}, .nx = 7, .ny = 3});
  a.inputs[0].supports.push_back(clamped ? support::fixed_edge("wall", "left") : support::guide("wall", "left", 'x'));
  return a;
}

// Condensation must be exact beside a node that carries no multiplier, and with one that keeps only its normal part.
TEST(condensation, supported_secondary_nodes) {
  for (bool clamped : {true, false}) {
    const auto a = held_at_the_left(clamped);
    const auto system = support::system_of(a);
    int cut = 0, guided = 0;
    for (int j = 0; j < system.contacts[0].secondary_count(); ++j) {
      cut += system.contacts[0].cut[j];
      guided += system.contacts[0].freedom[j].free == 1 && !system.contacts[0].cut[j];
    }
    EXPECT_EQ(cut, clamped ? 1 : 0);
    EXPECT_EQ(guided, clamped ? 0 : 1);
    expect_exact_both_ways(a, clamped ? "clamped" : "guided");
  }
}

// Condensation must be exact for chained contacts: one contact's multipliers load rows that the next one eliminates.
TEST(condensation, chained_contacts) {
  for (double friction : {0.0, 0.3}) expect_exact_both_ways(support::chain(friction), "chain");
}

// Contact nodes out of reach must be condensed out without a trace: a result equal to that with all of them.
TEST(condensation, reach_changes_nothing) {
  BlocksOptions o{.friction = 0.3, .wear = {LawKind::energy, 4e-4, 7e-4}, .press = 0.004, .drag = 0.006};
  const auto a = support::blocks(o);
  const auto system = support::system_of(a);
  solver::NewtonOptions all;
  all.limit_reach = false;
  solver::Newton limited, whole(all);
  auto state = support::fresh(system), other = state;
  for (double factor : {0.5, 1.0, -0.5}) {
    auto controls = support::controls_of(a, system, factor);
    controls.prescribed = support::controls_of(a, system, std::abs(factor)).prescribed;
    const auto one = limited.solve(system, state, controls), two = whole.solve(system, other, controls);
    ASSERT_TRUE(one.report.converged && two.report.converged);
    state = one.state;
    other = two.state;
    EXPECT_LT((state.q.high - other.q.high).lpNorm<Eigen::Infinity>(), 1e-9 * other.q.high.lpNorm<Eigen::Infinity>());
    for (std::size_t j = 0; j < other.contacts[0].lambda.size(); ++j)
      EXPECT_LT((state.contacts[0].lambda[j] - other.contacts[0].lambda[j]).norm(), 1e-7);
  }
}

/// A wide block, its bottom secondary with facets of 0.05, pressed on a crown and dragged along it by `drag`.
Assembly wide_slider(double drag, const body::BodyInput& slider = support::elastic(2000.0, 0.25)) {
  Assembly a;
  a.meshes = {support::mapped(support::rectangle({.corner = {1, 0}, .size = {2, 1}, .nx = 30, .ny = 5}),
                              [](const base::Vec2& x) {
                                return base::Vec2(x.x(), x.y() * (1.0 - 0.005 * (x.x() - 2.0) * (x.x() - 2.0)));
                              }),
              support::rectangle({.corner = {0, 1}, .size = {4, 1}, .nx = 80, .ny = 5})};
  a.inputs = {support::elastic(1000.0, 0.3), slider};
  a.inputs[0].supports = {support::fixed_edge("base", "bottom")};
  a.inputs[1].supports = {support::fixed_edge("holder", "top")};
  a.inputs[1].supports[0].x = support::moved(drag);
  a.inputs[1].supports[0].y = support::moved(-0.0003);
  contact::ContactOptions c;
  c.friction = 0.5;
  support::touch(a, c, {1, "bottom"}, {0, "top"});
  return a;
}

// Contact that grows in one increment up to the nodes out of reach must carry the tractions that it carries among all
// nodes, wherever it ends: the normals beside its last node depend on one node more.
TEST(condensation, contact_that_grows_to_its_reach) {
  const auto a = wide_slider(0.0);
  const auto system = support::system_of(a);
  const auto pressed = [&](double depth) {
    auto deeper = a;
    deeper.inputs[1].supports[0].y = support::moved(-depth);
    return support::controls_of(deeper, system, 1.0);
  };
  solver::NewtonOptions all;
  all.limit_reach = false;
  for (int k = 0; k <= 40; ++k) {
    const double depth = 2e-4 + 2e-5 * k;
    solver::Newton limited, whole(all);
    auto state = support::fresh(system), other = state;
    for (double now : {1e-4, 1.01e-4, depth}) {  // from the second one on the reach is limited
      const auto one = limited.solve(system, state, pressed(now)), two = whole.solve(system, other, pressed(now));
      ASSERT_TRUE(one.report.converged && two.report.converged) << depth;
      state = one.state;
      other = two.state;
    }
    double largest = 0.0, apart = 0.0;
    for (std::size_t j = 0; j < other.contacts[0].lambda.size(); ++j) {
      largest = std::max(largest, other.contacts[0].lambda[j].norm());
      apart = std::max(apart, (state.contacts[0].lambda[j] - other.contacts[0].lambda[j]).norm());
    }
    EXPECT_LT(apart, 1e-9 * largest) << depth;
  }
}

/// The steps that Newton takes with nodes in reach, and with all of them.
struct Steps {
  int limited, whole;
};

/// Drags the slider so far, one increment after another, with nodes in reach and with all of them, to the same states.
/// `continues`: of each increment.
void expect_same_slide(const std::vector<double>& drags, auto continues, auto compare,
                       const body::BodyInput& slider = support::elastic(2000.0, 0.25), bool chords = true) {
  const auto system = support::system_of(wide_slider(0.0, slider));
  solver::NewtonOptions some, all;
  some.chords = all.chords = chords;
  all.limit_reach = false;
  solver::Newton limited(some), whole(all);
  auto state = support::fresh(system), other = state;
  for (std::size_t k = 0; k < drags.size(); ++k) {
    SCOPED_TRACE("drag " + std::to_string(drags[k]));
    auto controls = support::controls_of(wide_slider(drags[k], slider), system, 1.0);
    controls.continues = continues(k);
    const auto one = limited.solve(system, state, controls), two = whole.solve(system, other, controls);
    ASSERT_TRUE(one.report.converged) << one.report.reason;
    ASSERT_TRUE(two.report.converged) << two.report.reason;
    compare(k, Steps{one.report.solves, two.report.solves});
    state = one.state;
    other = two.state;
    EXPECT_LT((state.q.high - other.q.high).lpNorm<Eigen::Infinity>(), 1e-9 * other.q.high.lpNorm<Eigen::Infinity>());
  }
}

// A slide of more than a facet in one increment must converge, in as many steps and to the same state as with all nodes
// in reach.
TEST(condensation, slides_past_the_rim_of_the_reach) {
  expect_same_slide(
      {0.0, 0.07, 0.14, 0.21}, [](std::size_t) { return 0.0; },
      [](std::size_t, const Steps& steps) { EXPECT_LE(steps.limited, steps.whole + 1); });
}

// Where increments continue one another, the reach must follow the contact before Newton begins: no more steps than
// with all nodes in reach, by exact matrices, and one more in compliance form, to the same state, also once an inverse
// of the body serves all reaches.
TEST(condensation, reach_goes_ahead_of_a_long_slide) {
  std::vector<double> drags;
  for (int k = 0; k <= 12; ++k) drags.push_back(0.07 * k);
  for (const bool chords : {false, true})
    expect_same_slide(
        drags, [](std::size_t k) { return k > 1 ? 1.0 : 0.0; },
        [&](std::size_t k, const Steps& steps) {
          if (k > 1) {
            EXPECT_LE(steps.limited, steps.whole + chords);
          }
        },
        support::elastic(2000.0, 0.25), chords);
}

// A reach chosen with the nodes that are expected to touch must hold them with its margin, as well as the contact, and
// lead to the states of all nodes.
TEST(condensation, reach_holds_what_lies_ahead) {
  const auto system = support::system_of(wide_slider(0.0));
  solver::NewtonOptions all;
  all.limit_reach = false;
  solver::Newton limited, whole(all);
  auto state = support::fresh(system), other = state;
  std::vector<std::vector<char>> ahead;
  for (double drag : {0.0, 0.07, 0.14, 0.0}) {
    auto controls = support::controls_of(wide_slider(drag), system, 1.0);
    const auto two = whole.solve(system, other, controls);
    controls.ahead = ahead;
    limited.reset();
    const auto one = limited.solve(system, state, controls);
    ASSERT_TRUE(one.report.converged && two.report.converged);
    state = one.state;
    other = two.state;
    EXPECT_LT((state.q.high - other.q.high).lpNorm<Eigen::Infinity>(), 1e-9 * other.q.high.lpNorm<Eigen::Infinity>());
    ahead.resize(1);
    ahead[0].resize(state.contacts[0].status.size(), 0);
    for (std::size_t j = 0; j < ahead[0].size(); ++j)
      if (state.contacts[0].status[j] != contact::ContactStatus::inactive) ahead[0][j] = 1;
  }
  const solver::Reach::Margin margin{.nodes = 2, .active_per_node = 0};
  const auto now = solver::Reach::round_contact(system, state.contacts, margin);
  const auto with = solver::Reach::round_contact(system, state.contacts, margin, ahead);
  EXPECT_GT(with.nodes(), now.nodes());
  EXPECT_TRUE(with.holds(now));
  const auto& facets = system.contacts[0].secondary.facets;
  for (const auto& [a, b, c] : facets)
    if (ahead[0][a] || ahead[0][b]) {
      EXPECT_TRUE(with.secondary[0][a] && with.secondary[0][b]);
    }
}

// Columns of a nonlinear body that contact does not need are condensed out of its tangent, and contact that outruns its
// reach continues from the state that was found: both must change nothing, whether that tangent is symmetric or not.
TEST(condensation, nonlinear_body_slides_past_the_rim_of_the_reach) {
  const material::HenckyJ2 soft{2000.0, 0.25, material::LinearHardening{4.0, 20.0}};
  for (const auto kinematics : {base::Kinematics::small, base::Kinematics::finite})
    for (const double continues : {0.0, 1.0})
      for (const bool chords : {true, false})
        expect_same_slide(
            {0.0, 0.07, 0.5, 0.6, 1.2}, [&](std::size_t k) { return k > 1 ? continues : 0.0; },
            [](std::size_t, const Steps&) {}, support::made_of(soft, kinematics), chords);
}

/// Largest force of a support on one of the bodies, and the sum over all of them.
std::pair<double, base::Vec2> carried(const solver::System& system, const base::Vector& reactions) {
  double largest = 0.0;
  base::Vec2 sum = base::Vec2::Zero();
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    base::Vec2 own = base::Vec2::Zero();
    for (const auto& s : std::visit([](const auto& o) { return o.support_columns(); }, system.bodies[b]))
      own += reactions[system.offset[b] + s.column] * s.direction;
    largest = std::max(largest, own.norm());
    sum += own;
  }
  return {largest, sum};
}

// A body 10^6 times as stiff as what it slides on must be in balance however far it has moved, with nodes out of reach
// or not.
TEST(condensation, stiff_body_balances_far_from_its_start) {
  for (bool limited : {true, false}) {
    auto a = wide_slider(0.0);
    a.inputs[1].material = material::LinearElastic{1e9, 0.25};
    const auto system = support::system_of(a);
    solver::NewtonOptions options;
    options.limit_reach = limited;
    solver::Newton newton(options);
    auto state = support::fresh(system);
    for (double drag : {0.0, 0.02}) {
      a.inputs[1].supports[0].x = support::moved(drag);
      const auto controls = support::controls_of(a, system, 1.0);
      const auto result = newton.solve(system, state, controls);
      ASSERT_TRUE(result.report.converged) << "drag " << drag << ": " << result.report.reason;
      state = result.state;
      const auto [largest, sum] = carried(system, solver::reactions(system, state, controls));
      EXPECT_GT(largest, 0.01);
      EXPECT_LT(sum.norm(), 1e-10 * largest) << "drag " << drag;
    }
  }
}

}  // namespace
