#include "material/tensor.hpp"

#include <Eigen/Eigenvalues>

#include "material/laws.hpp"

namespace {

using namespace reye::material;
using namespace reye::material::test;
using reye::base::Dual;

/// From equal eigenvalues to a ratio of 1e4, on both sides of the switches from series to closed form and from few
/// terms of them to many.
const Symmetric<double> tensors[] = {{1.0, 1.0, 0.0, 1.0},       {2.0, 2.0, 1e-9, 0.5},      {1.02, 0.98, 0.01, 1.1},
                                     {1.0098, 0.9902, 0.0, 1.0}, {1.012, 0.988, 0.001, 1.0}, {1.36, 0.73, 0.02, 1.0},
                                     {1.19, 0.84, 0.02, 1.0},    {1.19, 0.83, 0.05, 1.0},    {3.0, 0.5, -0.7, 2.0},
                                     {100.0, 1e-2, 1e-3, 5.0}};

// The logarithm must be that of the spectral decomposition, whether or not the eigenvalues are equal.
TEST(tensor, logarithm_is_the_spectral_one) {
  for (const auto& A : tensors) {
    const Eigen::SelfAdjointEigenSolver<Tensor> eigen(tensor(A));
    const Tensor V = eigen.eigenvectors(),
                 expected = V * eigen.eigenvalues().array().log().matrix().asDiagonal() * V.transpose();
    const double condition = eigen.eigenvalues()[2] / eigen.eigenvalues()[0];  // what round-off in A does to ln A
    EXPECT_LT((tensor(logarithm(A)) - expected).norm(), 1e-15 * (2 + condition)) << A[0];
  }
}

// The exponential must undo the logarithm.
TEST(tensor, exponential_inverts_the_logarithm) {
  for (const auto& A : tensors)
    EXPECT_LT((tensor(exponential(logarithm(A))) - tensor(A)).norm(), 1e-14 * tensor(A).norm());
}

// The derivative of the logarithm must be exact, at equal eigenvalues too, where no eigenvector has a derivative.
TEST(tensor, logarithm_is_linearised) {
  const auto f = [](const auto& A) { return logarithm(A); };
  for (const auto& A : tensors) {
    const double scale = std::min(A[1], 1.0);
    const Symmetric<double> d{0.3 * scale, -0.5 * scale, 0.7 * scale, 0.2};
    EXPECT_NEAR(linearisation_rate(f, A, d), 2.0, 0.02) << A[0];
  }
}

// At the unit tensor d ln A = dA, component by component.
TEST(tensor, logarithm_has_unit_slope_at_the_unit_tensor) {
  Symmetric<Dual<4>> A{1.0, 1.0, 0.0, 1.0};
  for (int i = 0; i < 4; ++i) A[i].d[i] = 1.0;
  const auto log_A = logarithm(A);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) EXPECT_NEAR(log_A[i].d[j], i == j ? 1.0 : 0.0, 1e-15);
}

// The cube root beyond one must keep all digits of small arguments, and have its own derivative.
TEST(tensor, cube_root_beyond_unit_keeps_the_digits) {
  for (const double q : {0.0, 1e-18, -3e-9, 2e-4, -0.03, 0.0999, -0.0999, 0.1001, -0.9, 5.0}) {
    const long double root = std::expm1(std::log1p(static_cast<long double>(q)) / 3.0L);
    EXPECT_NEAR(cube_root_beyond_unit(q), static_cast<double>(root), 4e-16 * std::abs(q)) << q;
    const auto at = cube_root_beyond_unit(Dual<1>::variable(q, 0));
    EXPECT_EQ(at.v, cube_root_beyond_unit(q)) << q;
    EXPECT_NEAR(at.d[0] * 3.0 * std::pow(1.0 + static_cast<double>(root), 2.0), 1.0, 1e-14) << q;
  }
}

// Pushing with F and then with its inverse must give the tensor back.
TEST(tensor, push_forward_is_F_A_FT) {
  const Gradient<double> F{1.2, 0.4, -0.3, 0.9, 1.1};
  const Symmetric<double> A = tensors[5];
  EXPECT_LT((tensor(pushed(F, A)) - tensor(F) * tensor(A) * tensor(F).transpose()).norm(), 1e-14);
  EXPECT_LT((tensor(pushed(inverse(F), pushed(F, A))) - tensor(A)).norm(), 1e-14);
}

}  // namespace
