#include "support/solid_turning.hpp"

using namespace reye;
using namespace reye::support;

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
    const auto d = difference(solved[3], solved[3 + k], turned_in_part(0.1 * k), 0.0);
    EXPECT_LT(d.traction, 1e-10) << k;
    EXPECT_LT(d.slip, 1e-12) << k;
    EXPECT_LE(solved[3 + k].errors[2], 1e-11) << k << ": the second step ends but for points that rest on the cone";
  }
}

TEST(SolidTurning, SlidingWhileTheSceneTurnsIsSlidingAtRest) {
  // A block that is pressed and slid along another one while both turn as one has, in each increment, the pressure,
  // shear and slip of the same sliding without the turn.
  expect_same_sliding(slid_blocks(false, {}), slid_blocks(true, {}));
}

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
