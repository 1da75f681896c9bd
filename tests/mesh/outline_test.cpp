#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "mesh/measure.hpp"
#include "small_meshes.hpp"

namespace {

using namespace reye;
using namespace reye::mesh;

// The outline of a block with a hole must be two closed loops, the outer one first, the body on the left of both.
TEST(outline, outer_loop_first_body_on_the_left) {
  const Mesh mesh = squares(3, {4});
  ASSERT_EQ(mesh.outline.size(), 2u);
  EXPECT_TRUE(is_closed(mesh.outline[0]) && is_closed(mesh.outline[1]));
  EXPECT_DOUBLE_EQ(enclosed_area(mesh.X, mesh.outline[0]), 9.0);
  EXPECT_DOUBLE_EQ(enclosed_area(mesh.X, mesh.outline[1]), -1.0);
}

// A body pinched to one node must be refused, since its outline would not be a simple loop there.
TEST(outline, pinched_body_is_refused) { EXPECT_THROW(squares(2, {1, 2}), base::MeshError); }

// Two cells that overlap along an edge must be refused.
TEST(outline, doubled_cell_is_refused) {
  Mesh mesh = squares(1);
  mesh.cells.push_back(mesh.cells[0]);
  EXPECT_THROW(outline_of(mesh.X, mesh.kind, mesh.cells), base::MeshError);
}

// Cells that name a node that does not exist must be refused, not read beyond the nodes.
TEST(outline, nodes_that_do_not_exist_are_refused) {
  Mesh mesh = squares(2);
  for (const int node : {-1, mesh.node_count()}) {
    mesh.cells[0][1] = node;
    EXPECT_THROW(outline_of(mesh.X, mesh.kind, mesh.cells), base::MeshError) << node;
  }
}

// Chosen edges that follow one another must make one chain, also across the node at which the loop's list begins.
TEST(outline, chains_run_across_the_start_of_the_loop) {
  const std::vector<Chain> loop{{0, 1, 2, 3, 4, 0}};
  const Boundary chains = chains_along(loop, {{true, false, true, false, true}});
  EXPECT_EQ(chains, (Boundary{{2, 3}, {4, 0, 1}}));
}

// All edges of a loop must make one closed chain, no edge none at all.
TEST(outline, whole_loops_stay_closed) {
  const std::vector<Chain> loops{{0, 1, 2, 0}, {3, 4, 5, 3}};
  EXPECT_EQ(chains_along(loops, {{true, true, true}, {false, false, false}}), (Boundary{{0, 1, 2, 0}}));
}

}  // namespace
