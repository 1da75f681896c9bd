#pragma once
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "base/dual.hpp"
#include "mortar/surface.hpp"

/// The mortar integrals of one secondary facet, once, for any scalar: double gives values, base::Dual the
/// exact derivatives. Numbers in brackets refer to the room's README.
namespace reye::mortar {

using base::value;

/// A pair of scalars in the plane.
template <class T>
struct Pair {
  T x{}, y{};
  friend Pair operator+(const Pair& a, const Pair& b) { return {a.x + b.x, a.y + b.y}; }
  friend Pair operator-(const Pair& a, const Pair& b) { return {a.x - b.x, a.y - b.y}; }
  template <class S>
  friend Pair operator*(const Pair& a, const S& s) { return {a.x * s, a.y * s}; }
};

template <class T>
T dot(const Pair<T>& a, const Pair<T>& b) { return a.x * b.x + a.y * b.y; }
template <class T>
T cross(const Pair<T>& a, const Pair<T>& b) { return a.x * b.y - a.y * b.x; }
inline Vec2 plain(const Pair<double>& a) { return {a.x, a.y}; }

/// Outward unit normal of the facet a -> b, body on the left.   (1)
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

/// Where a secondary facet and the primary facets opposite it are. Local primary nodes are numbered 0.. in
/// `xm`; `pairs` are primary facets in these numbers.
template <class T>
struct FacetInput {
  std::array<Pair<T>, 2> x, n;                ///< positions and nodal normals of the facet's nodes
  std::array<Vec2, 2> X, x_before;            ///< on X; at the start of the increment
  std::array<bool, 2> cut{false, false};      ///< the node carries no multiplier (held by a support)
  std::vector<Pair<T>> xm;
  std::vector<Vec2> xm_before;
  std::vector<std::array<int, 2>> pairs;
  Analysis analysis = Analysis::plane_strain;
  double search = 0.0;                        ///< pairs farther apart than this do not meet
};

/// The integrals per node j = 0, 1 of the facet, over its covered part on the measure of X.
template <class T>
struct FacetIntegrals {
  std::array<T, 2> D{};                 ///< int psi_j N_j = int N_j
  std::array<T, 2> off{};               ///< int psi_j N_k of the other node k: zero unless that one is cut
  std::array<T, 2> gap{};               ///< int psi_j g
  std::array<Pair<T>, 2> offset{};      ///< int psi_j (x_s - x_m), from D and M about x_j
  std::array<Pair<T>, 2> drift{};       ///< int psi_j (dx_s - dx_m), dx since the start of the increment
  std::array<std::vector<T>, 2> M;      ///< int psi_j N_l, per local primary node
  std::array<std::vector<T>, 2> cover;  ///< int N_j N_l (T_jl)
};

/// One quadrature point of a segment.
template <class T>
struct Quadrature {
  std::array<T, 2> N;   ///< secondary shape functions
  T s{}, gap{}, weight{};  ///< primary coordinate in [0, 1] from node a to b, gap along the normal, weight
  int pair = 0;
};

template <class T>
struct Workspace {
  FacetInput<T> in;
  FacetIntegrals<T> out;
  std::vector<Quadrature<T>> points;
};

/// Coordinate on the secondary facet of the image of point p along the normal field, clipped to [-1, 1]:
/// the root of cross(n(xi), p - x(xi)) = c0 + c1 xi + c2 xi^2, known to be inside when the signs at the ends
/// differ. Found in double; one Newton step in T adds its derivative.   (3)
template <class T>
T image(const FacetInput<T>& in, const Pair<T>& p) {
  const Pair<T> nm = (in.n[0] + in.n[1]) * 0.5, nd = (in.n[1] - in.n[0]) * 0.5;
  const Pair<T> r = p - (in.x[0] + in.x[1]) * 0.5, xd = (in.x[1] - in.x[0]) * 0.5;
  const T c0 = cross(nm, r), c1 = cross(nd, r) - cross(nm, xd), c2 = -1.0 * cross(nd, xd);
  const double a = value(c0), b = value(c1), c = value(c2);
  if (a - b + c <= 0.0) return T(-1.0);
  if (a + b + c >= 0.0) return T(1.0);
  const double q = -0.5 * (b + std::copysign(std::sqrt(std::max(0.0, b * b - 4.0 * a * c)), b));
  double xi = a / q;
  if (std::abs(xi) > 1.0 && c != 0.0) xi = q / c;
  return xi - (c0 + c1 * xi + c2 * xi * xi) / (b + 2.0 * c * xi);
}

/// Projects the secondary point at xi along the normal onto primary facet `pair`.   (4)
template <class T>
Quadrature<T> project(const FacetInput<T>& in, int pair, const T& xi) {
  Quadrature<T> q;
  q.pair = pair;
  q.N = {0.5 * (1.0 - xi), 0.5 * (1.0 + xi)};
  const Pair<T> x = in.x[0] * q.N[0] + in.x[1] * q.N[1], n = in.n[0] * q.N[0] + in.n[1] * q.N[1];
  const Pair<T> a = in.xm[in.pairs[pair][0]], edge = in.xm[in.pairs[pair][1]] - a;
  q.s = cross(n, x - a) / cross(n, edge);
  q.gap = dot(n, a + edge * q.s - x);
  return q;
}

/// True when the two facets face each other: n_s . n_m < -0.1.
template <class T>
bool facing(const FacetInput<T>& in, int pair) {
  const auto& [a, b] = in.pairs[pair];
  const double tx = value(in.x[1].x) - value(in.x[0].x), ty = value(in.x[1].y) - value(in.x[0].y);
  const double mx = value(in.xm[b].x) - value(in.xm[a].x), my = value(in.xm[b].y) - value(in.xm[a].y);
  return tx * mx + ty * my < -0.1 * std::sqrt((tx * tx + ty * ty) * (mx * mx + my * my));
}

/// A facet covered by less than this share has no usable dual basis and takes no part at all: neither in D and M
/// nor where wear is spread (its T_jl would remove volume that no work of D_jj pays for).
constexpr double least_cover = 1e-3;

/// Share of the facet that its quadrature points cover.
template <class T>
double covered(const Workspace<T>& w) {
  double sum = 0.0;
  for (const auto& q : w.points) sum += value(q.weight);
  const double r = 0.5 * (w.in.X[0].x() + w.in.X[1].x());
  return sum / ((w.in.X[1] - w.in.X[0]).norm() * base::out_of_plane(w.in.analysis, r));
}

/// The quadrature points of all segments. A primary facet runs against the secondary one, so its second
/// node comes first; neighbouring facets share the image of their common node: no gap, no overlap.
template <class T>
void place_points(Workspace<T>& w) {
  constexpr double third = 0.7745966692414834;  // sqrt(3/5): three-point Gauss
  constexpr std::array<double, 3> eta{-third, 0.0, third}, weight{5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
  const auto& in = w.in;
  w.points.clear();
  const double half = 0.5 * (in.X[1] - in.X[0]).norm();
  for (int pair = 0; pair < static_cast<int>(in.pairs.size()); ++pair) {
    if (!facing(in, pair)) continue;
    const T lo = image(in, in.xm[in.pairs[pair][1]]), hi = image(in, in.xm[in.pairs[pair][0]]);
    if (value(hi) - value(lo) < 1e-12) continue;
    const auto middle = project(in, pair, T(0.5 * (lo + hi)));
    if (std::abs(value(middle.gap)) > in.search) continue;
    for (int g = 0; g < 3; ++g) {
      const T xi = 0.5 * (1.0 - eta[g]) * lo + 0.5 * (1.0 + eta[g]) * hi;
      auto q = project(in, pair, xi);
      const T r = in.X[0].x() * q.N[0] + in.X[1].x() * q.N[1];
      q.weight = base::out_of_plane(in.analysis, r) * (0.5 * half * weight[g]) * (hi - lo);
      w.points.push_back(std::move(q));
    }
  }
  if (covered(w) < least_cover) w.points.clear();
}

/// Coefficients A of psi_j = sum_k A_jk N_k, biorthogonal on the covered part: A = D M^-1; beside a cut
/// node the remaining one carries psi = 1.   (5)
template <class T>
std::array<std::array<T, 2>, 2> dual_basis(const Workspace<T>& w) {
  std::array<std::array<T, 2>, 2> A{};
  if (w.points.empty()) return A;
  const auto& cut = w.in.cut;
  T d0{}, d1{}, m00{}, m01{}, m11{};
  for (const auto& q : w.points) {
    d0 += q.weight * q.N[0];
    d1 += q.weight * q.N[1];
    m00 += q.weight * q.N[0] * q.N[0];
    m01 += q.weight * q.N[0] * q.N[1];
    m11 += q.weight * q.N[1] * q.N[1];
  }
  if (cut[0] || cut[1]) {
    if (!cut[0]) A[0] = {T(1.0), T(1.0)};
    if (!cut[1]) A[1] = {T(1.0), T(1.0)};
    return A;
  }
  const T det = 1.0 / (m00 * m11 - m01 * m01);
  A[0] = {d0 * m11 * det, -1.0 * (d0 * m01 * det)};
  A[1] = {-1.0 * (d1 * m01 * det), d1 * m00 * det};
  return A;
}

/// offset and drift of node j from its mortar row, each about the node's own position so that nothing cancels.   (6)
template <class T>
void relative_motion(Workspace<T>& w, int j) {
  const auto& in = w.in;
  auto& out = w.out;
  const int k = 1 - j;
  const auto moved = [](const Pair<T>& x, const Vec2& before) { return Pair<T>{x.x - before.x(), x.y - before.y()}; };
  const Pair<T> dx = moved(in.x[j], in.x_before[j]);
  out.offset[j] = (in.x[k] - in.x[j]) * out.off[j];
  out.drift[j] = (moved(in.x[k], in.x_before[k]) - dx) * out.off[j];
  for (std::size_t l = 0; l < in.xm.size(); ++l) {
    out.offset[j] = out.offset[j] + (in.x[j] - in.xm[l]) * out.M[j][l];
    out.drift[j] = out.drift[j] + (dx - moved(in.xm[l], in.xm_before[l])) * out.M[j][l];
  }
}

/// All integrals of the facet described by w.in, into w.out.
template <class T>
void integrate(Workspace<T>& w) {
  auto& out = w.out;
  const std::size_t primaries = w.in.xm.size();
  place_points(w);
  const auto A = dual_basis(w);
  for (int j = 0; j < 2; ++j) {
    out.D[j] = out.off[j] = out.gap[j] = T(0.0);
    out.M[j].assign(primaries, T(0.0));
    out.cover[j].assign(primaries, T(0.0));
    for (const auto& q : w.points) {
      const T psi = (A[j][0] * q.N[0] + A[j][1] * q.N[1]) * q.weight, weighted = q.weight * q.N[j];
      const auto& [a, b] = w.in.pairs[q.pair];
      const T Na = 1.0 - q.s;
      out.D[j] += psi;
      if (w.in.cut[1 - j]) out.off[j] += psi * q.N[1 - j];
      out.gap[j] += psi * q.gap;
      out.M[j][a] += psi * Na;
      out.M[j][b] += psi * q.s;
      out.cover[j][a] += weighted * Na;
      out.cover[j][b] += weighted * q.s;
    }
    out.D[j] -= out.off[j];  // row sums of M by construction: forces balance to round-off
    relative_motion(w, j);
  }
}

}  // namespace reye::mortar
