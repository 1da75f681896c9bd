#include <gtest/gtest.h>

#include "adapt/shape/unworn.hpp"
#include "adapt/worn.hpp"

namespace reye {
namespace {

using namespace support;  // NOLINT: test vocabulary

double deepest_node(const Mesh& mesh, const adapt::UnwornLine& line, const std::string& boundary) {
  double most = 0.0;
  for (int node : mesh::nodes_of(mesh.boundaries.at(boundary)))
    most = std::max(most, std::abs(line.depth(mesh.X[node])));
  return most;
}

}  // namespace

// The nodes that the line was drawn through have no depth, at corners, too.
TEST(UnwornLine, NoDepthWithoutWear) {
  const auto arcs = ring({.inner = 1.0, .outer = 2.0, .around = 24});
  const auto block = rectangle({.size = {2.0, 1.0}, .nx = 20, .ny = 8});
  for (const auto& [mesh, boundary] : {std::pair{arcs, "right"}, std::pair{arcs, "left"}, std::pair{block, "top"}})
    EXPECT_LT(deepest_node(mesh, {mesh, mesh.boundaries.at(boundary)}, boundary), 1e-15) << boundary;
}

// Below a circle the depth is the difference of radii wherever nodes are, to fourth order in the facet; to six digits
// where wear is as deep as a quarter of the radius.
TEST(UnwornLine, CircleToFourthOrder) {
  const auto error = [](int around, double depth) {
    const auto mesh = ring({.inner = 1.0, .outer = 2.0, .around = around});
    const adapt::UnwornLine line(mesh, mesh.boundaries.at("right"));
    double worst = 0.0;
    for (double angle = 0.3; angle < 1.2; angle += 0.0317)
      worst = std::max(worst, std::abs(line.depth((2.0 - depth) * Vec2(std::cos(angle), std::sin(angle))) - depth));
    return worst;
  };
  EXPECT_LT(error(24, 0.01), 1e-6);
  EXPECT_LT(error(48, 0.01), error(24, 0.01) / 12.0);
  EXPECT_LT(error(24, 0.5), 1e-6);
}

}  // namespace reye
