#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "adapt/fields.hpp"
#include "adapt/transfer/gauss_points.hpp"
#include "adapt/transfer/gauss_transfer.hpp"
#include "mesh/quality.hpp"
#include "support/meshes.hpp"

namespace reye {
namespace {

using namespace support;  // NOLINT: test vocabulary
using adapt::GaussOptions;
using adapt::GaussTransfer;
using adapt::transfer_elastic;
using adapt::transfer_gauss;
using base::Analysis;
using base::Matrix;
using material::ElasticState;

template <class F>
Matrix at_gauss_points(const Mesh& mesh, F f) {
  const auto points = adapt::gauss_points(mesh, Analysis::plane_strain).x;
  Matrix values(static_cast<Eigen::Index>(points.size()), 2);
  for (std::size_t i = 0; i < points.size(); ++i) values.row(static_cast<Eigen::Index>(i)) = f(points[i]).transpose();
  return values;
}

/// Values in [0, 1], repeatable.
Matrix random_values(const Mesh& mesh, int components) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const auto n = adapt::gauss_points(mesh, Analysis::plane_strain).x.size();
  return Matrix::NullaryExpr(static_cast<Eigen::Index>(n), components, [&] { return uniform(random); });
}

double largest(const Matrix& m) { return m.cwiseAbs().maxCoeff(); }

Eigen::RowVectorXd integral(const Mesh& mesh, const Matrix& values, Analysis analysis = Analysis::plane_strain) {
  const auto points = adapt::gauss_points(mesh, analysis);
  return Eigen::Map<const base::Vector>(points.volume.data(), values.rows()).transpose() * values;
}

double l2_norm(const Mesh& mesh, const Matrix& values) {
  return std::sqrt(integral(mesh, values.cwiseProduct(values)).sum());
}

// To the same mesh: nearest brings every value back to the bit; l2 what is affine in each cell (constant in tri3),
// jumps between cells included; patch what is affine over the body.
TEST(GaussTransfer, Identity) {
  for (auto kind : linear_kinds) {
    const auto mesh = turned(rectangle({.nx = 13, .ny = 9, .kind = kind, .distortion = 0.9}), 0.3);
    const Matrix any = random_values(mesh, 5);
    EXPECT_EQ(transfer_gauss(mesh, any, mesh, {GaussTransfer::nearest}), any);
    const int per_cell = static_cast<int>(any.rows()) / mesh.cell_count();
    Matrix jumping = at_gauss_points(mesh, affine_field);
    for (Eigen::Index i = 0; i < jumping.rows(); ++i) jumping.row(i) *= 1.0 + static_cast<double>(i / per_cell % 7);
    EXPECT_LT(largest(transfer_gauss(mesh, jumping, mesh, {GaussTransfer::l2}) - jumping), 1e-12);
    const Matrix straight = at_gauss_points(mesh, affine_field);
    EXPECT_LT(largest(transfer_gauss(mesh, straight, mesh, {GaussTransfer::patch}) - straight), 1e-13);
  }
}

// Gauss values by nearest are those of the nearest old Gauss point, all components of one point together.
TEST(GaussTransfer, NearestPoint) {
  for (auto kind : linear_kinds)
    for (auto other : linear_kinds) {
      const auto from = rectangle({.nx = 9, .ny = 8, .kind = kind, .distortion = 0.8});
      const auto to = rectangle({.nx = 11, .ny = 7, .kind = other, .distortion = 0.4});
      const Matrix positions = at_gauss_points(from, [](const Vec2& x) { return x; });
      const Matrix got = transfer_gauss(from, positions, to, {GaussTransfer::nearest});
      const auto fresh = adapt::gauss_points(to, Analysis::plane_strain).x;
      for (Eigen::Index i = 0; i < got.rows(); ++i) {
        double least = 1e300;
        for (Eigen::Index k = 0; k < positions.rows(); ++k)
          least = std::min(least, (positions.row(k).transpose() - fresh[i]).norm());
        EXPECT_EQ((got.row(i).transpose() - fresh[i]).norm(), least);
      }
    }
}

// Affine fields are exact by patch between any two meshes, and by l2 from quadrilaterals, from badly distorted ones and
// from coarse to fine too; l2 takes inverted cells as what they are, patch sees only where the points are.
TEST(GaussTransfer, AffineFieldsAreExact) {
  for (auto kind : linear_kinds)
    for (double distortion : {0.0, 0.9, 1.4})
      for (int n : {5, 12, 31}) {
        const auto from = turned(rectangle({.nx = 12, .ny = 7, .kind = kind, .distortion = distortion}), 0.3);
        const auto to = turned(rectangle({.nx = n, .ny = n + 2, .distortion = 0.7}), 0.3);
        const Matrix values = at_gauss_points(from, affine_field), exact = at_gauss_points(to, affine_field);
        EXPECT_LT(largest(transfer_gauss(from, values, to, {GaussTransfer::patch}) - exact), 1e-12);
        if (kind == CellKind::quad4) {
          EXPECT_LT(largest(transfer_gauss(from, values, to, {GaussTransfer::l2}) - exact), 1e-12);
        }
      }
}

// The error on a smooth field, L2 over a body in a plane and over one with curved outline, falls with the old cell size
// at first order by nearest, at second by patch, by l2 at second from and to quadrilaterals and at first for triangles.
TEST(GaussTransfer, Order) {
  for (auto way : transfer_ways)
    for (auto kind : linear_kinds)
      for (bool curved : {false, true}) {
        std::vector<double> errors;
        for (int n : {8, 16, 32}) {
          const auto body = [&](int across, int along, double distortion) {
            if (curved) return ring({.across = across, .around = 2 * along, .kind = kind});
            return rectangle({.nx = across, .ny = along, .kind = kind, .distortion = distortion});
          };
          const auto from = body(n, n, 0.6), to = body(5 * n / 4, 9 * n / 8, 0.4);
          errors.push_back(l2_norm(to, transfer_gauss(from, at_gauss_points(from, smooth_field), to, {way}) -
                                           at_gauss_points(to, smooth_field)));
        }
        const bool first = way == GaussTransfer::nearest || (way == GaussTransfer::l2 && kind == CellKind::tri3);
        const double slope = std::log2(errors[0] / errors[2]) / 2.0;
        EXPECT_GT(slope, first ? 0.9 : 1.8) << static_cast<int>(way) << static_cast<int>(kind) << curved;
        EXPECT_LT(errors[2], first ? 0.05 : 5e-3);
      }
}

bool sound(const Mesh& mesh) {
  const auto volumes = adapt::gauss_points(mesh, Analysis::plane_strain).volume;
  return *std::min_element(volumes.begin(), volumes.end()) > 0.0;
}

// l2 keeps the integral of every component between meshes of the same domain, plane and axisymmetric, with triangles
// and with quadrilaterals, of which some are concave, and never makes a component negative that was not.
TEST(GaussTransfer, IntegralIsKept) {
  for (auto analysis : {Analysis::plane_strain, Analysis::axisymmetric})
    for (auto kind : linear_kinds)
      for (auto other : linear_kinds) {
        const double distortion = kind == CellKind::quad4 ? 1.3 : 0.9;
        const auto from = rectangle({.corner = {0.3, 0.0}, .nx = 23, .ny = 17, .kind = kind, .distortion = distortion});
        const auto to = rectangle({.corner = {0.3, 0.0}, .nx = 31, .ny = 29, .kind = other, .distortion = 0.9});
        ASSERT_TRUE(sound(from) && sound(to));
        if (kind == CellKind::quad4) {
          ASSERT_LT(mesh::poorest_cell(from).scaled_jacobian, 0.0);
        }
        const Matrix values = random_values(from, 3);
        const Matrix got = transfer_gauss(from, values, to, {GaussTransfer::l2, analysis}, {0, 1});
        const auto before = integral(from, values, analysis), after = integral(to, got, analysis);
        EXPECT_LT(((after - before).array() / before.array()).abs().maxCoeff(), 1e-12);
        EXPECT_GE(got.leftCols(2).minCoeff(), 0.0);
      }
}

// l2 does not add up: the L2 norm of the fields between which it maps never grows.
TEST(GaussTransfer, ProjectionNeverGrows) {
  for (auto kind : linear_kinds) {
    const auto from = rectangle({.nx = 20, .ny = 20, .kind = kind, .distortion = 0.8});
    const auto to = rectangle({.nx = 23, .ny = 17, .kind = kind, .distortion = 0.5});
    Matrix values = random_values(from, 2);
    for (int k = 0; k < 5; ++k) {
      const Matrix there = transfer_gauss(from, values, to, {GaussTransfer::l2});
      EXPECT_LE(l2_norm(to, there), l2_norm(from, values) * (1.0 + 1e-12));
      values = transfer_gauss(to, there, from, {GaussTransfer::l2});
      EXPECT_LE(l2_norm(from, values), l2_norm(to, there) * (1.0 + 1e-12));
    }
  }
}

// A new mesh that reaches beyond the old one, by a little or by whole cells, gets values of the old body's rim there.
TEST(GaussTransfer, PointsOutside) {
  for (auto kind : linear_kinds) {
    const auto from = rectangle({.nx = 8, .ny = 8, .kind = kind, .distortion = 0.8});
    const auto to = rectangle({.corner = {-0.3, 0.0}, .size = {1.3, 1.002}, .nx = 26, .ny = 15});
    const Matrix values = at_gauss_points(from, affine_field);
    for (auto way : transfer_ways) {
      const Matrix got = transfer_gauss(from, values, to, {way});
      ASSERT_TRUE(got.allFinite());
      const Matrix clamped =
          at_gauss_points(to, [](const Vec2& x) { return affine_field(x.cwiseMax(0.0).cwiseMin(1.0)); });
      const bool smooth_there = way == GaussTransfer::patch || (way == GaussTransfer::l2 && kind == CellKind::quad4);
      EXPECT_LT(largest(got - clamped), smooth_there ? 0.02 : 0.6);
    }
  }
}

/// A zone yielded hard, with a sharp rim, at whose centre simple shear with a stretch has flowed.
std::vector<ElasticState> yielded_zone(const Mesh& mesh) {
  std::vector<ElasticState> state;
  for (const Vec2& x : adapt::gauss_points(mesh, Analysis::plane_strain).x) {
    const double r = (x - Vec2(0.5, 1.0)).norm(), p = r < 0.3 ? 0.4 * (1.0 - r) : 0.0;
    state.push_back({{0.5 * p, -0.7 * p, 0.3 * p, 0.2 * p}, p});
  }
  return state;
}

double accumulated(const Mesh& mesh, const std::vector<ElasticState>& state) {
  const auto points = adapt::gauss_points(mesh, Analysis::plane_strain);
  double sum = 0.0;
  for (std::size_t i = 0; i < state.size(); ++i) sum += points.volume[i] * state[i].accumulated;
  return sum;
}

double peak(const std::vector<ElasticState>& state) {
  double largest = 0.0;
  for (const auto& s : state) largest = std::max(largest, s.accumulated);
  return largest;
}

void expect_nonnegative(const std::vector<ElasticState>& state) {
  for (const auto& s : state) EXPECT_GE(s.accumulated, 0.0);
}

/// What a hundred transfers there and back leave of a zone six cells deep: change of the integral of p, range of its
/// peak.
struct Left {
  double sum, peak_from, peak_to;
};

Left left(GaussTransfer way, CellKind kind) {
  if (way == GaussTransfer::nearest) return {0.05, 0.98, 1.0 + 1e-15};
  if (way == GaussTransfer::patch) return {0.15, 0.25, 0.45};
  return {1e-12, kind == CellKind::tri3 ? 0.45 : 0.95, kind == CellKind::tri3 ? 0.65 : 1.15};
}

// A plastic zone with a sharp rim keeps p >= 0 over a hundred transfers there and back, and loses no more than its
// method allows: nearest keeps values, patch smears and loses, l2 keeps the integral.
TEST(GaussTransfer, AHundredTimesThereAndBack) {
  for (auto kind : linear_kinds)
    for (auto way : transfer_ways) {
      const auto one = rectangle({.nx = 20, .ny = 20, .kind = kind, .distortion = 0.5});
      const auto other = rectangle({.nx = 22, .ny = 21, .kind = kind, .distortion = 0.6});
      const auto start = yielded_zone(one);
      auto state = start;
      for (int k = 0; k < 100; ++k) {
        const auto there = transfer_elastic(one, state, other, {way});
        expect_nonnegative(there);
        state = transfer_elastic(other, there, one, {way});
        expect_nonnegative(state);
      }
      const double kept = accumulated(one, state) / accumulated(one, start), high = peak(state) / peak(start);
      const auto expected = left(way, kind);
      EXPECT_NEAR(kept, 1.0, expected.sum);
      EXPECT_GT(high, expected.peak_from);
      EXPECT_LT(high, expected.peak_to);
    }
}

// By nearest a state is not touched, not even its rounding.
TEST(GaussTransfer, NearestKeepsStatesToTheBit) {
  const auto mesh = rectangle({.nx = 9, .ny = 9, .distortion = 0.6});
  auto state = yielded_zone(mesh);
  state[100].strain[0] += 1e-17;
  const auto got = transfer_elastic(mesh, state, mesh, {GaussTransfer::nearest});
  for (std::size_t i = 0; i < state.size(); ++i) {
    EXPECT_EQ(got[i].strain, state[i].strain);
    EXPECT_EQ(got[i].accumulated, state[i].accumulated);
  }
}

/// A row (F_11, F_12, F_21, F_22, F_33) of a turn by `angle` after F.
Eigen::RowVectorXd row_of(double angle, const Eigen::Matrix2d& F, double F33) {
  Eigen::Matrix2d R;
  R << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  const Eigen::Matrix2d G = R * F;
  Eigen::RowVectorXd row(5);
  row << G(0, 0), G(0, 1), G(1, 0), G(1, 1), F33;
  return row;
}

double determinant(const Eigen::RowVectorXd& F) { return F[0] * F[3] - F[1] * F[2]; }

// A homogeneous deformation, turned by any angle, becomes F0 to round-off by every choice.
TEST(GaussTransfer, HomogeneousDeformation) {
  const auto from = rectangle({.nx = 7, .ny = 6, .distortion = 0.8}), to = rectangle({.nx = 9, .ny = 5});
  const auto n = static_cast<Eigen::Index>(adapt::gauss_points(from, Analysis::plane_strain).x.size());
  Eigen::Matrix2d stretch;
  stretch << 1.7, 0.4, -0.1, 0.3;
  for (auto way : transfer_ways)
    for (double angle : {0.0, 1.0, 3.14159, -3.0, 2.2}) {
      const auto row = row_of(angle, stretch, 0.8);
      const Matrix F0 = adapt::transfer_deformation(from, row.replicate(n, 1), to, {way});
      EXPECT_LT(largest(F0.rowwise() - row), 1e-13);
    }
}

// Of a strip bent to a half circle with strong stretch: det F0 > 0 everywhere, and second order by patch and l2, across
// the angle of half a turn too.
TEST(GaussTransfer, BentStrip) {
  const auto F_of = [](const Vec2& x) {
    Eigen::Matrix2d F;
    F << std::exp(1.5 * x.y()), 0.3 * x.x(), 0.0, std::exp(-2.0 * x.y());
    return row_of(1.6 + 3.0 * x.x(), F, std::exp(0.5 * x.y()));
  };
  const auto all = [&](const Mesh& mesh) {
    const auto points = adapt::gauss_points(mesh, Analysis::plane_strain).x;
    Matrix F(static_cast<Eigen::Index>(points.size()), 5);
    for (std::size_t i = 0; i < points.size(); ++i) F.row(static_cast<Eigen::Index>(i)) = F_of(points[i]);
    return F;
  };
  for (auto way : transfer_ways) {
    std::vector<double> errors;
    for (int n : {8, 16, 32}) {
      const auto from = rectangle({.nx = n, .ny = n, .distortion = 0.6});
      const auto to = rectangle({.nx = n + 3, .ny = 5 * n / 4, .distortion = 0.4});
      const Matrix F0 = adapt::transfer_deformation(from, all(from), to, {way});
      for (Eigen::Index i = 0; i < F0.rows(); ++i) {
        EXPECT_GT(determinant(F0.row(i)), 0.0);
        EXPECT_GT(F0(i, 4), 0.0);
      }
      errors.push_back(l2_norm(to, F0 - all(to)));
    }
    EXPECT_GT(std::log2(errors[0] / errors[2]) / 2.0, way == GaussTransfer::nearest ? 0.9 : 1.8);
  }
}

}  // namespace
}  // namespace reye
