#include <gtest/gtest.h>

#include <cmath>

#include "fem/assemble_loads.hpp"
#include "fem/stiffness.hpp"
#include "material/stress.hpp"
#include "support/meshes.hpp"

namespace {

using namespace reye;
using base::Analysis;
using base::Vec2;
using base::Vector;
using mesh::CellKind;

struct PatchCase {
  CellKind kind;
  Analysis analysis;
  bool b_bar;
  double nu;
};

class patch : public testing::TestWithParam<PatchCase> {
 protected:
  mesh::Mesh mesh_ = support::turned(
      support::rectangle(
          {.corner = {4, 1}, .size = {3, 2}, .nx = 6, .ny = 5, .kind = GetParam().kind, .distortion = 0.9}),
      GetParam().analysis == Analysis::axisymmetric ? 0.0 : 0.5);
  material::Material material_ = material::LinearElastic{2.1e5, GetParam().nu};
  /// u = G X; in axisymmetry a radius may only scale and the height may shear nothing.
  Eigen::Matrix2d gradient_ = GetParam().analysis == Analysis::axisymmetric
                                  ? Eigen::Matrix2d{{1.3e-3, 0.0}, {0.0, -0.7e-3}}
                                  : Eigen::Matrix2d{{1.3e-3, 0.4e-3}, {-1.1e-3, -0.7e-3}};

  material::Voigt<double> exact_stress() const {
    const auto& G = gradient_;
    const double hoop = GetParam().analysis == Analysis::axisymmetric ? G(0, 0) : 0.0;
    const material::Voigt<double> strain{G(0, 0), G(1, 1), G(0, 1) + G(1, 0), hoop};
    return material::stress(material_, GetParam().analysis, strain);
  }
  /// Nodal forces of the uniform stress on the whole outline.
  Vector outline_forces() const {
    const auto s = exact_stress();
    Vector f = Vector::Zero(2 * mesh_.node_count());
    for (const auto& [name, boundary] : mesh_.boundaries) {
      const auto& chain = boundary.front();
      const Vec2 n = base::right_of((mesh_.X[chain.back()] - mesh_.X[chain.front()]).normalized());
      const Vec2 t{s[0] * n.x() + s[2] * n.y(), s[2] * n.x() + s[1] * n.y()};
      f += fem::load_vector(mesh_, GetParam().analysis, {name, name, 0.0, t, {}, ""});
    }
    return f;
  }
};

// A state of uniform strain must be in balance with its tractions at every node, to round-off.
TEST_P(patch, uniform_state_is_in_balance) {
  const auto K = fem::stiffness(mesh_, material_, GetParam().analysis, GetParam().b_bar);
  Vector u(2 * mesh_.node_count());
  for (int k = 0; k < mesh_.node_count(); ++k) u.segment<2>(2 * k) = gradient_ * mesh_.X[k];
  const Vector f = outline_forces();
  EXPECT_LT((K * u - f).norm(), 1e-11 * f.norm());
}

// The stress recovered at the nodes of a uniform state must be that state.
TEST_P(patch, uniform_stress_is_recovered) {
  base::Points u;
  for (const Vec2& X : mesh_.X) u.push_back(gradient_ * X);
  const auto exact = exact_stress();
  const auto nodal = fem::nodal_stress(mesh_, material_, GetParam().analysis, GetParam().b_bar, u);
  const double size = std::abs(exact[0]) + std::abs(exact[1]) + std::abs(exact[2]);
  for (const auto& s : nodal)
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(s[i], exact[i], 1e-11 * size);
}

// The stiffness must be symmetric and cost nothing for rigid motions.
TEST_P(patch, rigid_motions_are_free) {
  const auto K = fem::stiffness(mesh_, material_, GetParam().analysis, GetParam().b_bar);
  EXPECT_LT((base::Matrix(K) - base::Matrix(K).transpose()).norm(), 1e-14 * K.norm());
  const bool ring = GetParam().analysis == Analysis::axisymmetric;
  for (int motion = ring ? 1 : 0; motion < (ring ? 2 : 3); ++motion) {
    Vector u(2 * mesh_.node_count());
    for (int k = 0; k < mesh_.node_count(); ++k)
      u.segment<2>(2 * k) = motion == 2 ? Vec2{-mesh_.X[k].y(), mesh_.X[k].x()} : Vec2(Vec2::Unit(motion));
    EXPECT_LT((K * u).norm(), 1e-13 * K.norm() * u.norm());
  }
}

std::vector<PatchCase> patch_cases() {
  std::vector<PatchCase> cases;
  for (auto kind : {CellKind::tri3, CellKind::quad4, CellKind::tri6, CellKind::quad8})
    for (auto analysis : {Analysis::plane_strain, Analysis::plane_stress, Analysis::axisymmetric})
      for (bool b_bar : {false, true})
        for (double nu : {0.3, 0.4999}) cases.push_back({kind, analysis, b_bar, nu});
  return cases;
}

INSTANTIATE_TEST_SUITE_P(all, patch, testing::ValuesIn(patch_cases()));

}  // namespace
