#include <gtest/gtest.h>

#include "adapt/solid/solid_relocation.hpp"
#include "adapt/solid/solid_remesh.hpp"
#include "adapt/solid/solid_triggers.hpp"
#include "adapt/solid_worn.hpp"
#include "cad/solid_support.hpp"

namespace reye {
namespace {

using namespace support;  // NOLINT: test vocabulary

// A pin from CAD whose end wears unevenly to half of its length, its edge sliding along the round side, must lose
// exactly what it is asked for through all remeshes, and its side stay round.
TEST(SolidPin, WearsToHalfOfItsLength) {
  for (auto kind : {mesh::SolidKind::tet4, mesh::SolidKind::tet10}) {
    auto options = cad::solid_options({cad::solid_data("pin.geo")}, {cad::solid_body("pin", kind)});
    options.bodies[0].mesh.far_size_mm = 0.5;
    const auto pin = cad::build_solids(options).bodies[0];
    auto now = shared(pin), born = now;
    adapt::SolidRelocationCache cache;
    double removed = 0.0;
    int remeshes = 0;
    for (int step = 0; step < 90; ++step) {
      const auto worn = worn_by(*now, "end", [](const Vec3& X) { return 0.02 * (1.0 + 0.3 * X.x()); });
      const auto result = adapt::evolve_solid(now, *born, {worn}, 0.05, &cache);
      ASSERT_TRUE(result.mesh) << step << ": " << result.failure;
      removed += sum({worn});
      now = result.mesh;
      if (adapt::why_remesh(*now, *born, {}).empty()) continue;
      const auto fresh = adapt::remesh_solid(*now, *born);
      ASSERT_TRUE(fresh.mesh) << step << ": " << fresh.failure;
      now = born = fresh.mesh;
      ++remeshes;
    }
    EXPECT_GT(remeshes, 10);
    EXPECT_NEAR(lost(pin, *now), removed, 1e-11 * removed);
    for (int node : mesh::nodes_of(mesh::facets_of(*now, "side")))
      EXPECT_NEAR(now->X[node].head<2>().norm(), 2.0, kind == mesh::SolidKind::tet4 ? 0.03 : 1e-3);
  }
}

}  // namespace
}  // namespace reye
