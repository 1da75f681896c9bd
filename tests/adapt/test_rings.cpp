#include <gtest/gtest.h>

#include "adapt/drawn.hpp"
#include "mesh/outline.hpp"

using namespace reye;
using base::Vec2;

namespace {

constexpr double pi = std::numbers::pi;

/// A disc of radius 1 whose circle begins at an angle, finer at its lowest point.
cad::Drawing disc(double seam) {
  auto drawing = support::drawing({support::arc({0, 0}, 1.0, seam, seam + 2.0 * pi)}, {"round"}, {.far_size = 0.2});
  drawing.zones = {{{"block"}, {0.0, -1.0}, 0.5, 0.1, 0.02, 0.0}};
  return drawing;
}

base::Points sorted_below(const mesh::Mesh& mesh) {
  base::Points nodes;
  for (int node : mesh::nodes_of(mesh.boundaries.at("round")))
    if (mesh.X[node].y() < -0.8) nodes.push_back(mesh.X[node]);
  std::sort(nodes.begin(), nodes.end(), [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); });
  return nodes;
}

/// Depth below the lowest point of the disc, by a straight line between the nodes beside it.
double depth_at_lowest(const mesh::Mesh& mesh) {
  const auto nodes = sorted_below(mesh);
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const Vec2 &a = nodes[i - 1], &b = nodes[i];
    if (a.x() <= 0.0 && b.x() > 0.0) return 1.0 + a.y() + (b.y() - a.y()) * a.x() / (a.x() - b.x());
  }
  return 0.0;
}

/// The disc after five times wear and remesh.
mesh::Mesh worn_disc(double seam) {
  auto shape = support::shape_of(disc(seam));
  for (int round = 0; round < 5; ++round) {
    const auto worn = support::worn_by(shape->mesh, "round", [](Vec2 x) {
      return x.y() < 0.0 ? 8e-3 * std::max(0.0, 1.0 - 9.0 * x.x() * x.x()) : 0.0;
    });
    const auto step = adapt::evolve(shape, base::Analysis::plane_strain, {worn});
    EXPECT_EQ(step.failure, "");
    const auto fresh = adapt::remesh(step.shape, base::Analysis::plane_strain);
    EXPECT_EQ(fresh.failure, "") << seam;
    EXPECT_TRUE(mesh::is_closed(fresh.shape->mesh.boundaries.at("round").at(0)));
    shape = fresh.shape;
  }
  return shape->mesh;
}

}  // namespace

// A ring worn and remeshed several times must be the same wherever its drawing begins, in the scar or elsewhere.
TEST(Rings, TheSeamMayLieInTheScar) {
  const double reference = depth_at_lowest(worn_disc(0.5 * pi));
  EXPECT_NEAR(reference, 0.04, 3e-4);  // to a fraction of the chords' sagitta
  for (const double seam : {1.5 * pi, 1.5 * pi - 0.013})
    EXPECT_NEAR(depth_at_lowest(worn_disc(seam)), reference, 2e-3 * reference) << seam;
}
