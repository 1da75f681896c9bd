#include "mortar/solid/multipliers.hpp"

#include <Eigen/LU>
#include <cmath>
#include <span>

#include "base/errors.hpp"

namespace reye::mortar {

namespace {

using mesh::FacetKind;

constexpr int most = mesh::most_facet_nodes;
/// Of at most six rows and columns, without memory of its own.
using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, most, most>;

/// Takes what P_0 .. P_(l-1) have in P_l out of it, and scales it to a mean square of one.
void make_orthonormal(std::vector<SkinPoint>& points, int l) {
  for (int k = 0; k < l; ++k) {
    double common = 0.0;
    for (const auto& q : points) common += q.weight * q.P[l] * q.P[k];
    for (auto& q : points) q.P[l] -= common * q.P[k];
  }
  double square = 0.0;
  for (const auto& q : points) square += q.weight * q.P[l] * q.P[l];
  const double scale = 1.0 / std::sqrt(square);
  for (auto& q : points) q.P[l] *= scale;
}

/// The other points of a facet in tiers, the nearest first; a tier ends at -1.
std::span<const int> tiers(FacetKind kind, int j) {
  static constexpr std::array<std::array<int, 3>, 3> tri3{{{1, 2, -1}, {0, 2, -1}, {0, 1, -1}}};
  static constexpr std::array<std::array<int, 5>, 4> quad4{
      {{1, 3, -1, 2, -1}, {0, 2, -1, 3, -1}, {1, 3, -1, 0, -1}, {0, 2, -1, 1, -1}}};
  static constexpr std::array<std::array<int, 8>, 6> tri6{{{3, 5, -1, 1, 2, -1, 4, -1},
                                                           {3, 4, -1, 0, 2, -1, 5, -1},
                                                           {4, 5, -1, 0, 1, -1, 3, -1},
                                                           {0, 1, -1, 4, 5, -1, 2, -1},
                                                           {1, 2, -1, 3, 5, -1, 0, -1},
                                                           {2, 0, -1, 3, 4, -1, 1, -1}}};
  if (kind == FacetKind::tri3) return tri3[j];
  return kind == FacetKind::quad4 ? std::span<const int>(quad4[j]) : std::span<const int>(tri6[j]);
}

/// Spreads N_k of a cut point evenly over the first tier with points that are not cut.
void spread(FacetKind kind, const FacetCut& cut, int k, Multipliers& m) {
  std::array<int, 3> heirs{};
  std::size_t count = 0;
  for (int j : tiers(kind, k)) {
    if (j >= 0 && !cut[j]) heirs[count++] = j;
    if (j < 0 && count > 0) break;
  }
  for (std::size_t i = 0; i < count; ++i) m.share[heirs[i]][k] = 1.0 / static_cast<double>(count);
}

/// G_kl = int N_k P_l.
Small moments(int count, const std::vector<SkinPoint>& points) {
  Small G = Small::Zero(count, count);
  for (const auto& q : points)
    for (int l = 0; l < count; ++l) {
      const double weighted = q.weight * q.P[l];
      for (int k = 0; k < count; ++k) G(k, l) += weighted * q.N[k];
    }
  return G;
}

/// Rows: orthonormal combinations of P that span the functions sum_k share_jk N_k of the points that are kept.
Small kept_space(const Small& G, const Multipliers& m, std::span<const int> kept) {
  Small functions = Small::Zero(G.cols(), static_cast<Eigen::Index>(kept.size()));
  for (std::size_t i = 0; i < kept.size(); ++i)
    for (Eigen::Index k = 0; k < G.rows(); ++k)
      functions.col(static_cast<Eigen::Index>(i)) += m.share[kept[i]][k] * G.row(k).transpose();
  for (Eigen::Index i = 0; i < functions.cols(); ++i) {
    auto own = functions.col(i);
    for (int pass = 0; pass < 2; ++pass)  // the second takes out what round-off left of the first
      for (Eigen::Index k = 0; k < i; ++k) own -= functions.col(k).dot(own) * functions.col(k);
    own.normalize();
  }
  return functions.transpose();
}

}  // namespace

void orthonormalise(FacetKind kind, std::vector<SkinPoint>& points) {
  double area = 0.0;
  Vec2 middle = Vec2::Zero();
  for (const auto& q : points) {
    area += q.weight;
    middle += q.weight * q.xi;
  }
  middle /= area;
  const double constant = 1.0 / std::sqrt(area);
  for (auto& q : points) {
    q.P[0] = constant;
    q.P[1] = q.xi.x() - middle.x();
    q.P[2] = q.xi.y() - middle.y();
    q.P[3] = q.P[1] * q.P[2];
  }
  make_orthonormal(points, 1);
  make_orthonormal(points, 2);
  if (kind == FacetKind::quad4) make_orthonormal(points, 3);
  if (kind != FacetKind::tri6) return;
  for (auto& q : points) {  // of the linear ones, in whose coordinates the covered part is neither long nor narrow
    q.P[3] = q.P[1] * q.P[1];
    q.P[4] = q.P[1] * q.P[2];
    q.P[5] = q.P[2] * q.P[2];
  }
  for (int l = 3; l < 6; ++l) make_orthonormal(points, l);
}

Multipliers multipliers(FacetKind kind, const FacetCut& cut, const std::vector<SkinPoint>& points) {
  Multipliers m;
  const int count = mesh::facet_nodes(kind);
  std::array<int, most> kept{};
  std::size_t n = 0;
  for (int j = 0; j < count; ++j) {
    if (!cut[j]) m.share[j][j] = 1.0, kept[n++] = j;
    if (cut[j]) spread(kind, cut, j, m);
  }
  if (n == 0) return m;
  const Small G = moments(count, points);
  const bool whole = n == static_cast<std::size_t>(count);
  const Small C = whole ? Small(Small::Identity(count, count)) : kept_space(G, m, std::span(kept).first(n));
  Small reduced(static_cast<Eigen::Index>(n), count);
  for (std::size_t i = 0; i < n; ++i) reduced.row(static_cast<Eigen::Index>(i)) = G.row(kept[i]);
  const Small H = (reduced * C.transpose()).transpose();  // a C^T reduced^T = diag(int N_j)
  const Small a = H.partialPivLu().inverse() * C;
  if (!a.allFinite()) throw base::SolveError("a facet of a contact is covered on too small a part for its multipliers");
  const double root = 1.0 / points.front().P[0];  // of the covered area
  for (std::size_t i = 0; i < n; ++i) {
    const double own = G(kept[i], 0) * root;  // int N_j
    for (int l = 0; l < count; ++l) m.a[kept[i]][l] = own * a(static_cast<Eigen::Index>(i), l);
  }
  return m;
}

}  // namespace reye::mortar
