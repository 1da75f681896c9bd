#pragma once
#include <algorithm>
#include <utility>

#include "mortar/facet.hpp"

/// Functions that carry the multipliers of a facet.
namespace reye::mortar {

template <class T>
using Square = std::array<std::array<T, 3>, 3>;

/// psi_j = sum_k A_jk P_k, zero for cut nodes; P: the hats of a facet of two nodes, else Legendre polynomials over the
/// covered part of the facet.
template <class T>
struct DualBasis {
  Square<T> A{};
  double middle = 0.0, half = 1.0;  ///< the covered part in xi; it shapes the polynomials, not the space they span
};

/// A = D M^-1; beside a cut node the remaining one carries psi = 1.   (5)
template <class T>
DualBasis<T> dual_basis_of_two(const FacetInput<T>& in, const std::vector<Quadrature<T>>& points) {
  DualBasis<T> basis;
  auto& A = basis.A;
  const auto& cut = in.cut;
  T d0{}, d1{}, m00{}, m01{}, m11{};
  for (const auto& q : points) {
    d0 += q.weight * q.N[0];
    d1 += q.weight * q.N[1];
    m00 += q.weight * q.N[0] * q.N[0];
    m01 += q.weight * q.N[0] * q.N[1];
    m11 += q.weight * q.N[1] * q.N[1];
  }
  if (cut[0] || cut[1]) {
    if (!cut[0]) A[0] = {T(1.0), T(1.0), T(0.0)};
    if (!cut[1]) A[1] = {T(1.0), T(1.0), T(0.0)};
    return basis;
  }
  const T det = 1.0 / (m00 * m11 - m01 * m01);
  A[0] = {d0 * m11 * det, -1.0 * (d0 * m01 * det), T(0.0)};
  A[1] = {-1.0 * (d1 * m01 * det), d1 * m00 * det, T(0.0)};
  return basis;
}

template <class T>
std::array<T, 3> legendre(const DualBasis<T>& basis, const T& xi) {
  const T eta = (xi - basis.middle) * (1.0 / basis.half);
  return {T(1.0), eta, eta * eta - 1.0 / 3.0};
}

/// Inverse of the leading n x n part, by elimination with row pivots.
template <class T>
Square<T> inverted(Square<T> G, int n) {
  Square<T> inverse{};
  for (int i = 0; i < n; ++i) inverse[i][i] = T(1.0);
  for (int c = 0; c < n; ++c) {
    int pivot = c;
    for (int r = c + 1; r < n; ++r)
      if (std::abs(value(G[r][c])) > std::abs(value(G[pivot][c]))) pivot = r;
    std::swap(G[c], G[pivot]);
    std::swap(inverse[c], inverse[pivot]);
    const T scale = 1.0 / G[c][c];
    for (int k = 0; k < n; ++k) {
      G[c][k] *= scale;
      inverse[c][k] *= scale;
    }
    for (int r = 0; r < n; ++r) {
      if (r == c) continue;
      const T factor = G[r][c];
      for (int k = 0; k < n; ++k) {
        G[r][k] -= factor * G[c][k];
        inverse[r][k] -= factor * inverse[c][k];
      }
    }
  }
  return inverse;
}

/// The n nodes that carry multipliers get n functions that span the polynomials of degree n - 1:
/// A = D G^-1, G_lk = int P_l N_k. P over the covered part keeps cond G ~ (covered share)^-2, not ^-4.   (5)
template <class T>
DualBasis<T> dual_basis_of_three(const FacetInput<T>& in, const std::vector<Quadrature<T>>& points) {
  DualBasis<T> basis;
  std::array<int, 3> kept{};
  int n = 0;
  for (int j = 0; j < 3; ++j)
    if (!in.cut[j]) kept[n++] = j;
  double lo = 1.0, hi = -1.0;
  for (const auto& q : points) {
    lo = std::min(lo, value(q.xi));
    hi = std::max(hi, value(q.xi));
  }
  basis.middle = 0.5 * (lo + hi);
  basis.half = 0.5 * (hi - lo);
  Square<T> G{};
  std::array<T, 3> own{};
  for (const auto& q : points) {
    const auto P = legendre(basis, q.xi);
    for (int i = 0; i < n; ++i) {
      const T weighted = q.weight * q.N[kept[i]];
      own[i] += weighted;
      for (int l = 0; l < n; ++l) G[l][i] += P[l] * weighted;
    }
  }
  const auto inverse = inverted(G, n);
  for (int i = 0; i < n; ++i)
    for (int l = 0; l < n; ++l) basis.A[kept[i]][l] = own[i] * inverse[i][l];
  return basis;
}

template <class T>
DualBasis<T> dual_basis(const FacetInput<T>& in, const std::vector<Quadrature<T>>& points) {
  if (points.empty()) return {};
  return in.count() == 2 ? dual_basis_of_two(in, points) : dual_basis_of_three(in, points);
}

/// psi_j at a quadrature point.
template <class T>
std::array<T, 3> dual_functions(const FacetInput<T>& in, const DualBasis<T>& basis, const Quadrature<T>& q) {
  std::array<T, 3> psi{};
  if (in.count() == 2) {
    for (int j = 0; j < 2; ++j) psi[j] = basis.A[j][0] * q.N[0] + basis.A[j][1] * q.N[1];
    return psi;
  }
  const auto P = legendre(basis, q.xi);
  for (int j = 0; j < 3; ++j) psi[j] = basis.A[j][0] * P[0] + basis.A[j][1] * P[1] + basis.A[j][2] * P[2];
  return psi;
}

}  // namespace reye::mortar
