#include <gtest/gtest.h>

#include <cstdio>

#include "base/errors.hpp"
#include "support/skins.hpp"

namespace {

using namespace reye;
using base::Vec3;
using base::Vector;
using mesh::FacetKind;

/// Facets that were moved at random so far that some are slivers, warped or folded, on a bent surface.
mortar::Skin wild_skin(std::mt19937_64& random, bool up) {
  std::uniform_real_distribution<double> number(0.0, 1.0);
  constexpr std::array<FacetKind, 3> kinds{FacetKind::tri3, FacetKind::quad4, FacetKind::tri6};
  test::SkinGrid grid;
  grid.kind = kinds[random() % 3];
  grid.nx = grid.ny = 1 + static_cast<int>(random() % 4);
  grid.lo = {0.5 * number(random), 0.5 * number(random)};
  grid.hi = grid.lo + base::Vec2(0.2 + number(random), 0.2 + number(random));
  grid.up = up;
  grid.shaken = 0.5 * number(random);
  grid.bent = 0.5 * number(random);
  grid.seed = static_cast<unsigned>(random());
  const double wave = 0.3 * number(random), length = 1.0 + 6.0 * number(random), noise = 0.05 * number(random);
  return test::mapped(test::skin_grid(grid), [&](const Vec3& x) {
    return Vec3(x.x(), x.y(), wave * std::sin(length * x.x() + x.y()) + noise * number(random));
  });
}

bool finite(const base::SparseMatrix& a) {
  return a.nonZeros() == 0 || Eigen::Map<const Vector>(a.valuePtr(), a.nonZeros()).allFinite();
}

// Whatever the facets, integrals must be finite and balance; only facets that fold over or have no area are refused.
TEST(solid_integrals, of_random_skins) {
  std::mt19937_64 random(5);
  int refused = 0, covered = 0;
  double imbalance = 0.0, largest_psi = 0.0;
  for (int trial = 0; trial < 20000; ++trial) {
    const auto secondary = wild_skin(random, true), primary = wild_skin(random, false);
    try {
      const auto I = mortar::integrate(secondary, primary, {.search_mm = 0.3});
      ASSERT_TRUE(finite(I.D) && finite(I.M) && finite(I.T) && I.area.allFinite());
      for (const auto& n : I.normal) ASSERT_NEAR(n.norm(), 1.0, 1e-12);
      const Vector of_M = I.M * Vector::Ones(I.M.cols());
      const double size = 1e-300 + I.area.maxCoeff();
      imbalance = std::max(imbalance, (of_M - I.covered).cwiseAbs().maxCoeff() / size);
      if (I.M.nonZeros() > 0)
        largest_psi = std::max(largest_psi,
                               Eigen::Map<const Vector>(I.M.valuePtr(), I.M.nonZeros()).cwiseAbs().maxCoeff() / size);
      covered += I.covered.sum() > 0.0;
    } catch (const base::MeshError&) {
      ++refused;
    }
  }
  std::printf("%d covered, %d refused, imbalance %.2g, largest |M| %.3g of an area\n", covered, refused, imbalance,
              largest_psi);
  EXPECT_GT(covered, 10000);
  EXPECT_LT(imbalance, 1e-11);
}

}  // namespace
