#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "body/turning.hpp"
#include "support/assembly.hpp"

/// A wheel on a plate, which rolls it or under which it spins.
namespace reye::rolling {

using base::Vec2;
using body::Drive;
using support::Assembly;
using support::moved;

inline constexpr double pi = std::numbers::pi, radius = 10.0, hub = 5.0, force = 100.0;

/// A closed ring about (0, radius) with outline `rim` and bore `hub`.
inline mesh::Mesh wheel(int around, int across) {
  mesh::Mesh m;
  m.kind = mesh::CellKind::quad4;
  for (int i = 0; i <= across; ++i)
    for (int j = 0; j < around; ++j) {
      const double r = hub + (radius - hub) * i / across, angle = 2.0 * pi * j / around - 0.5 * pi;
      m.X.push_back({r * std::cos(angle), radius + r * std::sin(angle)});
    }
  const auto node = [&](int i, int j) { return i * around + j % around; };
  mesh::Chain rim, bore;
  for (int j = 0; j <= around; ++j) {
    rim.push_back(node(across, j));
    bore.push_back(node(0, around - j));
  }
  for (int i = 0; i < across; ++i)
    for (int j = 0; j < around; ++j)
      m.cells.push_back(mesh::cell_of({node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)}));
  m.boundaries = {{"rim", {rim}}, {"hub", {bore}}};
  m.outline = {rim, bore};
  return m;
}

/// The wheel pressed by its hub on a rigid plate; the plate moves by `way`, and the hub turns by `angle` or, without
/// one, freely.
inline Assembly on_plate(int around, double friction, double way, std::optional<double> angle) {
  Assembly a;
  a.meshes = {wheel(around, 5), support::rectangle({.corner = {-20, -2}, .size = {800, 2}, .nx = 2, .ny = 1})};
  a.inputs = {support::elastic(3000.0, 0.3), support::elastic(1.0, 0.3)};
  a.rigid = {0, 1};
  body::Support axle;
  axle.name = "axle";
  axle.edge = "hub";
  axle.x.drive = Drive::fixed;
  axle.y = support::loaded(-force);
  axle.rigid = true;
  if (angle) axle.rotation = moved(*angle);
  body::Support plate;
  plate.name = "plate";
  plate.edge = "bottom";
  plate.x = moved(way);
  plate.y.drive = plate.rotation.drive = Drive::fixed;
  plate.rotation.drive = Drive::fixed;
  a.inputs[0].supports = {axle};
  a.inputs[1].supports = {plate};
  contact::ContactOptions c;
  c.friction = friction;
  support::touch(a, c, {0, "rim"}, {1, "top"});
  a.modulus_MPa = 3000.0;
  return a;
}

inline Vec2 resultant(const solver::SolverState& s) {
  Vec2 sum{0, 0};
  for (std::size_t j = 0; j < s.contacts[0].lambda.size(); ++j)
    sum += s.contacts[0].reference[j].carried() * s.contacts[0].lambda[j];
  return sum;
}

inline double peak(const solver::SolverState& s) {
  double most = 0.0;
  for (const auto& l : s.contacts[0].lambda) most = std::max(most, l.norm());
  return most;
}

struct Turned {
  double angle = 0.0, peak = 0.0;
  Vec2 force{0, 0};
  double friction_work = 0.0;  ///< so far
  double moment = 0.0;         ///< of the hub
};

/// States after each of `turns` revolutions of the wheel, rolled by the plate under it.
inline std::vector<Turned> rolled(int turns) {
  constexpr int around = 120, steps = 240;
  const double rim = around * 2.0 * radius * std::sin(pi / around);
  const auto system = support::system_of(on_plate(around, 0.3, 0.0, {}));
  solver::Newton newton;
  auto state = support::fresh(system);
  std::vector<Turned> result;
  for (int step = 0; step <= turns * steps; ++step) {
    const Assembly now = on_plate(around, 0.3, -rim * step / steps, {});
    auto controls = support::controls_of(now, system);
    controls.continues = step > 1 ? 1.0 : 0.0;
    const auto solved = newton.solve(system, state, controls);
    EXPECT_TRUE(solved.report.converged) << "step " << step << ": " << solved.report.reason;
    if (!solved.report.converged) return result;
    state = solved.state;
    const auto& wheel = std::get<body::LinearBody>(system.bodies[0]);
    if (step % steps == 0 && step > 0)
      result.push_back({wheel.angle(system.part(state.q.high, 0)), peak(state), resultant(state)});
  }
  return result;
}

inline void expect_rolling(int turns) {
  const auto states = rolled(turns);
  ASSERT_EQ(states.size(), static_cast<std::size_t>(turns));
  const double turn = (states.back().angle - states[0].angle) / (turns - 1);
  EXPECT_NEAR(std::abs(turn) / (2.0 * pi), 1.0, 2e-2);
  // A turn gains 0.7 of a facet on the plate's way, so turns end at other places of a facet, on which the angle
  // depends.
  constexpr double jitter = 0.05 * 2.0 * pi / 120;
  for (std::size_t k = 1; k < states.size(); ++k) {
    EXPECT_NEAR(states[k].angle - states[k - 1].angle, turn, jitter) << "turn " << k;
    EXPECT_NEAR(states[k].peak, states[1].peak, 1e-2 * states[1].peak) << "turn " << k;
    EXPECT_NEAR(states[k].force.norm(), force, 1e-5 * force);
    EXPECT_LT(std::abs(states[k].force.x()), 5e-3 * force) << "turn " << k;  // free rolling
  }
}

/// The wheel pressed on a block, whose top carries the multipliers, and spun by an angle.
inline Assembly on_block(int around, double angle, double E_MPa = 3000.0) {
  Assembly a = on_plate(around, 0.3, 0.0, angle);
  a.meshes[1] = support::rectangle({.corner = {-2, -2}, .size = {4, 2}, .nx = std::max(20, around * 4 / 63), .ny = 10});
  for (auto& input : a.inputs) input.material = support::elastic(E_MPa, 0.3).material;
  a.modulus_MPa = E_MPa;
  a.inputs[1].supports = {support::fixed_edge("base", "bottom")};
  a.rigid.clear();
  const auto options = a.touches.front().options;
  a.touches.clear();
  support::touch(a, options, {1, "top"}, {0, "rim"});
  return a;
}

/// The wheel of `around` facets pressed, then spun through these angles against friction. The state after each.
inline std::vector<Turned> spun(int around, const std::vector<double>& angles, double E_MPa = 3000.0) {
  const auto system = support::system_of(on_block(around, 0.0, E_MPa));
  const int angle_column = system.offset[0] + std::get<body::LinearBody>(system.bodies[0]).turning()->angle;
  solver::Newton newton;
  auto state = support::fresh(system);
  std::vector<Turned> result;
  const auto play = [&](double angle) {
    const auto controls = support::controls_of(on_block(around, angle, E_MPa), system);
    const auto solved = newton.solve(system, state, controls);
    EXPECT_TRUE(solved.report.converged) << angle << " rad: " << solved.report.reason;
    if (solved.report.converged) state = solved.state;
    result.push_back({angle, peak(state), resultant(state), state.contacts[0].frictional_work,
                      solver::reactions(system, state, controls)[angle_column]});
    return solved.report.converged;
  };
  if (play(0.0)) std::all_of(angles.begin(), angles.end(), play);
  result.erase(result.begin());
  return result;
}

/// Every step must leave the state of the first: its friction and its peak; nodes and facets meet alike.
inline void expect_no_drift(int around, int steps) {
  std::vector<double> angles;
  for (int k = 1; k <= steps; ++k) angles.push_back(pi / 12.0 * k);
  const auto states = spun(around, angles);
  ASSERT_EQ(states.size(), static_cast<std::size_t>(steps));
  for (const auto& s : states) {
    EXPECT_NEAR(std::abs(s.force.y()), force, 1e-6 * force) << s.angle;
    EXPECT_NEAR(std::abs(s.force.x()), 0.3 * force, 2e-2 * force) << s.angle;
    EXPECT_NEAR(s.force.x(), states[0].force.x(), 1e-6 * force) << s.angle;
    EXPECT_NEAR(s.peak, states[0].peak, 1e-6 * states[0].peak) << s.angle;
  }
}

}  // namespace reye::rolling
