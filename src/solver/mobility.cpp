#include "solver/mobility.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "body/turning.hpp"

namespace reye::solver {

namespace {

/// The directions in which a node is moved by the columns that nothing prescribes.
body::NodeFreedom freedom_of(const body::NodePosition& position, int offset, const std::vector<char>& prescribed) {
  constexpr double parallel = 1e-3;
  body::NodeFreedom freedom{0, Vec2::Zero()};
  for (int t = 0; t < position.count; ++t) {
    const auto& [column, direction] = position.terms[t];
    if (prescribed[offset + column] || direction.norm() == 0.0) continue;
    const Vec2 unit = direction.normalized();
    if (freedom.free == 0)
      freedom = {1, unit};
    else if (std::abs(base::cross(freedom.direction, unit)) > parallel)
      freedom.free = 2;
  }
  return freedom;
}

/// The column of the rotation of a body; -1 where it has none.
int angle_column(const System& system, int body) {
  if (std::holds_alternative<body::RigidBody>(system.bodies[body])) return system.offset[body] + body::RigidBody::angle;
  const auto* linear = std::get_if<body::LinearBody>(&system.bodies[body]);
  return linear && linear->turning() ? system.offset[body] + linear->turning()->angle : -1;
}

/// The angle by which supports turn a side; zero where it is made of several bodies.
double imposed_turn(const System& system, const std::vector<contact::SurfaceNode>& side, const Vector& q,
                    const Controls& controls) {
  const int body = side.front().body;
  if (std::any_of(side.begin(), side.end(), [&](const auto& node) { return node.body != body; })) return 0.0;
  const int angle = angle_column(system, body);
  for (const auto& [column, value] : controls.prescribed)
    if (column == angle) return value - q[angle];
  return 0.0;
}

}  // namespace

contact::Mobility mobility(const System& system, const contact::Setup& setup, const Vector& q,
                           const Controls& controls) {
  contact::Mobility result;
  const double turn =
      imposed_turn(system, setup.secondary_nodes, q, controls) - imposed_turn(system, setup.primary_nodes, q, controls);
  result.turn = std::remainder(turn, 2.0 * std::numbers::pi);  // a cycle of whole turns ends where it began
  const auto held = [](const body::NodeFreedom& f) { return f.free == 1; };
  if (std::none_of(setup.freedom.begin(), setup.freedom.end(), held)) return result;
  std::vector<char> prescribed(system.dofs, 0);
  for (const auto& [column, value] : controls.prescribed) prescribed[column] = 1;
  const auto parts = system.parts(q);
  const auto freedom = [&](const contact::SurfaceNode& node) {
    return std::visit(
        [&](const auto& b) {
          return freedom_of(b.position(node.contact_node, parts[node.body]), system.offset[node.body], prescribed);
        },
        system.bodies[node.body]);
  };
  for (std::size_t j = 0; j < setup.freedom.size(); ++j)
    result.secondary.push_back(held(setup.freedom[j]) && freedom(setup.secondary_nodes[j]).free == 1);
  for (const auto& node : setup.primary_nodes) result.primary.push_back(freedom(node));
  return result;
}

}  // namespace reye::solver
