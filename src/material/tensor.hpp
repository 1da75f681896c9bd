#pragma once
#include <array>
#include <cmath>
#include <type_traits>

#include "base/dual.hpp"

/// Symmetric tensors with one eigenvector out of the plane, and their logarithm and exponential.
namespace reye::material {

/// Tensor components (11, 22, 12, 33), the shear not doubled.
template <class T>
using Symmetric = std::array<T, 4>;

/// Components in the order (11, 22, 12, 33); a strain has the engineering shear, gamma = 2 eps_12.
template <class T>
using Voigt = std::array<T, 4>;

/// Deformation gradient F11, F12, F21, F22, F33.
template <class T>
using Gradient = std::array<T, 5>;

/// factor A + pressure I.
template <class T>
Symmetric<T> combined(const Symmetric<T>& A, const T& factor, const T& pressure) {
  return {factor * A[0] + pressure, factor * A[1] + pressure, factor * A[2], factor * A[3] + pressure};
}

/// F11 F22 - F12 F21.
template <class T>
T plane_determinant(const Gradient<T>& F) {
  return F[0] * F[3] - F[1] * F[2];
}

/// I + A of a tensor given as A, and back: a small strain keeps in A the digits that I + A rounds away.
template <class T>
Gradient<T> with_unit(Gradient<T> H) {
  for (int i : {0, 3, 4}) H[i] = H[i] + 1.0;
  return H;
}
template <class T>
Gradient<T> without_unit(Gradient<T> F) {
  for (int i : {0, 3, 4}) F[i] = F[i] - 1.0;
  return F;
}

/// det F - 1 of F = I + H, in the plane and of the whole.
template <class T>
T plane_dilation(const Gradient<T>& H) {
  return H[0] + H[3] + plane_determinant(H);
}
template <class T>
T dilation(const Gradient<T>& H) {
  const T plane = plane_dilation(H);
  return plane + H[4] + plane * H[4];
}

/// F A F^T, for a symmetric A.
template <class T, class S>
Symmetric<T> pushed(const Gradient<T>& F, const Symmetric<S>& A) {
  const T a = F[0] * A[0] + F[1] * A[2], b = F[0] * A[2] + F[1] * A[1];
  const T c = F[2] * A[0] + F[3] * A[2], d = F[2] * A[2] + F[3] * A[1];
  return {a * F[0] + b * F[1], c * F[2] + d * F[3], a * F[2] + b * F[3], F[4] * F[4] * A[3]};
}

/// F F^T - I = H + H^T + H H^T of F = I + H.
template <class T>
Symmetric<T> stretched(const Gradient<T>& H) {
  return {2.0 * H[0] + H[0] * H[0] + H[1] * H[1], 2.0 * H[3] + H[2] * H[2] + H[3] * H[3],
          H[1] + H[2] + H[0] * H[2] + H[1] * H[3], 2.0 * H[4] + H[4] * H[4]};
}

inline Gradient<double> inverse(const Gradient<double>& F) {
  const double f = 1.0 / plane_determinant(F);
  return {F[3] * f, -F[1] * f, -F[2] * f, F[0] * f, 1.0 / F[4]};
}

/// f(x) of a scalar x whose value and derivative at value(x) are known.
template <class T>
T known_function(const T& x, double value, double slope) {
  if constexpr (std::is_same_v<T, double>)
    return value;
  else
    return (x - base::value(x)) * slope + value;
}

/// atanh(r) / r = sum r^2k / (2 k + 1) as a function of u = 1 - r^2, 0 < u <= 1: analytic where the eigenvalues are
/// equal (u = 1), and not cancelling where they are far apart (u near 0).
template <class T>
T atanh_ratio(const T& u) {
  const double v = base::value(u), t = 1.0 - v;
  double ratio = 0.0, slope = 0.0;  // slope in t
  if (t < 0.03) {
    for (int k = t < 1e-4 ? 4 : 11; k >= 0; --k) {
      slope = slope * t + ratio;
      ratio = ratio * t + 1.0 / (2 * k + 1);
    }
  } else {
    ratio = (std::log1p(std::sqrt(t)) - 0.5 * std::log(v)) / std::sqrt(t);
    slope = (1.0 / v - ratio) / (2.0 * t);
  }
  return known_function(u, ratio, -slope);
}

/// (1 + q)^(1/3) - 1 to the digits of q, q > -1.
template <class T>
T cube_root_beyond_unit(const T& q) {
  const double v = base::value(q);
  const auto slope_at = [](double root) { return 1.0 / (3.0 * (1.0 + root) * (1.0 + root)); };
  double root = v / (3.0 + v);
  if (std::abs(v) < 0.1)
    for (int newton = 0; newton < 2; ++newton) root -= (root * (3.0 + root * (3.0 + root)) - v) * slope_at(root);
  else
    root = std::expm1(std::log1p(v) / 3.0);
  return known_function(q, root, slope_at(root));
}

/// ln A of a positive definite A. In the plane, with A = m I + D, tr D = 0, r^2 = -det D, no eigenvectors are needed:
/// ln A = 1/2 ln(m^2 - r^2) I + atanh(r / m) / r D.      (7)
template <class T>
Symmetric<T> logarithm(const Symmetric<T>& A) {
  using std::log;
  const T m = (A[0] + A[1]) * 0.5, d = (A[0] - A[1]) * 0.5, det = A[0] * A[1] - A[2] * A[2];
  const T ratio = atanh_ratio(T(det / (m * m))) / m, mean = log(det) * 0.5;
  return {mean + ratio * d, mean - ratio * d, ratio * A[2], log(A[3])};
}

/// ln(I + A), to the digits of A.
template <class T>
Symmetric<T> logarithm_beyond_unit(const Symmetric<T>& A) {
  using std::log1p;
  const T m = (A[0] + A[1]) * 0.5, d = (A[0] - A[1]) * 0.5, rise = 2.0 * m + (A[0] * A[1] - A[2] * A[2]), M = m + 1.0;
  const T ratio = atanh_ratio(T((rise + 1.0) / (M * M))) / M, mean = log1p(rise) * 0.5;
  return {mean + ratio * d, mean - ratio * d, ratio * A[2], log1p(A[3])};
}

/// exp A = e^m (cosh r I + sinh r / r D) in the plane, as above. Both are series of r^2.
inline Symmetric<double> exponential(const Symmetric<double>& A) {
  const double m = std::exp(0.5 * (A[0] + A[1])), d = 0.5 * (A[0] - A[1]), square = d * d + A[2] * A[2];
  double cosh = 0.0, ratio = 0.0;
  if (square < 0.1) {
    for (int k = 7; k > 0; --k) {
      cosh = (cosh + 1.0) * square / ((2 * k - 1) * (2 * k));
      ratio = (ratio + 1.0) * square / ((2 * k) * (2 * k + 1));
    }
    cosh = m * (cosh + 1.0);
    ratio = m * (ratio + 1.0);
  } else {
    const double r = std::sqrt(square);
    cosh = m * std::cosh(r);
    ratio = m * std::sinh(r) / r;
  }
  return {cosh + ratio * d, cosh - ratio * d, ratio * A[2], std::exp(A[3])};
}

inline Symmetric<double> scaled(Symmetric<double> A, double factor) {
  for (double& a : A) a *= factor;
  return A;
}

}  // namespace reye::material
