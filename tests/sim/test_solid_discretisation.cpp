#include <gtest/gtest.h>

#include <cmath>

#include "sim/study/solid_discretisation.hpp"

using namespace reye;

namespace {

/// The square [-1, 1]^2 of n x n quadrilaterals, or of twice as many triangles with six nodes, with values f(x, y) as
/// pressure and depth.
template <class F>
sim::SkinRecord square(int n, mesh::FacetKind kind, F f) {
  sim::SkinRecord s;
  const int steps = kind == mesh::FacetKind::tri6 ? 2 * n : n;
  for (int j = 0; j <= steps; ++j)
    for (int i = 0; i <= steps; ++i) {
      const base::Vec3 x(-1.0 + 2.0 * i / steps, -1.0 + 2.0 * j / steps, 0.0);
      s.x_mm.push_back(x);
      s.pressure_MPa.push_back(f(x));
      s.shear_MPa.push_back(base::Vec3(0.5 * f(x), 0.0, 0.0));
      s.wear_depth_mm.push_back(f(x));
    }
  const auto at = [&](int i, int j) { return i + (steps + 1) * j; };
  const int stride = steps / n;
  for (int j = 0; j < steps; j += stride)
    for (int i = 0; i < steps; i += stride) {
      if (kind == mesh::FacetKind::quad4) {
        s.facets.push_back({kind, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1), -1, -1}, 0});
        continue;
      }
      s.facets.push_back(
          {kind, {at(i, j), at(i + 2, j), at(i + 2, j + 2), at(i + 1, j), at(i + 2, j + 1), at(i + 1, j + 1)}, 0});
      s.facets.push_back(
          {kind, {at(i, j), at(i + 2, j + 2), at(i, j + 2), at(i + 1, j + 1), at(i + 1, j + 2), at(i, j + 1)}, 0});
    }
  return s;
}

double dome(const base::Vec3& x) { return std::max(0.0, 1.0 - 2.0 * x.squaredNorm()); }

}  // namespace

// A side with a tenth more of everything must be a tenth off, in wear and in tractions, whatever the other mesh.
TEST(SolidDiscretisation, ATenthMore) {
  for (const auto kind : {mesh::FacetKind::quad4, mesh::FacetKind::tri6}) {
    const std::vector fine{square(16, kind, [](const auto& x) { return 1.0 - 0.3 * x.x() + 0.2 * x.y(); })};
    const std::vector coarse{square(3, kind, [](const auto& x) { return 1.1 * (1.0 - 0.3 * x.x() + 0.2 * x.y()); })};
    const auto apart = sim::mesh_difference(fine, coarse);
    EXPECT_NEAR(apart.wear.value(), 0.1, 1e-9);
    EXPECT_NEAR(apart.traction.value(), 0.1, 1e-9);
    EXPECT_NEAR(apart.peak.value(), 0.1, 1e-9);
    EXPECT_NEAR(sim::mesh_difference(fine, fine).wear.value(), 0.0, 1e-9);
  }
}

// A smooth profile that is straight between the coarse rows must be off by the second power of their distance.
TEST(SolidDiscretisation, OrderOfInterpolation) {
  std::vector<double> apart;
  const std::vector fine{square(128, mesh::FacetKind::quad4, dome)};
  for (int n : {8, 16, 32})
    apart.push_back(sim::mesh_difference(fine, {square(n, mesh::FacetKind::tri6, dome)}).wear.value());
  for (int k : {0, 1}) EXPECT_NEAR(std::log2(apart[k] / apart[k + 1]), 2.0, 0.2) << apart[k];
}

// Where nothing has worn or touches there must be no number, not a zero.
TEST(SolidDiscretisation, NothingToCompare) {
  const std::vector none{square(4, mesh::FacetKind::quad4, [](const auto&) { return 0.0; })};
  const auto apart = sim::mesh_difference(none, none);
  EXPECT_FALSE(apart.wear || apart.traction || apart.peak);
}
