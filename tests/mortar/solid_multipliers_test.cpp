#include "mortar/solid/multipliers.hpp"

#include <gtest/gtest.h>

#include "algebra/decompose.hpp"
#include "mortar/solid/clip.hpp"

namespace {

using namespace reye;
using base::Vec2;
using mesh::FacetKind;
using mortar::ConvexPolygon;
using mortar::FacetCut;
using mortar::FacetValues;
using mortar::SkinPoint;

constexpr std::array<FacetKind, 3> facet_kinds{FacetKind::tri3, FacetKind::quad4, FacetKind::tri6};

/// The reference shape of a facet as a polygon.
ConvexPolygon whole(FacetKind kind) {
  ConvexPolygon p;
  p.count = mesh::facet_corners(kind);
  for (int j = 0; j < p.count; ++j) p.corners[j] = mortar::reference_place(kind, j);
  return p;
}

/// Its part within a strip of some width, leaning, that begins at a distance from the first corner.
ConvexPolygon strip(FacetKind kind, double from, double width) {
  ConvexPolygon band;
  band.count = 4;
  const Vec2 along = Vec2(1.0, -0.8).normalized(), across{-along.y(), along.x()}, at = whole(kind).corners[0];
  band.corners = {Vec2(at + from * across - 9 * along), Vec2(at + from * across + 9 * along),
                  Vec2(at + (from + width) * across + 9 * along), Vec2(at + (from + width) * across - 9 * along)};
  return mortar::overlap(whole(kind), band, 1e-14);
}

/// Points over a polygon of the reference shape, fan by fan, each triangle halved `times` times along its longest way.
void add_points(FacetKind kind, const std::array<Vec2, 3>& y, int times, std::vector<SkinPoint>& points) {
  if (times > 0) {
    const Vec2 middle = 0.5 * (y[0] + y[1]);
    add_points(kind, {y[1], y[2], middle}, times - 1, points);
    return add_points(kind, {y[2], y[0], middle}, times - 1, points);
  }
  const double area = 0.5 * base::cross(y[1] - y[0], y[2] - y[0]);
  for (const auto& [at, weight] : mortar::triangle_rule(8)) {
    auto& q = points.emplace_back();
    q.xi = y[0] + at.x() * (y[1] - y[0]) + at.y() * (y[2] - y[0]);
    q.N = mortar::skin_functions(kind, q.xi);
    q.weight = weight * area;
  }
}

std::vector<SkinPoint> points_over(FacetKind kind, const ConvexPolygon& p, int times = 0) {
  std::vector<SkinPoint> points;
  for (int i = 2; i < p.count; ++i) add_points(kind, {p.corners[0], p.corners[i - 1], p.corners[i]}, times, points);
  return points;
}

/// psi_j as combinations of the facet's own shape functions, from its values at the points: rows j.
Eigen::MatrixXd in_shape_functions(FacetKind kind, const FacetCut& cut, const std::vector<SkinPoint>& points) {
  const auto basis = mortar::multipliers(kind, cut, points);
  const int count = mesh::facet_nodes(kind);
  Eigen::MatrixXd N(points.size(), count), psi(points.size(), count);
  for (std::size_t q = 0; q < points.size(); ++q)
    for (int j = 0; j < count; ++j) {
      N(static_cast<Eigen::Index>(q), j) = points[q].N[j];
      double sum = 0.0;
      for (int l = 0; l < count; ++l) sum += basis.a[j][l] * points[q].P[l];
      psi(static_cast<Eigen::Index>(q), j) = sum;
    }
  return algebra::least_squares(N, psi).transpose();
}

Eigen::MatrixXd basis_over(FacetKind kind, const FacetCut& cut, const ConvexPolygon& p) {
  auto points = points_over(kind, p);
  mortar::orthonormalise(kind, points);
  return in_shape_functions(kind, cut, points);
}

/// int psi_j N_k by other points.
Eigen::MatrixXd products(FacetKind kind, const Eigen::MatrixXd& basis, const ConvexPolygon& p) {
  Eigen::MatrixXd D = Eigen::MatrixXd::Zero(basis.rows(), basis.cols());
  for (const auto& q : points_over(kind, p, 3)) {
    const auto N = Eigen::Map<const Eigen::VectorXd>(q.N.data(), basis.cols());
    D += q.weight * (basis * N) * N.transpose();
  }
  return D;
}

Eigen::VectorXd areas(FacetKind kind, const ConvexPolygon& p) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(mesh::facet_nodes(kind));
  for (const auto& q : points_over(kind, p, 3))
    sum += q.weight * Eigen::Map<const Eigen::VectorXd>(q.N.data(), sum.size());
  return sum;
}

// On whole facets the rows must be the known ones: 3 N_j - N_k - N_l on tri3, (4, -2, 1, -2) on quad4, and on tri6
// those of Bernstein polynomials.
TEST(solid_multipliers, known_on_whole_facets) {
  const auto tri3 = basis_over(FacetKind::tri3, {}, whole(FacetKind::tri3));
  EXPECT_LT((tri3.row(0) - Eigen::RowVector3d(3, -1, -1)).norm(), 1e-12);
  const auto quad4 = basis_over(FacetKind::quad4, {}, whole(FacetKind::quad4));
  EXPECT_LT((quad4.row(1) - Eigen::RowVector4d(-2, 4, -2, 1)).norm(), 1e-12);
  const auto tri6 = basis_over(FacetKind::tri6, {}, whole(FacetKind::tri6));
  EXPECT_LT((tri6.row(0) - Eigen::Matrix<double, 1, 6>(6, 1, 1, -4, 1, -4)).norm(), 1e-11);
  EXPECT_LT((tri6.row(3) - Eigen::Matrix<double, 1, 6>(-4, -4, 1, 11, -1.5, -1.5)).norm(), 1e-11);
}

// On tri6 with linear multipliers they must be 5/2 L_j - 1/2 of the hats L: int psi_j N_k = delta_jk A / 6 at corners,
// A / 12 at the control points beside.
TEST(solid_multipliers, linear_on_whole_tri6) {
  const FacetCut mids{false, false, false, true, true, true};
  const auto triangle = whole(FacetKind::tri6);
  const auto D = products(FacetKind::tri6, basis_over(FacetKind::tri6, mids, triangle), triangle);
  const double area = 0.5;
  EXPECT_LT((D.row(0) - area * Eigen::Matrix<double, 1, 6>(1. / 6, 0, 0, 1. / 12, 0, 1. / 12)).norm(), 1e-13);
  EXPECT_LT((D.row(2) - area * Eigen::Matrix<double, 1, 6>(0, 0, 1. / 6, 0, 1. / 12, 1. / 12)).norm(), 1e-13);
  EXPECT_EQ(D.bottomRows(3).norm(), 0.0);
}

/// int psi_j N_k by points that took no part in making the basis.
Eigen::MatrixXd products_by_others(FacetKind kind, const ConvexPolygon& p) {
  auto points = points_over(kind, p);
  const std::size_t own = points.size();
  const auto others = points_over(kind, p, 3);
  points.insert(points.end(), others.begin(), others.end());
  for (std::size_t q = own; q < points.size(); ++q) points[q].weight = 0.0;
  mortar::orthonormalise(kind, points);
  const auto basis = mortar::multipliers(kind, {}, points);
  const int count = mesh::facet_nodes(kind);
  Eigen::MatrixXd D = Eigen::MatrixXd::Zero(count, count);
  for (std::size_t q = own; q < points.size(); ++q)
    for (int j = 0; j < count; ++j)
      for (int k = 0; k < count; ++k)
        for (int l = 0; l < count; ++l)
          D(j, k) += others[q - own].weight * basis.a[j][l] * points[q].P[l] * points[q].N[k];
  return D;
}

struct StripCase {
  double from, width, accuracy;
};

// int psi_j N_k = delta_jk int N_j must hold over the covered part by another quadrature, down to a thousandth of it.
TEST(solid_multipliers, biorthogonal_on_the_covered_part) {
  for (FacetKind kind : facet_kinds)
    for (const auto& [from, width, accuracy] :
         {StripCase{-0.1, 0.5, 1e-13}, {0.3, 0.2, 1e-13}, {0.2, 0.01, 1e-11}, {0.3, 1e-3, 1e-7}, {-0.1, 0.15, 1e-11}}) {
      const auto p = strip(kind, from, width);
      ASSERT_GT(p.count, 2);
      const Eigen::MatrixXd expected = areas(kind, p).asDiagonal();
      EXPECT_LT((products_by_others(kind, p) - expected).cwiseAbs().maxCoeff(), accuracy * expected.maxCoeff())
          << static_cast<int>(kind) << " from " << from << " width " << width;
    }
}

/// All ways in which points of a facet can be cut, but all of them.
std::vector<FacetCut> ways_to_cut(FacetKind kind) {
  const int count = mesh::facet_nodes(kind);
  std::vector<FacetCut> ways;
  for (int bits = 0; bits < (1 << count) - 1; ++bits) {
    FacetCut cut{};
    for (int j = 0; j < count; ++j) cut[j] = (bits >> j) & 1;
    ways.push_back(cut);
  }
  return ways;
}

// Whatever points are cut, the others' functions must add up to one, so that the traction stays whole, and be
// biorthogonal among each other; cut ones carry nothing.
TEST(solid_multipliers, what_is_cut_is_carried_by_the_others) {
  for (FacetKind kind : facet_kinds)
    for (const auto& p : {whole(kind), strip(kind, 0.1, 0.4)})
      for (const auto& cut : ways_to_cut(kind)) {
        const auto basis = basis_over(kind, cut, p);
        EXPECT_LT((basis.colwise().sum().array() - 1.0).abs().maxCoeff(), 1e-9);
        const auto D = products(kind, basis, p);
        const auto own = areas(kind, p);
        for (int j = 0; j < D.rows(); ++j)
          for (int k = 0; k < D.cols(); ++k) {
            if (cut[j] || !cut[k]) {
              EXPECT_NEAR(D(j, k), j == k && !cut[j] ? own[j] : 0.0, 1e-10);
            }
          }
      }
}

// The shares of every point must add up to one, whatever is cut, and none be negative.
TEST(solid_multipliers, shares_add_up_to_one) {
  for (FacetKind kind : facet_kinds)
    for (const auto& cut : ways_to_cut(kind)) {
      auto points = points_over(kind, whole(kind));
      mortar::orthonormalise(kind, points);
      const auto basis = mortar::multipliers(kind, cut, points);
      for (int k = 0; k < mesh::facet_nodes(kind); ++k) {
        double sum = 0.0;
        for (int j = 0; j < mesh::facet_nodes(kind); ++j) {
          EXPECT_GE(basis.share[j][k], 0.0);
          sum += basis.share[j][k];
        }
        EXPECT_NEAR(sum, 1.0, 1e-15);
      }
    }
}

// Rules on the triangle must integrate monomials up to their degree, and only these.
TEST(solid_multipliers, rules_are_of_their_degree) {
  const auto factorial = [](int n) { return std::tgamma(n + 1.0); };
  for (int degree : {2, 5, 6, 8})
    for (int i = 0; i <= degree; ++i)
      for (int j = 0; i + j <= degree; ++j) {
        double sum = 0.0;
        for (const auto& [xi, weight] : mortar::triangle_rule(degree))
          sum += weight * std::pow(xi.x(), i) * std::pow(xi.y(), j);
        EXPECT_NEAR(sum, 2.0 * factorial(i) * factorial(j) / factorial(i + j + 2), 2e-16 + 1e-15) << degree << i << j;
      }
}

}  // namespace
