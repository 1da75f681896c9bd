#include <gtest/gtest.h>

#include <Eigen/LU>

#include "mortar/solid/clip.hpp"
#include "mortar/solid/facet_functions.hpp"
#include "mortar/solid/facet_integrals.hpp"
#include "support/skins.hpp"

namespace {

using namespace reye;
using base::Vec3;
using base::Vector;
using mesh::FacetKind;
using mortar::Skin;
using mortar::SkinDual;
using test::SkinGrid;

/// A secondary side that looks up and a primary one above it that looks down, on the same plane.
struct PatchCase {
  const char* name;
  SkinGrid secondary{}, primary{};
  SkinDual dual = SkinDual::quadratic;
  double accuracy = 1e-11;  ///< of quadrature, relative to a facet
};

constexpr auto tri3 = FacetKind::tri3, quad4 = FacetKind::quad4, tri6 = FacetKind::tri6;

/// A primary side as wide as the secondary one, one that ends in the middle of secondary facets and overhangs
/// elsewhere, finer ones and coarser ones.
std::vector<PatchCase> four_primaries(PatchCase c) {
  std::vector<PatchCase> cases{c};
  c.primary.lo = {0.37, -0.2};
  c.primary.hi = {1.4, 0.81};
  for (auto [nx, ny] : {std::array{5, 4}, std::array{11, 11}, std::array{1, 1}}) {
    c.primary.nx = nx;
    c.primary.ny = ny;
    cases.push_back(c);
  }
  return cases;
}

/// Facets whose integrands are polynomials, where all is exact, or not (distorted quadrangles, curved edges).
std::vector<PatchCase> patch_cases() {
  std::vector<PatchCase> all;
  const auto add = [&](PatchCase c, FacetKind a, FacetKind b, double shaken, double bent = 0.0) {
    c.secondary = {.kind = a, .nx = 4, .ny = 3, .up = true, .shaken = shaken, .bent = bent, .seed = 5};
    c.primary = {.kind = b, .nx = 5, .ny = 4, .up = false, .shaken = shaken, .bent = bent, .seed = 8};
    const auto cases = four_primaries(c);
    all.insert(all.end(), cases.begin(), cases.end());
  };
  add({"tri3 on tri3"}, tri3, tri3, 0.3);
  add({"quad4 on quad4"}, quad4, quad4, 0.0);
  add({"tri6 on quad4"}, tri6, quad4, 0.0);
  add({"quad4 on tri6"}, quad4, tri6, 0.0);
  add({"tri6 on tri6"}, tri6, tri6, 0.25);
  add({"tri6 on tri3"}, tri6, tri3, 0.25);
  add({"tri6 on tri3, linear multipliers", {}, {}, SkinDual::linear}, tri6, tri3, 0.25);
  add({"distorted quad4", {}, {}, SkinDual::quadratic, 1e-5}, quad4, quad4, 0.25);
  add({"tri3 on distorted quad4", {}, {}, SkinDual::quadratic, 1e-5}, tri3, quad4, 0.25);
  add({"tri6 on distorted quad4", {}, {}, SkinDual::quadratic, 1e-5}, tri6, quad4, 0.25);
  add({"curved tri6 on distorted quad4", {}, {}, SkinDual::quadratic, 0.1}, tri6, quad4, 0.15, 0.1);
  add({"curved tri6", {}, {}, SkinDual::linear, 0.1}, tri6, tri6, 0.15, 0.1);
  return all;
}

mortar::SkinIntegrals integrals(const Skin& secondary, const Skin& primary, SkinDual dual = SkinDual::quadratic) {
  return mortar::integrate(secondary, primary, {.search_mm = 0.5, .dual = dual});
}

/// The area that the rectangles of two grids have in common.
double common_area(const SkinGrid& a, const SkinGrid& b) { return (a.hi.cwiseMin(b.hi) - a.lo.cwiseMax(b.lo)).prod(); }

// The sum of D must be the covered area, turned by 30 degrees about a skew axis or not.
TEST(solid_patch, D_adds_up_to_the_covered_area) {
  for (const auto& c : patch_cases())
    for (double degrees : {0.0, 30.0}) {
      const auto secondary = test::turned(test::skin_grid(c.secondary), degrees);
      const auto primary = test::turned(test::skin_grid(c.primary), degrees);
      const auto I = integrals(secondary, primary, c.dual);
      EXPECT_NEAR(I.covered.sum(), common_area(c.secondary, c.primary), 1e-12) << c.name << ", " << degrees;
      EXPECT_NEAR(I.area.sum(), (c.secondary.hi - c.secondary.lo).prod(), 1e-12) << c.name;
      EXPECT_LE((I.covered - I.M * Vector::Ones(I.M.cols())).cwiseAbs().maxCoeff(), 1e-15) << c.name;
    }
}

// A linear field of the primary side must arrive at the secondary side: M x_p = D x_s where both lie on each other.
TEST(solid_patch, linear_fields_are_reproduced) {
  for (const auto& c : patch_cases()) {
    const auto secondary = test::turned(test::skin_grid(c.secondary), 30.0);
    const auto primary = test::turned(test::skin_grid(c.primary), 30.0);
    const auto I = integrals(secondary, primary, c.dual);
    EXPECT_LT(test::offset_error(I, secondary, primary), 1e-11 * I.covered.maxCoeff()) << c.name;
  }
}

/// The place on a facet of the plane z = const that lies at y, by Newton's method.
base::Vec2 place_on(const mesh::Facet& facet, const Skin& skin, const base::Vec2& y) {
  base::Vec2 xi = facet.kind == quad4 ? base::Vec2(0, 0) : base::Vec2(0.3, 0.3);
  for (int step = 0; step < 20; ++step) {
    const auto N = mortar::skin_functions(facet.kind, xi);
    const auto [dr, ds] = mortar::skin_slopes(facet.kind, xi);
    base::Vec2 miss = -y;
    Eigen::Matrix2d J = Eigen::Matrix2d::Zero();
    for (int j = 0; j < facet.count(); ++j) {
      const base::Vec2 x = skin.x[facet.nodes[j]].head<2>();
      miss += N[j] * x;
      J.col(0) += dr[j] * x;
      J.col(1) += ds[j] * x;
    }
    xi -= J.inverse() * miss;
  }
  return xi;
}

/// Adds int N_l over a triangle, halved `times` times.
void add_load(const mesh::Facet& facet, const Skin& skin, const std::array<base::Vec2, 3>& y, int times, Vector& load) {
  if (times > 0) {
    const base::Vec2 a = 0.5 * (y[0] + y[1]), b = 0.5 * (y[1] + y[2]), c = 0.5 * (y[2] + y[0]);
    for (const auto& part : {std::array{y[0], a, c}, {a, y[1], b}, {c, b, y[2]}, {a, b, c}})
      add_load(facet, skin, part, times - 1, load);
    return;
  }
  const double area = 0.5 * base::cross(y[1] - y[0], y[2] - y[0]);
  for (const auto& [xi, weight] : mortar::triangle_rule(8)) {
    const auto at = place_on(facet, skin, y[0] + xi.x() * (y[1] - y[0]) + xi.y() * (y[2] - y[0]));
    const auto N = mortar::skin_functions(facet.kind, at);
    for (int j = 0; j < facet.count(); ++j) load[facet.nodes[j]] += weight * area * N[j];
  }
}

/// int N_l over the rectangle from lo to hi for every point of a grid, facet by facet, with no other side.
Vector consistent_load(const Skin& side, const base::Vec2& lo, const base::Vec2& hi) {
  Vector load = Vector::Zero(static_cast<Eigen::Index>(side.x.size()));
  mortar::ConvexPolygon rectangle, own;
  rectangle.count = 4;
  rectangle.corners = {lo, base::Vec2{hi.x(), lo.y()}, hi, base::Vec2{lo.x(), hi.y()}};
  for (const auto& facet : side.facets) {
    own.count = mesh::facet_corners(facet.kind);
    for (int j = 0; j < own.count; ++j) own.corners[j] = side.x[facet.nodes[j]].head<2>();
    if (mortar::polygon_area(own) < 0.0) std::reverse(own.corners.begin(), own.corners.begin() + own.count);
    const auto common = mortar::overlap(rectangle, own, 1e-14);
    for (int i = 2; i < common.count; ++i)
      add_load(facet, side, {common.corners[0], common.corners[i - 1], common.corners[i]}, 2, load);
  }
  return load;
}

// A constant traction on a partly covered interface must load both sides as this traction does on the overlap: the
// patch test.
TEST(solid_patch, constant_traction_loads_the_overlap_alone) {
  for (const auto& c : patch_cases()) {
    const auto secondary = test::skin_grid(c.secondary), primary = test::skin_grid(c.primary);
    const auto I = integrals(secondary, primary, c.dual);
    const Vector lambda = Vector::Constant(I.M.rows(), 2.5);
    const base::Vec2 lo = c.secondary.lo.cwiseMax(c.primary.lo), hi = c.secondary.hi.cwiseMin(c.primary.hi);
    const double limit = c.accuracy * I.covered.maxCoeff();
    EXPECT_LT((I.M.transpose() * lambda - 2.5 * consistent_load(primary, lo, hi)).cwiseAbs().maxCoeff(), limit)
        << c.name;
    EXPECT_LT((I.D.transpose() * lambda - 2.5 * consistent_load(secondary, lo, hi)).cwiseAbs().maxCoeff(), limit)
        << c.name;
  }
}

// Facets that look the same way, lie farther away than the search distance, or beside each other must not be paired.
TEST(solid_patch, what_does_not_face_is_left_out) {
  const auto secondary = test::skin_grid({.kind = quad4});
  for (const auto& primary :
       {test::skin_grid({.kind = quad4, .up = true}), test::skin_grid({.kind = quad4, .height = 0.6, .up = false}),
        test::skin_grid({.kind = quad4, .lo = {2, 0}, .hi = {3, 1}, .up = false})}) {
    const auto I = integrals(secondary, primary);
    EXPECT_EQ(I.M.nonZeros(), 0);
    EXPECT_EQ(I.covered.sum(), 0.0);
    for (char carries : I.carries) EXPECT_FALSE(carries);
  }
}

// Several primaries side by side must cover as one does.
TEST(solid_patch, several_primaries) {
  for (FacetKind kind : {tri3, quad4, tri6}) {
    const auto secondary = test::skin_grid({.kind = kind, .nx = 5, .ny = 5});
    const SkinGrid left{.kind = quad4, .nx = 3, .lo = {-1, -1}, .hi = {0.43, 2}, .up = false};
    const SkinGrid right{.kind = tri3, .nx = 2, .lo = {0.43, -1}, .hi = {2, 2}, .up = false};
    const auto primary = test::joined_skins(test::skin_grid(left), test::skin_grid(right));
    const auto I = integrals(secondary, primary);
    EXPECT_NEAR(I.covered.sum(), 1.0, 1e-12);
    EXPECT_LT((I.covered - I.area).cwiseAbs().maxCoeff(), 1e-13);
    EXPECT_LT(test::offset_error(I, secondary, primary), 1e-13);
  }
}

// A strip that covers 1e-4 of the area of some points must leave them without multiplier, and the whole traction to the
// others; forces and linear fields stay exact.
TEST(solid_patch, hardly_covered_points_carry_nothing) {
  for (FacetKind kind : {tri3, quad4, tri6}) {
    const auto secondary = test::skin_grid({.kind = kind, .nx = 4, .ny = 4});
    const SkinGrid grid{.kind = tri3, .lo = {-1, -1}, .hi = {0.5 + 0.25 * 0.004, 2}, .up = false};
    const auto primary = test::skin_grid(grid);
    const auto I = integrals(secondary, primary);
    int without = 0;
    for (std::size_t j = 0; j < secondary.x.size(); ++j)
      if (secondary.x[j].x() < 0.51) {
        EXPECT_TRUE(I.carries[j]);
      } else {
        EXPECT_FALSE(I.carries[j] && secondary.x[j].x() > 0.74) << secondary.x[j].x();
        without += !I.carries[j];
      }
    EXPECT_GT(without, 0);
    // Facets of which a corner of 0.4 % is covered take no part.
    EXPECT_NEAR(I.covered.sum(), 0.501, kind == quad4 ? 1e-12 : 2.1e-6);
    EXPECT_LT(test::offset_error(I, secondary, primary), 1e-12);
  }
}

// Wherever a primary side ends, a point that keeps its multiplier must be covered by a thousandth of its area when its
// neighbours have lost theirs, and linear fields stay exact.
TEST(solid_patch, none_is_left_bare_by_its_neighbours) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(0.3, 0.9);
  for (int k = 0; k < 400; ++k) {
    const auto secondary = test::skin_grid({.kind = tri6, .nx = 4, .ny = 4, .shaken = 0.2, .seed = 5});
    const SkinGrid grid{.kind = tri3, .lo = {-1, -1}, .hi = {number(random), number(random)}, .up = false};
    const auto primary = test::skin_grid(grid);
    const auto I = integrals(secondary, primary);
    for (std::size_t j = 0; j < secondary.x.size(); ++j) {
      const auto i = static_cast<Eigen::Index>(j);
      EXPECT_TRUE(!I.carries[j] || I.covered[i] >= mortar::least_covered * I.area[i])
          << k << ": " << I.covered[i] / I.area[i];
    }
    EXPECT_LT(test::offset_error(I, secondary, primary), 1e-10);
  }
}

}  // namespace
