#include "mesh/arc.hpp"
#include "support.hpp"

namespace {

using namespace reye;
using namespace reye::cad;
using mesh::CellKind;

const std::vector<Vec2> places{
    {1.37, 2.0}, {2.1, 0.83}, {4.0, 2.0}, {3.3, 1.37}};  ///< on an edge, inside, a corner, inside

Drawing block_with_points(CellKind kind, int order) {
  GeometryOptions options;
  options.files = {temporary_file("block_with_points.geo",
                                  "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {0, 0, 0, 4, 2};\n"
                                  "Physical Surface(\"block\") = {1};\nPhysical Curve(\"face\") = {1};\n")};
  options.bodies = {body("block")};
  options.bodies[0].mesh = {kind, 0.45, 1.3, order};
  options.bodies[0].points_mm = places;
  options.fine_zones = {{{"block"}, {2.0, 0.0}, 1.0, 0.3, 0.05, 0.0}};
  return build(options).drawings[0];
}

class PointVertices : public testing::TestWithParam<std::pair<CellKind, int>> {};
INSTANTIATE_TEST_SUITE_P(cad, PointVertices,
                         testing::Values(std::pair(CellKind::tri3, 1), std::pair(CellKind::quad4, 1),
                                         std::pair(CellKind::quad4, 2)));

// Points of loads and supports must be vertices of every mesh of their body, on the outline and inside, on other sizes
// too.
TEST_P(PointVertices, are_vertices_of_every_mesh) {
  const auto [kind, order] = GetParam();
  Drawing drawing = block_with_points(kind, order);
  for (const double far : {0.45, 0.4, 0.31}) {
    drawing.options.mesh.far_size_mm = far;
    const mesh::Mesh mesh = remesh(drawing);
    ASSERT_EQ(mesh.points.size(), places.size()) << far;
    for (std::size_t k = 0; k < places.size(); ++k)
      EXPECT_LT((mesh.X[mesh.points[k]] - places[k]).norm(), 1e-12) << far;
    EXPECT_GT(mesh::poorest_cell(mesh).scaled_jacobian, 0.2) << far;
  }
}

}  // namespace
