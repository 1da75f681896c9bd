#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <limits>
#include <set>
#include <thread>

#include "base/errors.hpp"
#include "cad/meshing/mesher.hpp"
#include "cad/meshing/region.hpp"
#include "cad/meshing/region_bytes.hpp"
#include "support/children.hpp"

namespace {

using namespace reye;
using cad::Region;

/// A triangle of twelve nodes, which no grid fills.
Region triangle() {
  Region region;
  region.kind = mesh::CellKind::tri3;
  const base::Vec2 corners[] = {{0, 0}, {4, 0}, {0, 4}};
  cad::RegionLoop loop;
  for (int k = 0; k < 12; ++k) {
    const double t = k % 4 / 4.0;
    region.X.push_back((1 - t) * corners[k / 4] + t * corners[(k / 4 + 1) % 3]);
    loop.nodes.push_back(k);
    loop.corner.push_back(k % 4 == 0);
  }
  region.loops.push_back(loop);
  return region;
}

Region filled(Region region) {
  cad::fill(region, cad::SizeField(1.0, 1.3));
  return region;
}

/// The process that fills for this one, which has no other child: that is no test where there is none.
pid_t the_child() {
  const std::set<pid_t> running = support::children();
  EXPECT_EQ(running.size(), 1u);
  return running.empty() ? 0 : *running.begin();
}

// Each test begins with none.
class mesher : public testing::Test {
 protected:
  void SetUp() override {
    cad::mesh_in(nullptr, true);
    ASSERT_TRUE(support::children().empty());
  }
};

// A region is filled inside its outline, whose nodes stay; its bytes survive the way there and back.
TEST_F(mesher, fills) {
  const Region asked = triangle(), region = filled(asked);
  EXPECT_GT(region.X.size(), asked.X.size());
  EXPECT_TRUE(std::equal(asked.X.begin(), asked.X.end(), region.X.begin()));
  double area = 0.0;
  for (const mesh::Cell& cell : region.cells) {
    const base::Vec2 a = region.X[cell[1]] - region.X[cell[0]], b = region.X[cell[2]] - region.X[cell[0]];
    area += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  EXPECT_NEAR(area, 8.0, 1e-14);
  EXPECT_EQ(filled(asked).X, region.X);
}

// A process that has ended since the last mesh, as with the thread that started it, is replaced, and the mesh is the
// same.
TEST_F(mesher, is_replaced_when_it_has_ended) {
  Region first;
  std::thread([&] { first = filled(triangle()); }).join();
  EXPECT_EQ(filled(triangle()).X, first.X);
  const pid_t running = the_child();
  ASSERT_GT(running, 0);
  ASSERT_EQ(::kill(running, SIGKILL), 0);
  EXPECT_EQ(filled(triangle()).X, first.X);
  EXPECT_NE(the_child(), running);
}

// A region on which gmsh crashes leaves an error, and the next one is filled.
TEST_F(mesher, crash_is_an_error) {
  Region bad = triangle();
  bad.loops[0].nodes[3] = 1 << 28;
  try {
    filled(bad);
    FAIL() << "a mesh with a node that does not exist";
  } catch (const base::MeshError& error) {
    EXPECT_NE(std::string(error.what()).find("the program that meshes it"), std::string::npos) << error.what();
  }
  EXPECT_FALSE(filled(triangle()).cells.empty());
}

// A forked process fills by one of its own, and gives up that of its parent without ending it.
TEST_F(mesher, is_not_shared_with_forked_processes) {
  const Region before = filled(triangle());
  const pid_t running = the_child();
  const pid_t child = ::fork();
  if (child == 0) {
    const bool same = filled(triangle()).X == before.X;
    cad::mesh_in(nullptr, true);
    ::_exit(same ? 0 : 1);
  }
  EXPECT_EQ(filled(triangle()).X, before.X);
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(filled(triangle()).X, before.X);
  EXPECT_EQ(the_child(), running);
}

// Signals that a terminal sends to all processes of a run leave it at work: the program that asked decides.
TEST_F(mesher, outlives_signals_to_its_group) {
  filled(triangle());
  const pid_t running = the_child();
  ASSERT_GT(running, 0);
  for (int signal : {SIGINT, SIGHUP, SIGTERM}) ASSERT_EQ(::kill(running, signal), 0);
  filled(triangle());
  EXPECT_EQ(the_child(), running);
}

// What comes back is checked: who read a hostile file may be under its control.
TEST_F(mesher, answers_are_checked) {
  const Region asked = triangle(), good = filled(asked);
  const auto refused = [&](const Region& region) {
    const std::string bytes = cad::bytes_of(cad::FilledRegion{region, {}});
    EXPECT_THROW(cad::filled_region_of(bytes, asked), std::runtime_error);
  };
  const std::string bytes = cad::bytes_of(cad::FilledRegion{good, {}});
  EXPECT_EQ(cad::filled_region_of(bytes, asked).region.X, good.X);
  for (std::size_t n = 0; n < bytes.size(); n += 7)
    EXPECT_THROW(cad::filled_region_of(bytes.substr(0, n), asked), std::runtime_error);
  Region other = good;
  other.X[1].x() += 1e-12;
  refused(other);
  other = good;
  other.X.back().x() = std::numeric_limits<double>::quiet_NaN();
  refused(other);
  for (int node : {-1, static_cast<int>(good.X.size())}) {
    other = good;
    other.cells[0][2] = node;
    refused(other);
  }
  other = good;
  other.kind = mesh::CellKind::quad4;
  refused(other);
  other = good;
  other.cells.clear();
  refused(other);
}

}  // namespace
