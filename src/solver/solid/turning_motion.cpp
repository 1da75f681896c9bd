#include "solver/solid/turning_motion.hpp"

#include <algorithm>

namespace reye::solver {

namespace {

using body::Twist;

constexpr std::array sides{&contact::SkinSetup::secondary, &contact::SkinSetup::primary};

/// Calls f(body, column) for each point of a contact.
template <class F>
void each_point(const contact::SkinSetup& setup, F f) {
  for (const auto side : sides)
    for (const auto& point : (setup.*side).points) f(static_cast<std::size_t>(point.body), point.column);
}

std::size_t secondary_body(const contact::SkinSetup& setup) {
  return static_cast<std::size_t>(setup.secondary.points.front().body);
}

bool any_turns(const SolidSystem& system, const contact::SkinSetup& setup) {
  bool any = false;
  if (system.turns()) each_point(setup, [&](std::size_t b, int) { any = any || system.turning[b]; });
  return any && !setup.secondary.points.empty();
}

}  // namespace

std::vector<std::vector<Twist>> relative_twists(const SolidSystem& system,
                                                const std::vector<body::SolidPose>& old_poses,
                                                const std::vector<body::SolidPose>& poses) {
  std::vector<std::vector<Twist>> twists(system.contacts.size());
  for (std::size_t c = 0; c < twists.size(); ++c) {
    if (!any_turns(system, system.contacts[c])) continue;
    const std::size_t s = secondary_body(system.contacts[c]);
    for (std::size_t b = 0; b < system.bodies.size(); ++b)
      twists[c].push_back(b == s ? Twist{} : body::relative_twist(old_poses[b], poses[b], old_poses[s], poses[s]));
  }
  return twists;
}

Vector seen_motion(const SolidSystem& system, const Standing& standing, std::size_t c) {
  Vector seen = Vector::Zero(standing.x.size());
  each_point(system.contacts[c], [&](std::size_t b, int column) {
    const Vec3 x = standing.x.segment<3>(3 * column), before = standing.x_old.segment<3>(3 * column);
    seen.segment<3>(3 * column) =
        x - body::carried_along(standing.old_poses[b], standing.poses[b], before) + standing.twist[c][b].at(x);
  });
  return seen;
}

Vector carried_displacements(const SolidSystem& system, const SolidState& old, const Vector& s,
                             const Standing& standing) {
  Vector u = old.u;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const int first = system.first_point[b];
    if (!system.turning[b]) {
      const Matrix& U = system.bodies[b].U();
      u.segment(3 * first, U.rows()) += U * system.of_driven(s - old.s, b);
      continue;
    }
    const auto& X = system.turning[b]->points;
    for (std::size_t i = 0; i < X.size(); ++i) {
      auto own = u.segment<3>(3 * (first + static_cast<int>(i)));
      own = body::carried_along(standing.old_poses[b], standing.poses[b], X[i] + own) - X[i];
    }
  }
  return u;
}

std::vector<Points3> carried_tractions(const SolidSystem& system, const SolidState& old, const Standing& standing) {
  auto tractions = old.traction;
  for (std::size_t c = 0; c < tractions.size(); ++c)
    for (std::size_t j = 0; j < tractions[c].size(); ++j) {
      const auto b = static_cast<std::size_t>(system.contacts[c].secondary.points[j].body);
      Vec3& z = tractions[c][j];
      if (system.turning[b]) z = standing.poses[b].R * (standing.old_poses[b].R.transpose() * z);
    }
  return tractions;
}

namespace {

/// d x / d a of one body that turns: the frame moves, and forces turn in it.
void add_places(const SolidSystem& system, std::size_t b, const Standing& standing, const Vector& force,
                const Vector& s, const std::vector<Twist>& twists, Matrix& places) {
  const auto& turning = *system.turning[b];
  const auto& pose = standing.poses[b];
  const Vector f = system.of_points(force, b), values = system.of_driven(s, b);
  for (int k = 0; k < turning.count(); ++k) {
    const Twist& twist = twists[k];
    Vector turned_force(f.size());
    for (Eigen::Index i = 0; i < f.size(); i += 3)
      turned_force.segment<3>(i) = -twist.turn.cross(Vec3(f.segment<3>(i)));
    Vector change = Vector::Zero(f.size());
    if (turning.rotation(k))
      change = body::to_space(pose, response_in_frame(system, b, body::to_frame(pose, turned_force),
                                                      body::frame_value_change(turning, pose, values, twist.turn)));
    const int first = 3 * system.first_point[b];
    for (Eigen::Index i = 0; i < f.size(); i += 3) change.segment<3>(i) += twist.at(standing.x.segment<3>(first + i));
    places.col(system.first_free[b] + k).segment(first, f.size()) = change;
  }
}

/// d `seen_motion` / d a of the motions of one body, beside what follows the places of its points.
void add_seen(const SolidSystem& system, std::size_t moving, const Standing& standing, std::size_t c,
              const std::vector<Twist>& twists, Matrix& seen) {
  const std::size_t s = secondary_body(system.contacts[c]);
  for (int k = 0; k < static_cast<int>(twists.size()); ++k) {
    std::vector<Twist> changes(system.bodies.size());
    for (std::size_t b = 0; b < changes.size(); ++b) {
      Twist twist = standing.twist[c][b];
      if (b == s || (b != moving && s != moving)) continue;
      if (b != moving) twist = {-twist.turn, -twist.way, twist.origin};
      changes[b] = body::change_of(twist, twists[k]);
      if (b != moving) changes[b] = {-changes[b].turn, -changes[b].way, changes[b].origin};
    }
    each_point(system.contacts[c], [&](std::size_t b, int column) {
      Vec3 change = changes[b].at(standing.x.segment<3>(3 * column));
      if (b == moving)
        change -= twists[k].at(
            body::carried_along(standing.old_poses[b], standing.poses[b], standing.x_old.segment<3>(3 * column)));
      seen.col(system.first_free[moving] + k).segment<3>(3 * column) = change;
    });
  }
}

}  // namespace

TurningTangent turning_tangent(const SolidSystem& system, const Standing& standing, const Vector& force,
                               const Vector& s, const Vector& step) {
  TurningTangent tangent;
  if (!system.turns()) return tangent;
  tangent.places = Matrix::Zero(3 * system.points(), system.free());
  tangent.balance = Matrix::Zero(system.free(), system.free());
  for (const auto& twist : standing.twist)
    tangent.seen.push_back(twist.empty() ? Matrix() : Matrix(Matrix::Zero(3 * system.points(), system.free())));
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    if (!system.turning[b] || system.turning[b]->count() == 0) continue;
    const auto& turning = *system.turning[b];
    const Vector own_step = system.of_free(step, b);
    const auto twists = body::twists_of(turning, standing.poses[b], own_step);
    add_places(system, b, standing, force, s, twists, tangent.places);
    for (std::size_t c = 0; c < standing.twist.size(); ++c)
      if (!standing.twist[c].empty()) add_seen(system, b, standing, c, twists, tangent.seen[c]);
    tangent.balance.block(system.first_free[b], system.first_free[b], turning.count(), turning.count()) =
        body::balance_rate(turning, standing.poses[b], system.of_points(force, b), own_step, system.of_driven(s, b));
  }
  return tangent;
}

Vector change_of_places(const SolidSystem& system, const Standing& standing, const Vector& force, const Vector& a_step,
                        const TurningTangent& tangent) {
  const Vector none = Vector::Zero(system.driven());
  Vector moved = displacement(system, {force, none, a_step, standing.poses});
  if (!system.turns()) return moved;
  const Vector turned = tangent.places * a_step;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    if (!system.turning[b]) continue;
    const auto& pose = standing.poses[b];
    const Vector values = Vector::Zero(system.bodies[b].U().cols());
    const auto first = 3 * system.first_point[b];
    auto own = moved.segment(first, 3 * system.first_point[b + 1] - first);
    own = body::to_space(pose, response_in_frame(system, b, body::to_frame(pose, system.of_points(force, b)), values));
    own += turned.segment(first, own.size());
  }
  return moved;
}

}  // namespace reye::solver
