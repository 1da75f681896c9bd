#pragma once
#include "mortar/dual_basis.hpp"
#include "mortar/projection.hpp"

/// The mortar integrals of one secondary facet, for any scalar. Numbers in brackets refer to the room's README.
namespace reye::mortar {

/// The integrals per node j of the facet, over its covered part.
template <class T>
struct FacetIntegrals {
  std::array<T, 3> D{};                 ///< int psi_j N_j = int N_j
  Square<T> off{};                      ///< int psi_j N_k: zero unless node k is cut
  std::array<T, 3> gap{};               ///< int psi_j g
  std::array<Pair<T>, 3> offset{};      ///< int psi_j (x_s - x_m), from D and M about x_j
  std::array<Pair<T>, 3> drift{};       ///< int psi_j (dx_s - dx_m), dx since the start of the increment
  std::array<std::vector<T>, 3> M;      ///< int psi_j N_l, per local primary node
  std::array<std::vector<T>, 3> cover;  ///< int W_j N_l (T_jl)
  std::array<double, 3> on_X{};         ///< int N_j over length on X, whatever the measure
};

template <class T>
struct Workspace {
  FacetInput<T> in;
  FacetIntegrals<T> out;
  std::vector<Quadrature<T>> points;
};

/// A facet covered by less than this share has no usable dual basis and takes no part at all: neither in D and M nor
/// where wear is spread (its T_jl would remove volume without work in D_jj).
constexpr double least_cover = 1e-3;

/// factor * |dp/dxi|, times 2 pi r in axisymmetry, of the facet with nodes p, given on X or on x.
template <class T, class S>
T length_element(const FacetInput<T>& in, const std::array<Pair<S>, 3>& p, const Quadrature<T>& q, double factor) {
  using std::sqrt;
  T r = p[0].x * q.N[0] + p[1].x * q.N[1];
  if (in.kind == LineKind::line2) {
    const Pair<S> t = (p[1] - p[0]) * 0.5;
    return base::out_of_plane(in.analysis, r) * (sqrt(dot(t, t)) * factor);
  }
  r += p[2].x * q.N[2];
  const auto d = mesh::facet_slopes(LineKind::line3, q.xi);
  const Pair<T> t{p[0].x * d[0] + p[1].x * d[1] + p[2].x * d[2], p[0].y * d[0] + p[1].y * d[1] + p[2].y * d[2]};
  return base::out_of_plane(in.analysis, r) * (sqrt(dot(t, t)) * factor);
}

/// The points of one segment [lo, hi] by a rule on [-1, 1].
template <class T, std::size_t n>
void place_segment(Workspace<T>& w, int pair, const T& lo, const T& hi, const std::array<mesh::RulePoint, n>& rule) {
  const auto& in = w.in;
  for (const auto& [at, weight] : rule) {
    const T xi = 0.5 * (1.0 - at) * lo + 0.5 * (1.0 + at) * hi;
    auto q = project(in, pair, xi);
    q.weight = length_element(in, in.X, q, 0.5 * weight) * (hi - lo);
    q.weight_on_X = value(q.weight);
    if (in.measure == Kinematics::finite) q.weight = length_element(in, in.x, q, 0.5 * weight) * (hi - lo);
    w.points.push_back(std::move(q));
  }
}

/// The quadrature points of all segments. A primary facet runs against the secondary one, so its second
/// node comes first; neighbouring facets share the image of their common node: no gap, no overlap.
template <class T>
void place_points(Workspace<T>& w) {
  const auto& in = w.in;
  w.points.clear();
  double covered = 0.0;
  for (int pair = 0; pair < static_cast<int>(in.pairs.size()); ++pair) {
    if (!facing(in, pair)) continue;
    const T lo = image(in, in.xm[in.pairs[pair][1]]), hi = image(in, in.xm[in.pairs[pair][0]]);
    if (value(hi) - value(lo) < 1e-12) continue;
    const auto middle = project(in, pair, T(0.5 * (lo + hi)));
    if (std::abs(value(middle.gap)) > in.search) continue;
    if (in.kind == LineKind::line2 && in.pairs[pair][2] < 0)
      place_segment(w, pair, lo, hi, mesh::gauss3);
    else
      place_segment(w, pair, lo, hi, mesh::gauss5);
    covered += 0.5 * (value(hi) - value(lo));
  }
  if (covered < least_cover) w.points.clear();
}

/// offset and drift of node j from its mortar row, each about the node's own position so that nothing cancels.   (6)
template <class T>
void relative_motion(Workspace<T>& w, int j) {
  const auto& in = w.in;
  auto& out = w.out;
  const auto moved = [](const Pair<T>& x, const Pair<double>& before) {
    return Pair<T>{x.x - before.x, x.y - before.y};
  };
  const Pair<T> dx = moved(in.x[j], in.x_before[j]);
  out.offset[j] = out.drift[j] = {};
  for (int k = 0; k < in.count(); ++k) {
    if (k == j || !in.cut[k]) continue;
    out.offset[j] = out.offset[j] + (in.x[k] - in.x[j]) * out.off[j][k];
    out.drift[j] = out.drift[j] + (moved(in.x[k], in.x_before[k]) - dx) * out.off[j][k];
  }
  for (std::size_t l = 0; l < in.xm.size(); ++l) {
    out.offset[j] = out.offset[j] + (in.x[j] - in.xm[l]) * out.M[j][l];
    out.drift[j] = out.drift[j] + (dx - moved(in.xm[l], in.xm_before[l])) * out.M[j][l];
  }
}

template <class T>
void clear(FacetIntegrals<T>& out, int count, std::size_t primaries) {
  for (int j = 0; j < count; ++j) {
    out.D[j] = out.gap[j] = T(0.0);
    out.off[j] = {};
    out.on_X[j] = 0.0;
    out.M[j].assign(primaries, T(0.0));
    out.cover[j].assign(primaries, T(0.0));
  }
}

/// Weight by which node j spreads the primary's wear: N_j, and half of N of a control point that has no multiplier.
template <class T>
T spreading_weight(const FacetInput<T>& in, const Quadrature<T>& q, int j) {
  return in.kind == LineKind::line3 && in.cut[2] ? q.N[j] + 0.5 * q.N[2] : q.N[j];
}

/// All integrals of the facet described by w.in, into w.out.
template <class T>
void integrate(Workspace<T>& w) {
  const auto& in = w.in;
  auto& out = w.out;
  place_points(w);
  const auto basis = dual_basis(in, w.points);
  clear(out, in.count(), in.xm.size());
  for (const auto& q : w.points) {
    const auto& [a, b, c] = in.pairs[q.pair];
    const auto psi = dual_functions(in, basis, q);
    for (int j = 0; j < in.count(); ++j) {
      const T carried = psi[j] * q.weight, spread = q.weight * spreading_weight(in, q, j);
      out.on_X[j] += q.weight_on_X * value(q.N[j]);
      out.D[j] += carried;
      for (int k = 0; k < in.count(); ++k)
        if (in.cut[k] && k != j) out.off[j][k] += carried * q.N[k];
      out.gap[j] += carried * q.gap;
      const auto add = [&](int node, const T& Nm) {
        out.M[j][node] += carried * Nm;
        out.cover[j][node] += spread * Nm;
      };
      add(a, q.Nm[0]);
      add(b, q.Nm[1]);
      if (c >= 0) add(c, q.Nm[2]);
    }
  }
  for (int j = 0; j < in.count(); ++j) {
    for (int k = 0; k < in.count(); ++k) out.D[j] -= out.off[j][k];  // row sums of M: forces balance to round-off
    relative_motion(w, j);
  }
}

}  // namespace reye::mortar
