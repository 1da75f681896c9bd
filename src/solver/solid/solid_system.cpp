#include "solver/solid/solid_system.hpp"

#include <algorithm>

#include "algebra/decompose.hpp"
#include "algebra/product.hpp"
#include "mesh/solid/solid_measure.hpp"

namespace reye::solver {

namespace {

/// The directions along which the pivot of a body that turns can move its points, as a projector; of a rotation all
/// across its axis, since the body may have turned.
base::Mat3 pivot_moves(const body::SolidTurning& turning) {
  base::Mat3 moves = base::Mat3::Zero();
  for (int m = 0; m < 6; ++m) {
    const Vec3 e = turning.pivot.axes.col(m % 3);
    if (body::keeps_still(turning.pivot.motions[m])) continue;
    moves += m < 3 ? base::Mat3(e * e.transpose()) : base::Mat3(base::Mat3::Identity() - e * e.transpose());
  }
  return moves;
}

/// The directions in which no force, drive or free motion moves a point.
contact::HeldDirections held_directions(const body::SolidBody& body, int point, double compliance, base::Mat3 moves) {
  const int row = 3 * point;
  if (compliance > 0.0) moves += body.C().of_point(row) / compliance;
  for (const Matrix* part : {&body.U(), &body.A()})
    if (part->cols() > 0) moves += algebra::product_transposed(part->middleRows<3>(row), part->middleRows<3>(row));
  const auto [values, vectors] = algebra::eigenpairs(moves);
  contact::HeldDirections held;
  constexpr double none = 1e-10;
  for (int k = 0; k < 3; ++k)
    if (values[k] < none) held.d[held.count++] = vectors.col(k);
  return held;
}

Matrix relief_of(const body::SolidBody& body) {
  const Matrix& A = body.A();
  if (A.cols() == 0) return {};
  return body.C().times(algebra::product(A, algebra::pseudo_inverse(algebra::transposed_product(A, A))));
}

std::vector<int> starts(const std::vector<body::SolidBody>& bodies, const auto& count) {
  std::vector<int> first{0};
  for (const auto& body : bodies) first.push_back(first.back() + static_cast<int>(count(body)));
  return first;
}

/// Free motions that no spring acts against.
int count_unheld(const body::SolidBody& body, const std::optional<body::SolidTurning>& turning) {
  return static_cast<int>(turning ? body::unheld_motions(*turning).size() : body.A().cols());
}

}  // namespace

Vector SolidSystem::part(const Vector& all, const std::vector<int>& first, std::size_t body, int size) {
  return all.segment(size * first[body], size * (first[body + 1] - first[body]));
}

bool SolidSystem::turns() const {
  return std::any_of(turning.begin(), turning.end(), [](const auto& body) { return body.has_value(); });
}

SolidSystem make_system(std::vector<body::SolidBody> bodies, std::vector<std::optional<body::SolidTurning>> turning) {
  SolidSystem system;
  system.bodies = std::move(bodies);
  system.turning = std::move(turning);
  system.turning.resize(system.bodies.size());
  const auto of = [&](const body::SolidBody& body) -> const std::optional<body::SolidTurning>& {
    return system.turning[&body - system.bodies.data()];
  };
  system.first_point = starts(system.bodies, [](const auto& body) { return body.retained().size(); });
  system.first_driven = starts(
      system.bodies, [&](const auto& body) { return of(body) ? of(body)->driven.size() : body.driven().size(); });
  system.first_free =
      starts(system.bodies, [&](const auto& body) { return of(body) ? of(body)->count() : body.A().cols(); });
  for (const auto& body : system.bodies) {
    const double compliance = body.C().largest();
    const base::Mat3 moves = of(body) ? pivot_moves(*of(body)) : base::Mat3(base::Mat3::Zero());
    system.unheld += count_unheld(body, of(body));
    system.yields.push_back(body.C().yields());
    system.relief.push_back(relief_of(body));
    for (int i = 0; i < static_cast<int>(body.retained().size()); ++i)
      system.held.push_back(held_directions(body, i, compliance, moves));
  }
  return system;
}

Vector motion_scale(const SolidSystem& system) {
  Vector scale = Vector::Ones(system.free());
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    if (!system.turning[b]) continue;
    const double size = mesh::box_diagonal(system.bodies[b].input().mesh->X);
    for (int k = 0; k < system.turning[b]->count(); ++k)
      if (system.turning[b]->rotation(k)) scale[system.first_free[b] + k] = 1.0 / size;
  }
  return scale;
}

Vector response_in_frame(const SolidSystem& system, std::size_t b, const Vector& force, const Vector& s) {
  const auto& body = system.bodies[b];
  Vector w = body.U() * s;
  if (!system.yields[b]) return w;
  body.C().add(force, w);
  if (body.A().cols() > 0) w.noalias() -= system.relief[b] * (body.A().transpose() * force + body.B() * s).eval();
  return w;
}

namespace {

/// Displacements of the points of a body that turns.
Vector turned_displacement(const SolidSystem& system, std::size_t b, const SolidMotion& motion) {
  const auto& turning = *system.turning[b];
  const auto& pose = motion.poses[b];
  const Vector w = response_in_frame(system, b, body::to_frame(pose, system.of_points(motion.force, b)),
                                     body::frame_values(turning, pose, system.of_driven(motion.s, b)));
  Vector u(w.size());
  for (std::size_t i = 0; i < turning.points.size(); ++i) {
    const Vec3& X = turning.points[i];
    u.segment<3>(3 * static_cast<Eigen::Index>(i)) = pose.place(X, w.segment<3>(3 * static_cast<Eigen::Index>(i))) - X;
  }
  return u;
}

}  // namespace

Vector displacement(const SolidSystem& system, const SolidMotion& motion) {
  Vector u = Vector::Zero(3 * system.points());
  const Vector left = imbalance(system, motion);
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const auto& body = system.bodies[b];
    const int rows = 3 * static_cast<int>(body.retained().size());
    auto own = u.segment(3 * system.first_point[b], rows);
    if (system.turning[b]) {
      own = turned_displacement(system, b, motion);
      continue;
    }
    if (system.yields[b]) body.C().add(motion.force.segment(3 * system.first_point[b], rows), own);
    own.noalias() += body.U() * motion.s.segment(system.first_driven[b], body.U().cols());
    own.noalias() += body.A() * motion.a.segment(system.first_free[b], body.A().cols());
    if (system.yields[b] && body.A().cols() > 0)
      own.noalias() -= system.relief[b] * left.segment(system.first_free[b], body.A().cols());
  }
  return u;
}

void add_contact_forces(const contact::SkinPlace& place, const Points3& traction, Vector& force) {
  for (int j = 0; j < place.count(); ++j) {
    if (traction[j].isZero(0.0)) continue;
    for (contact::SkinRows::InnerIterator it(place.Q, j); it; ++it)
      force.segment<3>(3 * it.col()) -= it.value() * traction[j];
  }
}

Vector contact_forces(const SolidSystem& system, const std::vector<contact::SkinPlace>& places,
                      const std::vector<Points3>& traction) {
  Vector force = Vector::Zero(3 * system.points());
  for (std::size_t c = 0; c < places.size(); ++c) add_contact_forces(places[c], traction[c], force);
  return force;
}

Vector positions(const SolidSystem& system, const Vector& u) {
  Vector x = u;
  std::vector<char> done(static_cast<std::size_t>(system.points()), 0);
  for (const auto& contact : system.contacts)
    for (const auto* side : {&contact.secondary, &contact.primary})
      for (std::size_t i = 0; i < side->points.size(); ++i) {
        const int column = side->points[i].column;
        if (done[column]++) continue;
        x.segment<3>(3 * column) += side->skin.x[i];
      }
  return x;
}

Vector imbalance(const SolidSystem& system, const SolidMotion& motion) {
  Vector left = Vector::Zero(system.free());
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const auto& body = system.bodies[b];
    const int rows = 3 * static_cast<int>(body.retained().size());
    if (system.turning[b]) {
      left.segment(system.first_free[b], system.turning[b]->count()) =
          body::balance_of(*system.turning[b], motion.poses[b], system.of_points(motion.force, b),
                           system.of_free(motion.a, b), system.of_driven(motion.s, b));
      continue;
    }
    auto own = left.segment(system.first_free[b], body.A().cols());
    own.noalias() += body.A().transpose() * motion.force.segment(3 * system.first_point[b], rows);
    own.noalias() += body.B() * motion.s.segment(system.first_driven[b], body.B().cols());
  }
  return left;
}

double force_scale(const SolidSystem& system, const SolidMotion& motion) {
  double sum = motion.force.lpNorm<1>();
  for (std::size_t b = 0; b < system.bodies.size(); ++b)
    if (system.turning[b])
      sum += body::balance_scale(*system.turning[b], system.of_free(motion.a, b), system.of_driven(motion.s, b));
  return sum;
}

}  // namespace reye::solver
