#include <gtest/gtest.h>

#include <numbers>

#include "adapt/solid/meeting_planes.hpp"
#include "adapt/solid/skin_strip.hpp"
#include "adapt/solid_worn.hpp"

namespace reye {
namespace {

using namespace support;  // NOLINT: test vocabulary
using adapt::FacetPoints;
using mesh::FacetKind;

FacetPoints flat_facet(FacetKind kind) {
  FacetPoints x = FacetPoints::Zero();
  for (int a = 0; a < mesh::facet_nodes(kind); ++a)
    x.col(a) << 0.5 * mesh::reference_node(kind, a).x(), 0.3 * mesh::reference_node(kind, a).y(), 0.0;
  return x;
}

constexpr FacetKind facet_kinds[] = {FacetKind::tri3, FacetKind::quad4, FacetKind::tri6};

// The strip under a flat facet that moves evenly, whichever way it drifts along itself, must be a prism; one whose
// nodes move by a linear depth a truncated prism.
TEST(SolidStrip, PrismAndTiltedPlane) {
  for (FacetKind kind : facet_kinds) {
    const FacetPoints x = flat_facet(kind);
    const double area = kind == FacetKind::quad4 ? 0.6 : 0.075;
    FacetPoints d = FacetPoints::Zero(), tilted = d;
    for (int a = 0; a < mesh::facet_nodes(kind); ++a) {
      d.col(a) << 0.02, -0.05, -0.1;
      tilted.col(a) << 0.0, 0.0, -(0.1 + 0.2 * x(0, a) - 0.3 * x(1, a));
    }
    EXPECT_NEAR(adapt::swept_volume(kind, x, d), 0.1 * area, 1e-16);
    const double depth = kind == FacetKind::quad4 ? 0.1 : 0.1 + 0.2 * 0.5 / 3.0 - 0.3 * 0.3 / 3.0;
    EXPECT_NEAR(adapt::swept_volume(kind, x, tilted), depth * area, 1e-16);
  }
}

// Over a closed skin the strips must add up to the difference of volumes, however its nodes move.
TEST(SolidStrip, AddsUpToTheLossOfVolume) {
  for (auto kind : solid_kinds) {
    const auto before = support::block(kind, {3, 2, 2}, Vec3(1, 1, 1), distort);
    auto after = before;
    for (auto& X : after.X) X += 0.05 * Vec3(std::sin(7 * X.y()), std::cos(5 * X.x() + X.z()), std::sin(6 * X.x()));
    EXPECT_NEAR(adapt::strip_between(before.X, after.X, before.skin), lost(before, after), 1e-15);
  }
}

// Thin strips must keep their digits: a thousandth of a tiny displacement sweeps a thousandth of the volume.
TEST(SolidStrip, ThinStripsKeepTheirDigits) {
  const auto m = support::block(mesh::SolidKind::tet10, {2, 2, 2}, Vec3(1, 1, 1), distort);
  const auto top = mesh::facets_of(m, "z1");
  base::Points3 step;
  for (const auto& X : m.X) step.push_back(Vec3(std::sin(3 * X.y()), X.x(), -1.0 - X.y()));
  const double thin = adapt::strip_volume(m.X, top, step, 1e-9), thinner = adapt::strip_volume(m.X, top, step, 1e-12);
  EXPECT_NEAR(thin / thinner, 1e3, 1e-5);
}

// Shares of flat-edged facets must be what unit displacements of nodes sweep to first order, by differences; those of
// curved ones must add up to the area.
TEST(SolidStrip, SharesAreItsDerivative) {
  const double h = 1e-5;
  for (auto kind : solid_kinds) {
    const auto m = support::block(kind, {1, 1, 1}, Vec3(1, 1, 1), distort);
    const auto& facet = m.skin[2];
    const FacetPoints x = adapt::points_of(m.X, facet), shares = adapt::area_shares(facet.kind, x);
    if (facet.kind == FacetKind::tri6) {
      EXPECT_NEAR(shares.colwise().norm().sum(), mesh::facet_area(m.X, facet), 1e-14);
    }
    for (int a = 0; facet.kind != FacetKind::tri6 && a < facet.count(); ++a)
      for (int c = 0; c < 3; ++c) {
        FacetPoints d = FacetPoints::Zero();
        d(c, a) = h;
        const double slope =
            (adapt::swept_volume(facet.kind, x, d) - adapt::swept_volume(facet.kind, x, -d)) / (2.0 * h);
        EXPECT_NEAR(-slope, shares(c, a), 1e-10);
      }
  }
}

// A flat disc of curved facets worn to a spherical cap must lose the cap's volume, to the third order of the facets.
TEST(SolidStrip, SphericalCap) {
  const double a = 1.0, R = 2.5, h = R - std::sqrt(R * R - a * a);
  const double cap = std::numbers::pi * h * h * (3.0 * R - h) / 3.0;
  std::vector<double> errors;
  for (int n : {3, 6}) {
    auto m = support::block(mesh::SolidKind::tet10, {2 * n, 2 * n, 1}, Vec3(2, 2, 1), [&](const Vec3& X) {
      const Vec3 p(X.x() - 1.0, X.y() - 1.0, 0.0);
      const double largest = p.cwiseAbs().maxCoeff();
      return Vec3((largest > 0.0 ? Vec3(a * largest * p.normalized()) : p) + X.z() * Vec3::UnitZ());
    });
    base::Points3 step(m.X.size(), Vec3::Zero());
    for (int node : mesh::nodes_of(mesh::facets_of(m, "z1")))
      step[node].z() = -(std::sqrt(std::max(0.0, R * R - m.X[node].head<2>().squaredNorm())) - (R - h));
    errors.push_back(std::abs(adapt::strip_volume(m.X, mesh::facets_of(m, "z1"), step) - cap) / cap);
  }
  EXPECT_LT(errors[1], 2e-4);
  EXPECT_GT(errors[0] / errors[1], 8.0);
}

// Planes that recede must meet where linear algebra has them meet; a plane of zero depth holds to the last bit, and
// what is left free follows.
TEST(SolidStrip, PlanesMeet) {
  const Vec3 n1 = Vec3(1, 0.2, 0.1).normalized(), n2 = Vec3(-0.1, 1, 0.3).normalized(),
             n3 = Vec3(0.2, 0.1, 1).normalized();
  Vec3 d = adapt::where_planes_meet({{n1, 0.1}, {n2, 0.2}, {n3, 0.3}});
  EXPECT_NEAR(n1.dot(d), -0.1, 1e-15);
  EXPECT_NEAR(n2.dot(d), -0.2, 1e-15);
  EXPECT_NEAR(n3.dot(d), -0.3, 1e-15);
  d = adapt::where_planes_meet({{n1, 0.1}});
  EXPECT_LT((d + 0.1 * n1).norm(), 1e-16);
  d = adapt::where_planes_meet({{n1, 0.1}, {n2, 0.2}});
  EXPECT_NEAR(n1.cross(n2).dot(d), 0.0, 1e-15);
  d = adapt::where_planes_meet({{Vec3(-1, 0, 0), 0.0}, {n1, 0.1}, {n3, 0.2}}, Vec3(7, 1, 1));
  EXPECT_EQ(d.x(), 0.0);
  EXPECT_NEAR(n1.dot(d), -0.1, 1e-15);
  d = adapt::where_planes_meet({{Vec3(-1, 0, 0), 0.0}, {Vec3(0, 0, 1), 0.1}}, Vec3(7, 3, 5));
  EXPECT_LT((d - Vec3(0, 3, -0.1)).norm(), 1e-15);
}

}  // namespace
}  // namespace reye
