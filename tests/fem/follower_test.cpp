#include "fem/follower.hpp"

#include <gtest/gtest.h>

#include "fem/assemble_loads.hpp"
#include "finite_support.hpp"

namespace {

using namespace reye;
using namespace reye::fem_tests;

const fem::BoundaryLoad squeeze{"squeeze", "top", 3.0, {0.0, 0.0}, {{0.3, 2.2}}, ""};

Vector force(const Mesh& mesh, Analysis analysis, const fem::BoundaryLoad& load, const Vector& u) {
  Vector f = Vector::Zero(u.size());
  fem::FollowerPressure(mesh, analysis, load).add_force(1.0, mesh, u, f);
  return f;
}

// Without displacement a follower pressure must be the dead one.
TEST(follower, undeformed_equals_dead_load) {
  for (auto kind : kinds)
    for (auto analysis : {Analysis::plane_strain, Analysis::axisymmetric}) {
      const auto mesh = patch_mesh(kind);
      const Vector dead = fem::load_vector(mesh, analysis, squeeze);
      EXPECT_LT((force(mesh, analysis, squeeze, Vector::Zero(dead.size())) - dead).norm(), 1e-12 * dead.norm());
    }
}

// The tangent of a follower pressure must be its derivative: central differences, exact for the quadratic that it is at
// most, agree to round-off.
TEST(follower, tangent_is_the_derivative) {
  for (auto kind : kinds)
    for (auto analysis : {Analysis::plane_strain, Analysis::axisymmetric}) {
      const auto mesh = patch_mesh(kind);
      const Vector u = bent(mesh);
      const Vector along = nodal(mesh, [](const Vec2& X) {
        return Vec2{std::sin(5 * X.x() + X.y()), std::cos(3 * X.x())};
      });
      const fem::Pattern pattern(mesh);
      auto K = pattern.zero();
      fem::FollowerPressure(mesh, analysis, squeeze).add_tangent(1.0, mesh, u, pattern, K);
      const Vector exact = K * along;
      const auto error = [&](double h) {
        return ((force(mesh, analysis, squeeze, u + h * along) - force(mesh, analysis, squeeze, u - h * along)) /
                    (2 * h) -
                exact)
                   .norm() /
               exact.norm();
      };
      EXPECT_LT(error(1e-4), 1e-9) << name_of(kind) << " " << name_of(analysis);
    }
}

// On a closed outline it must neither push nor turn a plane body, and on an edge its resultant is p times the chord of
// the deformed edge, turned.
TEST(follower, resultants_are_those_of_a_fluid) {
  for (auto kind : kinds) {
    const auto mesh = patch_mesh(kind);
    const Vector u = bent(mesh);
    Vec2 all = Vec2::Zero();
    double moment = 0.0, size = 0.0;
    for (const auto& [name, boundary] : mesh.boundaries) {
      const Vector f = force(mesh, Analysis::plane_strain, {name, name, 3.0, {0.0, 0.0}, {}, ""}, u);
      Vec2 sum = Vec2::Zero();
      for (int k = 0; k < mesh.node_count(); ++k) {
        sum += f.segment<2>(2 * k);
        moment += base::cross(mesh.X[k] + u.segment<2>(2 * k), f.segment<2>(2 * k));
      }
      const auto x = [&](int node) { return Vec2(mesh.X[node] + u.segment<2>(2 * node)); };
      const Vec2 chord = x(boundary[0].back()) - x(boundary[0].front());
      EXPECT_LT((sum + 3.0 * base::right_of(chord)).norm(), 1e-12 * sum.norm());
      all += sum;
      size += sum.norm();
    }
    EXPECT_LT(all.norm(), 1e-12 * size);
    EXPECT_LT(std::abs(moment), 1e-12 * size);
  }
}

}  // namespace
