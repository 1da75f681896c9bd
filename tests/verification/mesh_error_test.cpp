#include "verification/contact_scene.hpp"

using namespace reye;
using namespace reye::verification;

namespace {

Played pressed(double size, double centre, const std::string& more = "") {
  const Replacements words{{"size_mm = 0.010", "size_mm = " + std::to_string(size)},
                           {"centre_mm = [0.0", "centre_mm = [" + std::to_string(centre)},
                           {"increments = 5", "increments = 1"},
                           {"material = \"steel\"", "material = \"steel\"" + more}};
  return played(scene_text("hertz_halfplane", words) + "[output]\nestimate_error = true\n");
}

}  // namespace

// The estimated error of the mesh must be the true one of Hertz's pressure within a factor of three, wherever it lies.
TEST(MeshError, Hertz) {
  for (const std::string order : {"", "\norder = 2"})
    for (const double size : {0.02, 0.01})
      for (const double shift : {0.0, 1.0 / 3.0, 2.0 / 3.0}) {
        const auto run = pressed(order.empty() ? size : 2.0 * size, shift * size, order);
        const double exact = low_hertz_error(run), estimate = run.summary.error_discretisation.value();
        EXPECT_GT(estimate, exact / 3.0) << size << order << " at " << shift;
        EXPECT_LT(estimate, exact * 3.0) << size << order << " at " << shift;
      }
}
