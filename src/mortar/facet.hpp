#pragma once
#include <array>
#include <cmath>
#include <vector>

#include "base/dual.hpp"
#include "mortar/surface.hpp"

/// One secondary facet with the primary facets opposite, for any scalar: double gives values, base::Dual exact
/// derivatives. Numbers in brackets refer to the room's README.
namespace reye::mortar {

using base::Kinematics;
using base::value;
using mesh::LineKind;

/// A pair of scalars in the plane.
template <class T>
struct Pair {
  T x{}, y{};
  friend Pair operator+(const Pair& a, const Pair& b) { return {a.x + b.x, a.y + b.y}; }
  friend Pair operator-(const Pair& a, const Pair& b) { return {a.x - b.x, a.y - b.y}; }
  template <class S>
  friend Pair operator*(const Pair& a, const S& s) {
    return {a.x * s, a.y * s};
  }
};

template <class T>
T dot(const Pair<T>& a, const Pair<T>& b) {
  return a.x * b.x + a.y * b.y;
}
template <class T>
T cross(const Pair<T>& a, const Pair<T>& b) {
  return a.x * b.y - a.y * b.x;
}
inline Vec2 plain(const Pair<double>& a) { return {a.x, a.y}; }

/// Outward unit normal of the line a -> b, body on the left.   (1)
template <class T>
Pair<T> facet_normal(const Pair<T>& a, const Pair<T>& b) {
  using std::sqrt;
  const Pair<T> t = b - a;
  const T scale = 1.0 / sqrt(dot(t, t));
  return {t.y * scale, -t.x * scale};
}

/// Averaged unit normal of a node from the normals of its two facets.   (2)
template <class T>
Pair<T> averaged(const Pair<T>& n1, const Pair<T>& n2) {
  using std::sqrt;
  const Pair<T> n = n1 + n2;
  return n * (1.0 / sqrt(dot(n, n)));
}

/// The positions of a secondary facet and of the primary facets opposite it. Local primary nodes are numbered 0.. in
/// `xm`; `pairs` are primary facets in these numbers.
template <class T>
struct FacetInput {
  LineKind kind = LineKind::line2;          ///< of a curve the control point comes last
  std::array<Pair<T>, 3> x, n;              ///< positions, and the normal field: n(xi) = sum N_j n_j
  std::array<Pair<double>, 3> X, x_before;  ///< on X; at the start of the increment
  std::array<bool, 3> cut{};                ///< the node carries no multiplier
  std::vector<Pair<T>> xm;
  std::vector<Pair<double>> xm_before;
  std::vector<LineFacet> pairs;
  Analysis analysis = Analysis::plane_strain;
  Kinematics measure = Kinematics::small;  ///< integrals over length on X (small) or on x (finite)
  double search = 0.0;                     ///< pairs farther apart than this do not meet

  int count() const { return mesh::node_count(kind); }
};

/// One quadrature point of a segment.
template <class T>
struct Quadrature {
  T xi{};
  std::array<T, 3> N{}, Nm{};  ///< shape functions of the secondary facet and of the primary one
  T gap{}, weight{};           ///< gap along the normal
  double weight_on_X = 0.0;
  int pair = 0;
};

/// sum N_j p_j over the nodes of a facet.
template <class T, class S>
Pair<T> combined(int count, const std::array<Pair<T>, 3>& p, const std::array<S, 3>& N) {
  const Pair<T> sum = p[0] * N[0] + p[1] * N[1];
  return count == 2 ? sum : sum + p[2] * N[2];
}

}  // namespace reye::mortar
