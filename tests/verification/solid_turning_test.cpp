#include <gtest/gtest.h>

#include <numbers>

#include "base/rotation.hpp"
#include "sim/problem/drive.hpp"
#include "sim/solid/solid_drive.hpp"
#include "sim/solid/solid_measure.hpp"
#include "support/solid_problem.hpp"

using namespace reye;
using base::Mat3;
using base::Points3;
using base::Vec3;
using support::fixed_motion;
using support::loaded;
using support::moved;

namespace {

constexpr double turning_E = 2.0e5;
const Vec3 skew = Vec3(0.3, -0.5, 0.81).normalized(), turn_centre(0.7, -0.4, 0.2);

body::SolidSupport rigid_face(const std::string& name, const std::string& face, std::array<body::Motion, 3> along,
                              std::array<body::Motion, 3> turn) {
  auto support = support::by_node(name, face, std::move(along));
  support.rigid = true;
  support.about = std::move(turn);
  return support;
}

/// A quarter turn about a skew axis, in the history "turn".
std::array<body::Motion, 3> quarter_turn() {
  std::array<body::Motion, 3> turn;
  for (int k = 0; k < 3; ++k) turn[k] = moved(0.5 * std::numbers::pi * skew[k], "turn");
  return turn;
}

sim::SolidProblem two_blocks(body::SolidInput lower, body::SolidInput upper, double friction) {
  auto problem = support::problem_of({std::move(lower), std::move(upper)}, {0, "z1"}, {1, "z0"}, friction, 0.2);
  problem.scene.histories["turn"] = {{0.0, 0.0}, {1.0, 1.0}};
  problem.scene.histories["press"] = {{0.0, 0.0}, {1.0, 1.0}};
  return problem;
}

body::SolidInput lower_block() {
  auto lower =
      support::solid("lower", support::block(mesh::SolidKind::hex8, {4, 4, 2}, Vec3(1, 1, 0.5)), turning_E, 0.3);
  lower.supports = {rigid_face("holder", "z0", {fixed_motion(), fixed_motion(), fixed_motion()}, quarter_turn())};
  lower.supports[0].centre_mm = turn_centre;
  return lower;
}

body::SolidInput upper_block() {
  return support::solid(
      "upper",
      support::block(mesh::SolidKind::hex8, {3, 3, 2}, Vec3::Ones(), support::box({0.2, 0.15, 0.5}, {0.85, 0.8, 1.0})),
      turning_E, 0.3);
}

/// Solutions of each increment to round-off, closer than a run needs: steps of equal increments, one history after the
/// other.
std::vector<solver::SolidSolution> solved_closely(const sim::SolidProblem& problem) {
  const auto assembly = sim::assemble(problem, sim::touchable_nodes(problem));
  auto state = solver::initial_state(assembly.system);
  std::map<std::string, double> factors;
  for (const auto& [name, corners] : problem.scene.histories) factors[name] = 0.0;
  std::vector<solver::SolidSolution> solutions;
  for (const auto& step : problem.scene.steps) {
    const auto held = factors;
    double from = 0.0;
    for (const double to : sim::solid_increment_ends(problem.scene, step)) {
      factors = sim::factors_at(problem.scene.histories, step, to, held);
      const auto target = sim::target_at(problem, assembly.system, state, factors, step, from, to);
      solutions.push_back(solve_increment(assembly.system, state, target, {.tolerance = 2e-12}));
      if (!solutions.back().converged) return solutions;
      state = solutions.back().state;
      from = to;
    }
  }
  return solutions;
}

/// The largest difference of two contacts, one of which is turned as a whole, over the largest pressure; of slip in mm.
struct TurnedDifference {
  double traction = 0.0, slip = 0.0;
};
TurnedDifference turned_difference(const solver::SolidSolution& straight, const solver::SolidSolution& turned,
                                   const Mat3& R, double slides = 1.0) {
  TurnedDifference d;
  double largest = 0.0;
  for (std::size_t j = 0; j < straight.nodes[0].size(); ++j) {
    const auto &own = straight.nodes[0][j], &other = turned.nodes[0][j];
    largest = std::max(largest, own.traction.norm());
    d.traction = std::max(d.traction, (R * own.traction - other.traction).norm());
    if (turned.state.status[0][j] != contact::SkinStatus::open)
      d.slip = std::max(d.slip, (slides * R * own.slip - other.slip).norm());
  }
  d.traction /= largest;
  return d;
}

Mat3 quarter_part(double share) { return base::turn_by(0.5 * std::numbers::pi * share * skew).toRotationMatrix(); }

}  // namespace

TEST(SolidTurning, AQuarterTurnOfALoadedSceneChangesNothing) {
  // A block that friction alone holds on another one, under pressures that follow it, is carried along by a quarter
  // turn about a skew axis: pressure and shear turn with it, and nothing slips.
  auto upper = upper_block();
  body::SolidLoad press, push;
  press.name = "press";
  press.face = "z1";
  press.pressure_MPa = 480.0;
  push.name = "push";
  push.face = "x0";
  push.pressure_MPa = 120.0;
  press.history = push.history = "press";
  upper.loads = {press, push};
  auto problem = two_blocks(lower_block(), upper, 0.5);
  problem.scene.steps = {support::step_of(4, {"press"}), support::step_of(10, {"turn"})};
  const auto solved = solved_closely(problem);
  ASSERT_EQ(solved.size(), 14u) << solved.back().reason;
  for (int k = 1; k <= 10; ++k) {
    const auto d = turned_difference(solved[3], solved[3 + k], quarter_part(0.1 * k), 0.0);
    EXPECT_LT(d.traction, 1e-10) << k;
    EXPECT_LT(d.slip, 1e-12) << k;
    EXPECT_LE(solved[3 + k].errors[2], 1e-11) << k << ": the second step ends but for points that rest on the cone";
  }
}

TEST(SolidTurning, SlidingWhileTheSceneTurnsIsSlidingAtRest) {
  // A block that is pressed and slid along another one while both turn as one has, in each increment, the pressure,
  // shear and slip of the same sliding without the turn.
  const double deep = 4e-4, way = 2e-3;
  const auto slide = [&](bool turns) {
    auto upper = upper_block();
    std::array<body::Motion, 3> along;
    for (int k = 0; k < 3; ++k) along[k] = moved(1.0, std::string("to_") + "xyz"[k]);
    upper.supports = {rigid_face("top", "z1", along, quarter_turn())};
    upper.supports[0].centre_mm = turn_centre;
    auto problem = two_blocks(lower_block(), upper, 0.4);
    for (int k = 0; k < 3; ++k) {
      auto& history = problem.scene.histories[std::string("to_") + "xyz"[k]];
      for (int i = 0; i <= 10; ++i) {
        const Vec3 own(i < 2 ? 0.0 : way * (i - 2) / 8.0, 0.5 * way * i / 10.0, -deep * std::min(1.0, 0.5 * i));
        history.push_back({0.1 * i, Vec3((turns ? quarter_part(0.1 * i) : Mat3(Mat3::Identity())) * own)[k]});
      }
    }
    if (!turns) problem.scene.histories["turn"] = {{0.0, 0.0}, {1.0, 0.0}};
    problem.scene.steps = {support::step_of(10, {"turn", "to_x", "to_y", "to_z"})};
    return solved_closely(problem);
  };
  const auto straight = slide(false), turned = slide(true);
  ASSERT_EQ(straight.size(), 10u) << straight.back().reason;
  ASSERT_EQ(turned.size(), 10u) << turned.back().reason;
  for (int k = 0; k < 10; ++k) {
    const auto d = turned_difference(straight[k], turned[k], quarter_part(0.1 * (k + 1)));
    EXPECT_LT(d.traction, 1e-10) << k;
    EXPECT_LT(d.slip, 1e-12) << k;
    EXPECT_LE(turned[k].iterations, straight[k].iterations + 1) << k;
    const double work = sim::dissipated(straight[k])[0];
    EXPECT_NEAR(sim::dissipated(turned[k])[0], work, 1e-10 * work + 1e-12) << k;
  }
}

namespace {

constexpr double pin_R = 5.0, bush_R = 5.02;

/// A ring or a part of one from its unit cube: angle from the first coordinate, radius from the third.
std::function<Vec3(const Vec3&)> ring_part(double from, double to, double inside, double outside, double length) {
  return [=](const Vec3& t) {
    const double angle = from + (to - from) * t.x(), r = inside + (outside - inside) * t.z();
    return Vec3(r * std::cos(angle), r * std::sin(angle), length * t.y());
  };
}

/// A rigid pin that turns in an elastic shell below it, pressed down by a force.
sim::SolidProblem pin_in_shell(double friction, int facets, int turns, int increments) {
  auto pin = support::solid("pin",
                            support::block(mesh::SolidKind::hex8, {facets, 1, 1}, Vec3::Ones(),
                                           ring_part(0.0, 2.0 * std::numbers::pi, 2.0, pin_R, 2.0)),
                            turning_E, 0.3);
  pin.rigid = true;
  auto guide = rigid_face("drive", "", {fixed_motion(), loaded(-400.0, "press"), fixed_motion()},
                          {fixed_motion(), fixed_motion(), moved(2.0 * std::numbers::pi * turns, "turn")});
  guide.body = "pin";
  guide.centre_mm = Vec3(0, 0, 1.0);
  pin.supports = {guide};
  const double half = 0.35;
  auto shell = support::solid("shell",
                              support::block(mesh::SolidKind::hex8, {10, 2, 3}, Vec3::Ones(),
                                             ring_part(-0.5 * std::numbers::pi - half, -0.5 * std::numbers::pi + half,
                                                       bush_R, bush_R + 2.0, 2.0)),
                              turning_E / 50.0, 0.3);
  shell.supports = {support::by_node("outside", "z1", {fixed_motion(), fixed_motion(), fixed_motion()})};
  auto problem = support::problem_of({shell, pin}, {0, "z0"}, {1, "z1"}, friction, 0.3);
  problem.scene.histories["press"] = problem.scene.histories["turn"] = {{0.0, 0.0}, {1.0, 1.0}};
  problem.scene.steps = {support::step_of(3, {"press"}), support::step_of(increments, {"turn"})};
  return problem;
}

}  // namespace

TEST(SolidTurning, APinThatTurnsTenTimesDissipatesTorqueTimesAngle) {
  // A rigid pin turned ten times in a shell: in each increment friction dissipates mu x radius x normal force x angle
  // and torque times angle, within the square of a facet's angle, and forces after ten turns are those after one.
  constexpr int facets = 48, turns = 10, per_turn = 24;
  const double mu = 0.3, angle = 2.0 * std::numbers::pi / per_turn, facet = 2.0 * std::numbers::pi / facets;
  const auto played = support::play(pin_in_shell(mu, facets, turns, turns * per_turn));
  ASSERT_EQ(played.summary.status, sim::RunStatus::done) << played.summary.reason;
  ASSERT_EQ(played.rows.size(), 3u + turns * per_turn);
  double iterations = 0.0;
  for (std::size_t k = 4; k < played.rows.size(); ++k) {
    const auto &row = played.rows[k], &before = played.rows[k - 1];
    const double work = row.contacts[0].energy_mJ - before.contacts[0].energy_mJ;
    const double torque = row.supports[1].moment_N_mm.z();
    EXPECT_NEAR(work, mu * pin_R * row.contacts[0].normal_force_N * angle, facet * facet * work) << k;
    EXPECT_NEAR(work, torque * angle, facet * facet * work) << k;
    iterations += row.newton / (turns * per_turn - 1.0);
  }
  const auto &first = played.rows[3 + per_turn - 1], &last = played.rows.back();
  EXPECT_LT((first.contacts[0].force_N - last.contacts[0].force_N).norm(), 1e-8 * 400.0);
  EXPECT_LT(std::abs(first.supports[1].moment_N_mm.z() - last.supports[1].moment_N_mm.z()),
            1e-8 * last.supports[1].moment_N_mm.norm());
  EXPECT_LE(iterations, 7.5);
  EXPECT_LE(played.summary.balance, 1e-9);
  EXPECT_TRUE(std::none_of(played.summary.warnings.begin(), played.summary.warnings.end(),
                           [](const auto& w) { return w.kind == "turn"; }));
}

TEST(SolidTurning, MoreThanAThirdOfARadianIsDivided) {
  // One increment of the scene that turns the pin by half a turn is played in parts of at most 0.3 rad.
  auto problem = pin_in_shell(0.1, 24, 1, 1);
  problem.scene.histories["turn"] = {{0.0, 0.0}, {1.0, 0.5}};
  const auto played = support::play(problem);
  ASSERT_EQ(played.summary.status, sim::RunStatus::done) << played.summary.reason;
  EXPECT_EQ(played.rows.size(), 3u + 11u);
}

namespace {

constexpr double ball_R = 5.0;

/// A rigid ball, free to turn, on an elastic flat; its centre is led by one radius.
sim::SolidProblem rolling_ball() {
  const auto globe = [](const Vec3& t) {
    const double longitude = -0.4 + 1.8 * t.x(), latitude = -0.35 + 0.7 * t.y(), r = ball_R - 1.0 * t.z();
    return Vec3(r * std::sin(longitude) * std::cos(latitude), r * std::sin(latitude),
                ball_R - r * std::cos(longitude) * std::cos(latitude));
  };
  auto ball = support::solid("ball", support::block(mesh::SolidKind::hex8, {36, 14, 1}, Vec3::Ones(), globe), 1.0, 0.3);
  ball.rigid = true;
  auto guide = rigid_face("lead", "", {moved(ball_R, "roll"), fixed_motion(), loaded(-150.0, "press")}, {});
  guide.body = "ball";
  guide.centre_mm = Vec3(0, 0, ball_R);
  ball.supports = {guide};
  auto flat = support::solid("flat",
                             support::block(mesh::SolidKind::hex8, {26, 8, 3}, Vec3::Ones(),
                                            support::box({-1.5, -1.6, -2.0}, {6.5, 1.6, 0.0})),
                             2000.0, 0.3);
  flat.supports = {support::by_node("bottom", "z0", {fixed_motion(), fixed_motion(), fixed_motion()})};
  auto problem = support::problem_of({flat, ball}, {0, "z1"}, {1, "z0"}, 0.5, 0.5);
  problem.scene.histories["press"] = problem.scene.histories["roll"] = {{0.0, 0.0}, {1.0, 1.0}};
  problem.scene.steps = {support::step_of(4, {"press"}), support::step_of(20, {"roll"})};
  problem.scene.frames.paraview = true;
  return problem;
}

}  // namespace

TEST(SolidTurning, ABallThatFrictionRollsTravelsItsRadiusTimesItsAngle) {
  // A ball whose centre is led by one radius rolls by one radian about the axis across, but for the creep of the
  // elastic flat, and about no other axis; nearly nothing is dissipated.
  const auto played = support::play(rolling_ball());
  ASSERT_EQ(played.summary.status, sim::RunStatus::done) << played.summary.reason;
  const auto& ball = played.frames.back().bodies[1];
  const auto place = [&](int node) { return Vec3(ball.mesh->X[node] + ball.u[node]); };
  const int last = ball.mesh->node_count() - 1;
  const Vec3 before = ball.mesh->X[last] - ball.mesh->X[0], after = place(last) - place(0);
  EXPECT_NEAR(after.norm(), before.norm(), 1e-12) << "a rigid body keeps its lengths";
  const double angle = std::atan2(before.z(), before.x()) - std::atan2(after.z(), after.x());
  EXPECT_NEAR(angle, 1.0, 0.02);
  EXPECT_NEAR(after.y(), before.y(), 1e-3);
  double iterations = 0.0, most = 0.0;
  for (std::size_t k = 4; k < played.rows.size(); ++k) {
    iterations += played.rows[k].newton / 20.0;
    most = std::max(most, played.rows[k].contacts[0].tangential_force_N);
  }
  EXPECT_LE(iterations, 8.0);
  EXPECT_LE(most, 0.02 * 150.0) << "what rolls freely is not pushed";
  EXPECT_LE(played.summary.contacts[0].dissipated_energy_mJ, 0.02 * 0.5 * 150.0 * ball_R);
  EXPECT_LE(played.summary.balance, 1e-9);
}
