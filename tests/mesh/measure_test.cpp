#include "mesh/measure.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "small_meshes.hpp"

namespace {

using namespace reye;
using namespace reye::mesh;

// Areas of triangles and quadrilaterals must be those of the polygons, and the sum that of the outline.
TEST(measure, areas_of_cells_add_up_to_the_outline) {
  Mesh mesh = squares(3, {4});
  mesh.X[0] += Vec2(-0.3, -0.2);
  EXPECT_NEAR(area(mesh), enclosed_area(mesh.X, mesh.outline[0]) + enclosed_area(mesh.X, mesh.outline[1]), 1e-14);
  EXPECT_DOUBLE_EQ(cell_area({{0, 0}, {2, 0}, {0, 3}}, CellKind::tri3, {0, 1, 2, -1}), 3.0);
  EXPECT_DOUBLE_EQ(cell_area({{0, 0}, {2, 0}, {2, 1}, {0, 1}}, CellKind::quad4, {0, 3, 2, 1}), -2.0);
}

// A rigid body without cells must have the area inside its outline.
TEST(measure, area_without_cells_is_that_of_the_outline) {
  Mesh mesh = squares(2);
  mesh.cells.clear();
  EXPECT_DOUBLE_EQ(area(mesh), 4.0);
}

// The enclosed area must keep its digits far from the origin.
TEST(measure, area_far_from_the_origin) {
  const Points X{{1e6, 1e6}, {1e6 + 1e-2, 1e6}, {1e6 + 1e-2, 1e6 + 1e-2}, {1e6, 1e6 + 1e-2}};
  EXPECT_NEAR(enclosed_area(X, {0, 1, 2, 3, 0}), 1e-4, 1e-10);
}

// Nodal lengths must add up to the length of the boundary; a closed chain must have no end nodes.
TEST(measure, nodal_lengths_add_up) {
  const Points X{{0, 0}, {1, 0}, {3, 0}, {3, 4}};
  EXPECT_EQ(nodal_lengths(X, Boundary{{0, 1, 2}}), (std::vector<double>{0.5, 1.5, 1.0}));
  const std::vector<double> closed = nodal_lengths(X, Boundary{{0, 2, 3, 0}});
  EXPECT_EQ(closed, (std::vector<double>{4.0, 3.5, 4.5}));
}

// The outward normal must point to the right of the direction of travel.
TEST(measure, normal_points_away_from_the_body) { EXPECT_EQ(outward_normal({0, 0}, {2, 0}), Vec2(0, -1)); }

}  // namespace
