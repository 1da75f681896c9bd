#include "verification/contact_scene.hpp"

using namespace reye;
using namespace reye::verification;

namespace {

constexpr double a = 0.2, p0 = 109.89011;  // hertz_halfplane

Played pressed(double size, double centre, const std::string& more = "") {
  const Replacements words{{"size_mm = 0.010", "size_mm = " + std::to_string(size)},
                           {"centre_mm = [0.0", "centre_mm = [" + std::to_string(centre)},
                           {"increments = 5", "increments = 1"},
                           {"material = \"steel\"", "material = \"steel\"" + more}};
  return played(scene_text("hertz_halfplane", words) + "[output]\nestimate_error = true\n");
}

/// L2 of the pressure, over its norm.
double true_error(const Played& run) {
  const auto& side = run.surface(sim::Side::secondary);
  const auto error = l2_error(profile(side, side.pressure_MPa), 2.0 * a, [](double x) { return hertz(x, a, p0); });
  return error / (p0 * std::sqrt(4.0 * a / 3.0));
}

}  // namespace

// The estimated error of the mesh must be the true one of Hertz's pressure within a factor of three, wherever it lies.
TEST(MeshError, Hertz) {
  for (const std::string order : {"", "\norder = 2"})
    for (const double size : {0.02, 0.01})
      for (const double shift : {0.0, 1.0 / 3.0, 2.0 / 3.0}) {
        const auto run = pressed(order.empty() ? size : 2.0 * size, shift * size, order);
        const double exact = true_error(run), estimate = run.summary.error_discretisation.value();
        EXPECT_GT(estimate, exact / 3.0) << size << order << " at " << shift;
        EXPECT_LT(estimate, exact * 3.0) << size << order << " at " << shift;
      }
}
