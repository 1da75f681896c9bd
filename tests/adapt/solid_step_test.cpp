#include <gtest/gtest.h>

#include <fstream>

#include "adapt/solid/solid_relocation.hpp"
#include "adapt/solid_worn.hpp"
#include "base/errors.hpp"
#include "support/sanitizers.hpp"

namespace reye {
namespace {

using namespace support;  // NOLINT: test vocabulary
using adapt::evolve_solid;
using mesh::SolidKind;

void expect_exact(const mesh::SolidMesh& m, const std::vector<adapt::WornFace>& worn) {
  const auto mesh = shared(m);
  const auto result = evolve_solid(mesh, m, worn, 0.01);
  ASSERT_TRUE(result.mesh) << result.failure;
  const double volume = sum(worn);
  EXPECT_NEAR(result.removed, volume, 1e-13 * volume);
  EXPECT_NEAR(lost(m, *result.mesh), volume, 1e-10 * volume);
  mesh::check(*result.mesh);
}

double dent(const Vec3& X) { return 0.04 * std::max(0.0, 1.0 - 5.0 * (X - Vec3(0.5, 0.5, X.z())).squaredNorm()); }

// The strip between old and new skin must have exactly the removed volume, on facets of every kind, flat and curved.
TEST(SolidStep, StripIsTheRemovedVolume) {
  for (auto kind : solid_kinds) {
    const auto flat = support::block(kind, {6, 6, 4}, Vec3(1, 1, 1));
    expect_exact(flat, {worn_by(flat, "z1", dent)});
    const auto bent = support::block(kind, {6, 6, 4}, Vec3(1, 1, 1), distort);
    expect_exact(bent, {worn_by(bent, "z1", dent)});
    const auto round = ball(kind, 4, 1.0);
    expect_exact(round, {worn_by(round, "ball", [](const Vec3& X) { return 0.02 * (1.0 + X.x() * X.z()); })});
  }
}

// Faces that share edges, and a name of several faces, must lose their volumes together.
TEST(SolidStep, FacesThatShareEdges) {
  for (auto kind : solid_kinds) {
    auto m = support::block(kind, {4, 4, 4}, Vec3(1, 1, 1));
    m.faces["both"] = m.faces.at("x1");
    m.faces["both"].insert(m.faces["both"].end(), m.faces.at("y1").begin(), m.faces.at("y1").end());
    const auto depth = [](const Vec3& X) { return 0.01 + 0.01 * X.x(); };
    expect_exact(m, {worn_by(m, "x1", depth), worn_by(m, "z1", depth)});
    expect_exact(m, {worn_by(m, "both", depth), worn_by(m, "z1", depth)});
  }
}

// A block worn evenly must be a shorter block: its top is plane, its edges and sides stay in their planes to the last
// bit, and nodes of the sides and of the inside follow.
TEST(SolidStep, EvenWearShortensABlock) {
  for (auto kind : solid_kinds) {
    const auto m = support::block(kind, {4, 3, 4}, Vec3(1.2, 1, 1));
    auto now = shared(m);
    adapt::SolidRelocationCache cache;
    for (int step = 0; step < 10; ++step) {
      const auto result = evolve_solid(now, m, {worn_by(*now, "z1", [](const Vec3&) { return 0.01; })}, 0.01, &cache);
      ASSERT_TRUE(result.mesh) << result.failure;
      EXPECT_NEAR(result.theta, 1.0, 1e-12);
      now = result.mesh;
    }
    for (int node = 0; node < m.node_count(); ++node) {
      const Vec3 &X = m.X[node], &x = now->X[node];
      EXPECT_NEAR(x.z(), 0.9 * X.z(), X.z() == 1.0 ? 1e-14 : 0.02) << X.transpose();
      if (X.x() == 0.0 || X.x() == 1.2) {
        EXPECT_EQ(x.x(), X.x());
      }
      if (X.y() == 0.0 || X.y() == 1.0) {
        EXPECT_EQ(x.y(), X.y());
      }
      if (X.z() == 0.0) {
        EXPECT_EQ((x - X).norm(), 0.0);
      }
      EXPECT_NEAR(x.x(), X.x(), 0.02);
    }
  }
}

// Of a quarter of a pin whose end wears, nodes on the straight edges of the round side must follow in proportion, on
// the planes of symmetry to the last bit, and the strip stay exact.
TEST(SolidStep, EdgesOfARoundSideFollow) {
  for (auto kind : solid_kinds) {
    auto m = support::block(kind, {4, 4, 4}, Vec3(1, 1, 1), [](const Vec3& X) {
      const double largest = std::max(X.x(), X.y()), norm = X.head<2>().norm();
      return norm > 0.0 ? Vec3(X.x() * largest / norm, X.y() * largest / norm, X.z()) : X;
    });
    for (const char* name : {"x1", "y1"})
      for (int f : m.faces.at(name)) m.skin[f].group = 99;
    auto now = shared(m);
    for (int step = 0; step < 3; ++step) {
      const auto worn = worn_by(*now, "z1", [](const Vec3&) { return 0.03; });
      const auto result = evolve_solid(now, m, {worn}, 0.01);
      ASSERT_TRUE(result.mesh) << result.failure;
      EXPECT_NEAR(result.removed, sum({worn}), 1e-13 * result.removed);
      now = result.mesh;
    }
    for (int node : mesh::nodes_of(m.skin)) {
      const Vec3 &X = m.X[node], &x = now->X[node];
      if (X.x() == 0.0) {
        EXPECT_EQ(x.x(), 0.0) << X.transpose() << " of kind " << static_cast<int>(kind);
      }
      if (X.y() == 0.0) {
        EXPECT_EQ(x.y(), 0.0);
      }
      if (X.x() == 1.0 && X.y() == 0.0) {
        EXPECT_NEAR(x.z(), 0.91 * X.z(), 1e-3);
      }
      if (X.x() == 1.0 && X.y() == 0.0) {
        EXPECT_NEAR(x.x(), 1.0, 1e-12);
      }
    }
  }
}

// A wedge worn by different depths on its two faces must keep its planes: each receded by its own depth, the ridge
// where they meet.
TEST(SolidStep, WedgeWornOnTwoFaces) {
  for (auto kind : solid_kinds) {
    const auto m = support::block(kind, {4, 3, 4}, Vec3(1, 1, 1), [](const Vec3& X) {
      return Vec3(X.x() - 0.4 * X.x() * X.z(), X.y(), X.z());  // the face x1 leans inwards
    });
    const Vec3 n = Vec3(1.0, 0.0, 0.4).normalized(), top = Vec3::UnitZ();
    const auto worn = std::vector{worn_by(m, "x1", [](const Vec3&) { return 0.006; }),
                                  worn_by(m, "z1", [](const Vec3&) { return 0.01; })};
    const auto result = evolve_solid(shared(m), m, worn, 0.01);
    ASSERT_TRUE(result.mesh) << result.failure;
    const auto& X = result.mesh->X;
    for (int node : mesh::nodes_of(mesh::facets_of(m, "x1")))
      EXPECT_NEAR(n.dot(X[node] - m.X[node]), -0.006 * result.theta, 1e-14);
    for (int node : mesh::nodes_of(mesh::facets_of(m, "z1")))
      EXPECT_NEAR(top.dot(X[node] - m.X[node]), -0.01 * result.theta, 1e-14);
    EXPECT_NEAR(result.theta, 1.0, 0.01);
  }
}

// A ball worn evenly must stay a ball: the depth of curved facets is right to the third order.
TEST(SolidStep, EvenWearOfABall) {
  const double depth = 0.02;
  std::vector<double> uneven;
  for (int n : {3, 6}) {
    const auto m = ball(SolidKind::tet10, n, 1.0);
    const auto result = evolve_solid(shared(m), m, {worn_by(m, "ball", [&](const Vec3&) { return depth; })}, 0.01);
    ASSERT_TRUE(result.mesh) << result.failure;
    double least = 1.0, most = 0.0;
    for (int node : mesh::nodes_of(m.skin)) {
      least = std::min(least, m.X[node].norm() - result.mesh->X[node].norm());
      most = std::max(most, m.X[node].norm() - result.mesh->X[node].norm());
    }
    uneven.push_back((most - least) / depth);
  }
  EXPECT_LT(uneven[1], 0.02);
  EXPECT_GT(uneven[0] / uneven[1], 3.0);
}

// A rigid body, which has a skin alone, must wear as one that deforms.
TEST(SolidStep, RigidBodiesWear) {
  for (auto kind : solid_kinds) {
    const auto m = skin_alone(support::block(kind, {5, 5, 3}, Vec3(1, 1, 1)));
    expect_exact(m, {worn_by(m, "z1", dent)});
  }
}

// No wear must give the very same mesh; a loss that is no number, and a face that is not there, must be named.
TEST(SolidStep, NothingAndNonsense) {
  const auto m = shared(support::block(SolidKind::tet4, {2, 2, 2}, Vec3(1, 1, 1)));
  const auto none = worn_by(*m, "z1", [](const Vec3&) { return 0.0; });
  EXPECT_EQ(evolve_solid(m, *m, {none}, 0.01).mesh, m);
  EXPECT_EQ(evolve_solid(m, *m, {}, 0.01).mesh, m);
  auto bad = none;
  bad.removed[3] = -1e-9;
  EXPECT_EQ(evolve_solid(m, *m, {bad}, 0.01).failure, "node 3 of face \"z1\" loses a volume of -1e-09 mm^3");
  bad.removed[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(evolve_solid(m, *m, {bad}, 0.01).mesh);
  EXPECT_THROW(evolve_solid(m, *m, {{"lid", {}}}, 0.01), base::MeshError);
  bad.removed.pop_back();
  bad.removed[3] = 0.0;
  EXPECT_THROW(evolve_solid(m, *m, {bad}, 0.01), std::logic_error);
}

// Inner nodes must take part in the motion once it counts, and stay to the last bit while it does not; with and without
// a cache they come to the same places.
TEST(SolidStep, TheInsideFollowsWhereItMustAndWithoutMemory) {
  for (auto kind : solid_kinds) {
    const auto m = support::block(kind, {5, 5, 5}, Vec3(1, 1, 1));
    const auto deep = [](const Vec3& X) {
      return 0.1 * std::max(0.0, 1.0 - 5.0 * (X - Vec3(0.5, 0.5, 1)).squaredNorm());
    };
    std::vector<char> on_skin(m.X.size(), 0);
    for (int node : mesh::nodes_of(m.skin)) on_skin[node] = 1;
    auto tiny = worn_by(m, "z1", deep);
    for (double& v : tiny.removed) v *= 1e-4;
    auto now = evolve_solid(shared(m), m, {tiny}, 0.01).mesh;
    for (int node = 0; node < m.node_count(); ++node)
      if (!on_skin[node]) {
        EXPECT_EQ(now->X[node], m.X[node]);
      }
    adapt::SolidRelocationCache cache;
    auto cached = now;
    double moved = 0.0;
    for (int step = 0; step < 2; ++step) {
      now = evolve_solid(now, m, {worn_by(*now, "z1", deep)}, 0.01).mesh;
      cached = evolve_solid(cached, m, {worn_by(*cached, "z1", deep)}, 0.01, &cache).mesh;
    }
    for (int node = 0; node < m.node_count(); ++node) {
      EXPECT_EQ(now->X[node], cached->X[node]);
      if (!on_skin[node]) moved = std::max(moved, (now->X[node] - m.X[node]).norm());
    }
    EXPECT_GT(moved, 0.05);
  }
}

// A step that is too long for one part must be split, and its strip stay exact.
TEST(SolidStep, LongStepsAreSplit) {
  const auto m = support::block(SolidKind::tet4, {8, 8, 3}, Vec3(1, 1, 1));
  const auto worn = worn_by(m, "z1", [](const Vec3&) { return 0.25; });
  const auto result = evolve_solid(shared(m), m, {worn}, 1e-3);
  ASSERT_TRUE(result.mesh) << result.failure;
  EXPECT_GE(result.parts, 4);
  EXPECT_NEAR(result.removed, sum({worn}), 1e-13);
}

// What is worn through must be refused with the face it runs into; elements worn flat are reported with their place and
// the depth of wear.
TEST(SolidStep, WornThroughAndPoor) {
  const auto plate = support::block(SolidKind::tet4, {8, 8, 1}, Vec3(1, 1, 0.1));
  auto result =
      evolve_solid(shared(plate), plate, {worn_by(plate, "z1", [](const Vec3& X) { return 4.0 * dent(X); })}, 0.05);
  EXPECT_FALSE(result.mesh);
  EXPECT_NE(result.failure.find("worn through to face \"z0\" at ("), std::string::npos) << result.failure;
  EXPECT_NE(result.failure.find("times the height of the element below"), std::string::npos) << result.failure;
  result = evolve_solid(shared(plate), plate, {worn_by(plate, "z1", [](const Vec3& X) { return 2.3 * dent(X); })}, 0.2);
  ASSERT_TRUE(result.mesh) << result.failure;
  EXPECT_NE(result.poor.find("has shape"), std::string::npos) << result.poor;
  EXPECT_LT(result.min_quality, 0.2);
  result = evolve_solid(shared(plate), plate, {worn_by(plate, "z1", [](const Vec3&) { return 0.12; })}, 0.05);
  EXPECT_FALSE(result.mesh);
}

// A thousand steps must not take more memory than a hundred.
TEST(SolidStep, AThousandStepsKeepMemoryFlat) {
  const auto m = support::block(SolidKind::tet4, {4, 4, 4}, Vec3(1, 1, 1));
  auto now = shared(m);
  adapt::SolidRelocationCache cache;
  const auto resident_kB = [] {
    std::ifstream status("/proc/self/statm");
    long size = 0, resident = 0;
    status >> size >> resident;
    return 4 * resident;
  };
  long before = 0;
  const auto worn = worn_by(m, "z1", [](const Vec3& X) { return 2.5e-3 * dent(X); });
  for (int step = 0; step < 1000; ++step) {
    if (step == 100) before = resident_kB();
    const auto result = evolve_solid(now, m, {worn}, 0.01, &cache);
    ASSERT_TRUE(result.mesh) << result.failure;
    now = result.mesh;
  }
  EXPECT_NEAR(lost(m, *now), 1000.0 * sum({worn}), 1e-11);
  if (!address_sanitizer) {
    EXPECT_LT(resident_kB() - before, 4096);
  }
}

}  // namespace
}  // namespace reye
