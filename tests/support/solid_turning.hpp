#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "base/rotation.hpp"
#include "sim/problem/drive.hpp"
#include "sim/solid/solid_drive.hpp"
#include "sim/solid/solid_increments.hpp"
#include "support/solid_problem.hpp"

/// Scenes of solids that turn, for their tests.
namespace reye::support {

inline constexpr double turning_E = 2.0e5;
inline const Vec3 skew = Vec3(0.3, -0.5, 0.81).normalized(), about(0.7, -0.4, 0.2);

inline body::SolidSupport rigid_face(const std::string& name, const std::string& face,
                                     std::array<body::Motion, 3> along, std::array<body::Motion, 3> turn) {
  auto support = support::by_node(name, face, std::move(along));
  support.rigid = true;
  support.about = std::move(turn);
  return support;
}

/// A quarter turn about a skew axis, in the history "turn".
inline std::array<body::Motion, 3> quarter_turn() {
  std::array<body::Motion, 3> turn;
  for (int k = 0; k < 3; ++k) turn[k] = moved(0.5 * std::numbers::pi * skew[k], "turn");
  return turn;
}

inline sim::SolidProblem two_blocks(body::SolidInput lower, body::SolidInput upper, double friction) {
  auto problem = support::problem_of({std::move(lower), std::move(upper)}, {0, "z1"}, {1, "z0"}, friction, 0.2);
  problem.scene.histories["turn"] = {{0.0, 0.0}, {1.0, 1.0}};
  problem.scene.histories["press"] = {{0.0, 0.0}, {1.0, 1.0}};
  return problem;
}

inline body::SolidInput lower_block() {
  auto lower =
      support::solid("lower", support::block(mesh::SolidKind::hex8, {4, 4, 2}, Vec3(1, 1, 0.5)), turning_E, 0.3);
  lower.supports = {rigid_face("holder", "z0", {fixed_motion(), fixed_motion(), fixed_motion()}, quarter_turn())};
  lower.supports[0].centre_mm = about;
  return lower;
}

inline body::SolidInput upper_block() {
  return support::solid(
      "upper",
      support::block(mesh::SolidKind::hex8, {3, 3, 2}, Vec3::Ones(), support::box({0.2, 0.15, 0.5}, {0.85, 0.8, 1.0})),
      turning_E, 0.3);
}

/// Solutions of each increment to round-off, closer than a run needs: steps of equal increments, one history after the
/// other.
inline std::vector<solver::SolidSolution> solved_closely(const sim::SolidProblem& problem) {
  const auto meshes = sim::drawn_meshes(problem);
  const auto assembly = sim::assemble(problem, meshes, sim::touchable_nodes(problem, meshes));
  auto state = solver::initial_state(assembly.system);
  std::map<std::string, double> factors;
  for (const auto& [name, corners] : problem.scene.histories) factors[name] = 0.0;
  std::vector<solver::SolidSolution> solutions;
  for (const auto& step : problem.scene.steps) {
    const auto held = factors;
    double from = 0.0;
    for (const double to : sim::solid_increment_ends(problem.scene, step)) {
      factors = sim::factors_at(problem.scene.histories, step, to, held);
      const auto target = sim::target_at(problem, assembly.system, state, factors, step, {}, from, to);
      solutions.push_back(solver::solve_increment(assembly.system, state, target, {.tolerance = 2e-12}));
      if (!solutions.back().converged) return solutions;
      state = solutions.back().state;
      from = to;
    }
  }
  return solutions;
}

/// The largest difference of two contacts, one of which is turned as a whole, over the largest pressure; of slip in mm.
struct Difference {
  double traction = 0.0, slip = 0.0;
};
inline Difference difference(const solver::SolidSolution& straight, const solver::SolidSolution& turned, const Mat3& R,
                             double slides = 1.0) {
  Difference d;
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

inline Mat3 turned_in_part(double share) {
  return base::turn_by(0.5 * std::numbers::pi * share * skew).toRotationMatrix();
}

/// A block that is pressed and slid along another one, while both turn as one or at rest.
inline std::vector<solver::SolidSolution> slid_blocks(bool turns, const wear::Law& law) {
  const double deep = 4e-4, way = 2e-3;
  auto upper = upper_block();
  std::array<body::Motion, 3> along;
  for (int k = 0; k < 3; ++k) along[k] = moved(1.0, std::string("to_") + "xyz"[k]);
  upper.supports = {rigid_face("top", "z1", along, quarter_turn())};
  upper.supports[0].centre_mm = about;
  auto problem = two_blocks(lower_block(), upper, 0.4);
  problem.contacts[0].options.wear = law;
  for (int k = 0; k < 3; ++k) {
    auto& history = problem.scene.histories[std::string("to_") + "xyz"[k]];
    for (int i = 0; i <= 10; ++i) {
      const Vec3 own(i < 2 ? 0.0 : way * (i - 2) / 8.0, 0.5 * way * i / 10.0, -deep * std::min(1.0, 0.5 * i));
      history.push_back({0.1 * i, Vec3((turns ? turned_in_part(0.1 * i) : Mat3(Mat3::Identity())) * own)[k]});
    }
  }
  if (!turns) problem.scene.histories["turn"] = {{0.0, 0.0}, {1.0, 0.0}};
  problem.scene.steps = {support::step_of(10, {"turn", "to_x", "to_y", "to_z"})};
  problem.scene.steps[0].wear = law.wears();
  return solved_closely(problem);
}

inline void expect_same_sliding(const std::vector<solver::SolidSolution>& straight,
                                const std::vector<solver::SolidSolution>& turned) {
  ASSERT_EQ(straight.size(), 10u) << straight.back().reason;
  ASSERT_EQ(turned.size(), 10u) << turned.back().reason;
  for (int k = 0; k < 10; ++k) {
    const auto d = difference(straight[k], turned[k], turned_in_part(0.1 * (k + 1)));
    EXPECT_LT(d.traction, 1e-10) << k;
    EXPECT_LT(d.slip, 1e-12) << k;
    EXPECT_LE(turned[k].iterations, straight[k].iterations + 1) << k;
    const double work = straight[k].state.wear[0].frictional_work;
    EXPECT_NEAR(turned[k].state.wear[0].frictional_work, work, 1e-10 * work + 1e-12) << k;
  }
}

inline constexpr double pin_R = 5.0, bush_R = 5.02;

/// A ring or a part of one from its unit cube: angle from the first coordinate, radius from the third.
inline std::function<Vec3(const Vec3&)> ring(double from, double to, double inside, double outside, double length) {
  return [=](const Vec3& t) {
    const double angle = from + (to - from) * t.x(), r = inside + (outside - inside) * t.z();
    return Vec3(r * std::cos(angle), r * std::sin(angle), length * t.y());
  };
}

/// A rigid pin in an elastic shell below it, or, at half an angle of pi, in a bush, pressed down by a force and turned.
struct PinInShell {
  double friction = 0.3;
  int facets = 48;           ///< of the pin
  double half_angle = 0.35;  ///< of the shell
  int cells = 10;            ///< along it
  body::Motion turn{};

  sim::SolidProblem problem() const {
    auto pin = solid(
        "pin",
        block(mesh::SolidKind::hex8, {facets, 1, 1}, Vec3::Ones(), ring(0.0, 2.0 * std::numbers::pi, 2.0, pin_R, 2.0)),
        turning_E, 0.3);
    pin.rigid = true;
    auto guide = rigid_face("drive", "", {fixed_motion(), loaded(-400.0, "press"), fixed_motion()},
                            {fixed_motion(), fixed_motion(), turn});
    guide.body = "pin";
    guide.centre_mm = Vec3(0, 0, 1.0);
    pin.supports = {guide};
    const double lowest = -0.5 * std::numbers::pi;
    auto shell = solid("shell",
                       block(mesh::SolidKind::hex8, {cells, 2, 3}, Vec3::Ones(),
                             ring(lowest - half_angle, lowest + half_angle, bush_R, bush_R + 2.0, 2.0)),
                       turning_E / 50.0, 0.3);
    shell.supports = {by_node("outside", "z1", {fixed_motion(), fixed_motion(), fixed_motion()})};
    auto all = problem_of({shell, pin}, {0, "z0"}, {1, "z1"}, friction, 0.3);
    all.scene.histories["press"] = all.scene.histories["turn"] = {{0.0, 0.0}, {1.0, 1.0}};
    all.scene.steps = {step_of(3, {"press"})};
    return all;
  }
};

/// The pin turned in as many equal increments.
inline sim::SolidProblem pin_in_shell(double friction, int facets, int turns, int increments) {
  PinInShell scene{.friction = friction, .facets = facets};
  scene.turn = moved(2.0 * std::numbers::pi * turns, "turn");
  auto problem = scene.problem();
  problem.scene.steps.push_back(step_of(increments, {"turn"}));
  return problem;
}

}  // namespace reye::support
