#include <gtest/gtest.h>

#include "adapt/drawn.hpp"
#include "mesh/arc.hpp"
#include "mesh/quality.hpp"

using namespace reye;
using base::Vec2;

namespace {

const std::vector<Vec2> places{{1.37, 1.0}, {0.0, 0.43}, {0.72, 0.55}};  ///< on two sides, and inside

cad::Drawing block_with_points() {
  auto drawing = support::block_drawing();
  drawing.options.points_mm = places;
  return drawing;
}

void expect_points(const mesh::Mesh& mesh, const char* when) {
  ASSERT_EQ(mesh.points.size(), places.size()) << when;
  for (std::size_t k = 0; k < places.size(); ++k)
    EXPECT_LT((mesh.X[mesh.points[k]] - places[k]).norm(), 1e-12) << when << ", point " << k;
}

}  // namespace

// The vertices of points must stay where they are while wear moves the mesh about them, and be vertices of fresh
// meshes.
TEST(Points, StayThroughWearAndRemeshes) {
  auto shape = support::shape_of(block_with_points());
  expect_points(shape->mesh, "born");
  for (int round = 0; round < 3; ++round) {
    shape = support::wear(shape, "bottom", [](Vec2) { return 0.03; });  // shortens the left side, which carries a point
    expect_points(shape->mesh, "worn");
    const auto fresh = adapt::remesh(shape, base::Analysis::plane_strain);
    ASSERT_EQ(fresh.failure, "");
    shape = fresh.shape;
    expect_points(shape->mesh, "remeshed");
    EXPECT_GT(mesh::poorest_cell(shape->mesh).scaled_jacobian, 0.3);
  }
}

// Boundaries must continue to count arc length from the end that was chosen at first, though wear turns which end lies
// left.
TEST(Points, ArcLengthCountsFromTheSameEnd) {
  auto shape = std::make_shared<body::Shape>(*support::shape_of(support::block_drawing()));
  for (const auto& [name, chains] : shape->mesh.boundaries)
    shape->mesh.arc_origin[name] = mesh::arc_origins(shape->mesh, name);
  const auto starts_below = [](const body::ShapePtr& s) {
    const auto chain = mesh::arc_chains(s->mesh, "left").at(0);
    return s->mesh.X[chain.nodes.front()].y() < 0.5;
  };
  ASSERT_TRUE(starts_below(shape));
  const auto worn =
      support::wear(shape, "left", [](Vec2 x) { return 0.02 * (1.0 - x.y()); });  // its lower end goes right
  EXPECT_TRUE(starts_below(worn));
  const auto fresh = adapt::remesh(worn, base::Analysis::plane_strain);
  ASSERT_EQ(fresh.failure, "");
  EXPECT_TRUE(starts_below(fresh.shape));
}
