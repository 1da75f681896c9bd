#include "solver/solid/increment_state.hpp"

#include <algorithm>

namespace reye::solver {

SolidState initial_state(const SolidSystem& system) {
  SolidState state;
  for (const auto& contact : system.contacts) {
    state.traction.emplace_back(contact.count(), Vec3::Zero());
    state.status.emplace_back(contact.count(), contact::SkinStatus::open);
    state.wear.push_back(contact::fresh_wear(contact));
  }
  state.a = Vector::Zero(system.free());
  state.s = Vector::Zero(system.driven());
  state.u = Vector::Zero(3 * system.points());
  state.turn.assign(system.bodies.size(), base::Turn::Identity());
  return state;
}

bool touched(const SolidState& state) {
  return std::any_of(state.status.begin(), state.status.end(), [](const auto& contact) {
    return std::any_of(contact.begin(), contact.end(), [](auto s) { return s != contact::SkinStatus::open; });
  });
}

std::vector<body::SolidPose> poses_between(const SolidSystem& system, const SolidState& before, const Vector& a,
                                           const Vector& s) {
  std::vector<body::SolidPose> poses(system.bodies.size());
  const Vector step = a - before.a;
  for (std::size_t b = 0; b < poses.size(); ++b)
    if (system.turning[b])
      poses[b] = body::pose_of(*system.turning[b], before.turn[b], system.of_free(step, b), system.of_free(a, b),
                               system.of_driven(s, b));
  return poses;
}

std::vector<body::SolidPose> poses_of(const SolidSystem& system, const SolidState& state) {
  return poses_between(system, state, state.a, state.s);
}

Vector displacements_of(const SolidSystem& system, const SolidState& state) {
  const auto poses = poses_of(system, state);
  const Vector none = Vector::Zero(3 * system.points());
  Vector u = displacement(system, {none, state.s, state.a, poses});
  for (int turn = 0; turn < 3; ++turn) {  // the integrals follow from where the points are
    Vector force = Vector::Zero(3 * system.points());
    for (std::size_t c = 0; c < system.contacts.size(); ++c) {
      mortar::SkinPairs pairs;
      add_contact_forces(contact::place_skins(system.contacts[c], u, system.held, system.points(), pairs),
                         state.traction[c], force);
    }
    u = displacement(system, {force, state.s, state.a, poses});
  }
  return u;
}

}  // namespace reye::solver
