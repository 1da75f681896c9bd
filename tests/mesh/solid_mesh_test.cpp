#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <set>

#include "base/errors.hpp"
#include "mesh/solid/facet_control_points.hpp"
#include "support/solid_blocks.hpp"

namespace {

using namespace reye;
using base::Vec2;
using base::Vec3;
using mesh::FacetKind;
using mesh::SolidKind;
using mesh::SolidMesh;
using support::block;
using support::distort;

/// A ball of radius r about c from a cube of n^3 hexahedra or their tetrahedra; mid nodes of tet10 lie on the sphere.
SolidMesh ball(SolidKind kind, int n, double r, const Vec3& c) {
  SolidMesh m = block(kind, {n, n, n}, Vec3(2, 2, 2), [&](const Vec3& X) {
    const Vec3 p = X - Vec3::Ones();
    const double largest = p.cwiseAbs().maxCoeff();
    return Vec3(c + (largest > 0.0 ? Vec3(r * largest * p.normalized()) : p));
  });
  mesh::group_by_angle(m.X, m.skin);
  return m;
}

// Shape functions must add up to one, be one at their own node and zero at the others, and have the gradients that
// differences show.
TEST(solid_shape, is_a_partition_with_true_gradients) {
  const Vec3 xi(0.21, 0.17, 0.31);
  for (auto kind : support::solid_kinds) {
    for (int a = 0; a < mesh::solid_nodes(kind); ++a) {
      mesh::SolidValues expected = mesh::SolidValues::Zero();
      expected[a] = 1.0;
      EXPECT_LT((mesh::shape_functions(kind, mesh::reference_node(kind, a)) - expected).norm(), 1e-14);
    }
    EXPECT_NEAR(mesh::shape_functions(kind, xi).sum(), 1.0, 1e-14);
    const double h = 1e-6;
    for (int c = 0; c < 3; ++c) {
      const mesh::SolidValues slope =
          (mesh::shape_functions(kind, xi + h * Vec3::Unit(c)) - mesh::shape_functions(kind, xi - h * Vec3::Unit(c))) /
          (2.0 * h);
      EXPECT_LT((mesh::shape_gradients(kind, xi).col(c) - slope).norm(), 1e-9);
    }
  }
}

// Shape functions of facets must be such a partition with such gradients, too.
TEST(solid_shape, of_facets_is_a_partition_with_true_gradients) {
  const Vec2 xi(0.23, 0.34);
  for (auto kind : {FacetKind::tri3, FacetKind::quad4, FacetKind::tri6}) {
    for (int a = 0; a < mesh::facet_nodes(kind); ++a) {
      mesh::FacetValues expected = mesh::FacetValues::Zero();
      expected[a] = 1.0;
      EXPECT_LT((mesh::shape_functions(kind, mesh::reference_node(kind, a)) - expected).norm(), 1e-14);
    }
    const double h = 1e-6;
    for (int c = 0; c < 2; ++c) {
      const mesh::FacetValues slope =
          (mesh::shape_functions(kind, xi + h * Vec2::Unit(c)) - mesh::shape_functions(kind, xi - h * Vec2::Unit(c))) /
          (2.0 * h);
      EXPECT_LT((mesh::shape_gradients(kind, xi).col(c) - slope).norm(), 1e-9);
    }
  }
}

// The rules must be exact to the degrees they promise: int x^i y^j z^k over the tetrahedron is i! j! k! / (i+j+k+3)!.
TEST(solid_shape, rules_are_exact_to_their_degree) {
  const auto factorial = [](int n) { return std::tgamma(n + 1.0); };
  const auto error = [&](auto rule, int degree) {
    double worst = 0.0;
    for (int i = 0; i <= degree; ++i)
      for (int j = 0; i + j <= degree; ++j)
        for (int k = 0; i + j + k <= degree; ++k) {
          double sum = 0.0;
          for (const auto& [xi, weight] : rule)
            sum += weight * std::pow(xi.x(), i) * std::pow(xi.y(), j) * std::pow(xi.z(), k);
          worst =
              std::max(worst, std::abs(sum - factorial(i) * factorial(j) * factorial(k) / factorial(i + j + k + 3)));
        }
    return worst;
  };
  EXPECT_LT(error(mesh::stiffness_rule(SolidKind::tet4), 1), 1e-15);
  EXPECT_LT(error(mesh::stiffness_rule(SolidKind::tet10), 2), 1e-15);
  EXPECT_GT(error(mesh::stiffness_rule(SolidKind::tet10), 3), 1e-6);
  EXPECT_LT(error(mesh::volume_rule(SolidKind::tet10), 5), 1e-15);
  for (int i = 0; i <= 6; ++i)
    for (int j = 0; i + j <= 6; ++j) {
      double sum = 0.0;
      for (const auto& [xi, weight] : mesh::area_rule(FacetKind::tri6))
        sum += weight * std::pow(xi.x(), i) * std::pow(xi.y(), j);
      EXPECT_NEAR(sum, factorial(i) * factorial(j) / factorial(i + j + 2), 1e-15);
    }
}

// A block must have the volume, areas, centroid and normals of a block, wherever it lies.
TEST(solid_measure, of_a_block) {
  for (auto kind : support::solid_kinds) {
    const SolidMesh m =
        block(kind, {3, 2, 2}, Vec3(3, 2, 5), [](const Vec3& X) { return Vec3(X + Vec3(1e3, -50, 7)); });
    mesh::check(m);
    EXPECT_NEAR(mesh::volume(m), 30.0, 1e-10);
    EXPECT_LT((mesh::volume_centroid(m) - Vec3(1001.5, -49, 9.5)).norm(), 1e-9);
    EXPECT_NEAR(mesh::area(m.X, mesh::facets_of(m, "z1")), 6.0, 1e-11);
    EXPECT_LT((mesh::area_centroid(m.X, mesh::facets_of(m, "y0")) - Vec3(1001.5, -50, 9.5)).norm(), 1e-10);
    for (const auto& facet : mesh::facets_of(m, "x0"))
      EXPECT_LT((mesh::facet_normal(m.X, facet) + Vec3::UnitX()).norm(), 1e-12);
    std::set<int> groups;
    for (const auto& facet : m.skin) groups.insert(facet.group);
    EXPECT_EQ(groups.size(), 6u);
    const auto box = mesh::bounding_box(m.X);
    EXPECT_NEAR(box[5] - box[2], 5.0, 1e-12);
  }
}

// The volume of a distorted block by its skin must be that of its cells, and a ball of tet10 be a ball to the fourth
// order of the mesh size.
TEST(solid_measure, of_curved_skins) {
  for (auto kind : support::solid_kinds) {
    const SolidMesh m = block(kind, {2, 3, 2}, Vec3(1, 1, 1), distort);
    double cells = 0.0;
    for (const auto& cell : m.cells)
      for (const auto& [xi, weight] : mesh::volume_rule(kind)) {
        const base::Mat3 J = mesh::corners_of(m.X, kind, cell) * mesh::shape_gradients(kind, xi);
        cells += weight * J.col(0).cross(J.col(1)).dot(J.col(2));
      }
    EXPECT_NEAR(mesh::volume(m), cells, 1e-13);
  }
  std::array<double, 2> error;
  for (int k : {0, 1}) {
    const SolidMesh m = ball(SolidKind::tet10, k ? 8 : 4, 2.0, Vec3(3, 1, 2));
    error[k] = std::abs(mesh::volume(m) / (32.0 * std::numbers::pi / 3.0) - 1.0);
    EXPECT_LT((mesh::volume_centroid(m) - Vec3(3, 1, 2)).norm(), 1e-2);
  }
  EXPECT_LT(error[1], 1e-3);
  EXPECT_GT(error[0] / error[1], 12.0);
}

// A cube must have six groups and a ball that is fine enough one; a node on an edge of a cube has a normal per face.
TEST(solid_skin, groups_split_at_an_angle) {
  for (auto kind : support::solid_kinds) {
    std::set<int> groups;
    for (const auto& facet : ball(kind, 8, 1.0, Vec3(0, 0, 0)).skin) groups.insert(facet.group);
    EXPECT_EQ(groups.size(), 1u);
    const SolidMesh cube = block(kind, {2, 2, 2}, Vec3(1, 1, 1));
    std::array<int, 4> nodes_with{};
    std::map<int, int> normals;
    for (const auto& [node, group, normal] : mesh::node_normals(cube.X, cube.skin)) {
      ++normals[node];
      EXPECT_NEAR(normal.cwiseAbs().maxCoeff(), 1.0, 1e-14);
    }
    for (const auto& [node, count] : normals) ++nodes_with[count];
    EXPECT_EQ(nodes_with[3], 8);
  }
}

// Normals of nodes on a fine ball must point outward along the radius.
TEST(solid_skin, normals_point_outward) {
  const SolidMesh m = ball(SolidKind::tet10, 8, 1.0, Vec3(0, 0, 0));
  for (const auto& [node, group, normal] : mesh::node_normals(m.X, m.skin)) EXPECT_GT(normal.dot(m.X[node]), 0.99);
}

// Control points must be exchanged for mid nodes and back without loss, each mid node once though two facets share it.
TEST(control_points_of_facets, there_and_back) {
  const SolidMesh m = block(SolidKind::tet10, {2, 2, 2}, Vec3(1, 1, 1), distort);
  const auto facets = mesh::facets_of(m, "z1");
  const auto P = mesh::control_points(facets, m.X), back = mesh::middle_nodes(facets, P);
  double change = 0.0;
  for (int k = 0; k < m.node_count(); ++k) {
    EXPECT_LT((back[k] - m.X[k]).norm(), 1e-15);
    change = std::max(change, (P[k] - m.X[k]).norm());
  }
  EXPECT_GT(change, 1e-3);
  const auto& f = facets.front().nodes;
  EXPECT_LT((P[f[3]] - (2.0 * m.X[f[3]] - 0.5 * (m.X[f[0]] + m.X[f[1]]))).norm(), 1e-15);
}

template <class Change>
std::string refusal(SolidMesh m, Change change) {
  change(m);
  try {
    mesh::check(m);
  } catch (const base::MeshError& error) {
    return error.what();
  }
  return "accepted";
}

// Every broken invariant must be refused with what is broken and where.
TEST(solid_check, refuses_what_is_broken) {
  const auto says = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  for (auto kind : support::solid_kinds) {
    const SolidMesh m = block(kind, {2, 2, 2}, Vec3(1, 1, 1));
    EXPECT_EQ(refusal(m, [](SolidMesh&) {}), "accepted");
    says(refusal(m, [](SolidMesh& s) { s.X[3] = Vec3::Constant(std::nan("")); }), "node 3 has no finite");
    says(refusal(m, [](SolidMesh& s) { s.X.push_back(Vec3(9, 9, 9)); }), "at (9, 9, 9) belongs to no cell");
    says(refusal(m, [](SolidMesh& s) { s.cells[1][0] = 99999; }), "cell 1 names node 99999");
    says(refusal(m, [](SolidMesh& s) { s.cells[1][0] = s.cells[1][1]; }), "twice");
    says(refusal(m, [](SolidMesh& s) { s.X[13] = Vec3(0.5, 0.5, 3.0); }), "is folded over or flat");
    says(refusal(m, [](SolidMesh& s) { s.skin.pop_back(); }), "is not closed");
    says(refusal(m, [](SolidMesh& s) { std::swap(s.skin[0].nodes[0], s.skin[0].nodes[1]); }), "is not closed");
    says(refusal(m, [](SolidMesh& s) { s.skin.clear(); }), "no skin");
    says(refusal(m, [](SolidMesh& s) { s.faces["z1"] = {}; }), "\"z1\" has no facet");
    says(refusal(m, [](SolidMesh& s) { s.faces["z1"] = {4000}; }), "names facet 4000");
    says(refusal(m, [](SolidMesh& s) { s.cells.push_back(s.cells[0]); }), "share one face");
  }
}

// Of a rigid body the skin alone must pass, and one that faces inwards must not.
TEST(solid_check, of_a_rigid_skin) {
  SolidMesh m = ball(SolidKind::hex8, 4, 1.0, Vec3(0, 0, 0));
  m.cells.clear();
  SolidMesh skin{{}, m.kind, {}, m.skin, {}};
  std::map<int, int> number;
  for (auto& facet : skin.skin)
    for (int a = 0; a < facet.count(); ++a) {
      const auto [place, fresh] = number.try_emplace(facet.nodes[a], skin.node_count());
      if (fresh) skin.X.push_back(m.X[facet.nodes[a]]);
      facet.nodes[a] = place->second;
    }
  mesh::check(skin);
  for (auto& facet : skin.skin) std::swap(facet.nodes[0], facet.nodes[2]);
  EXPECT_THROW(mesh::check(skin), base::MeshError);
  EXPECT_THROW(mesh::check(m), base::MeshError);  // nodes inside belong to no facet
}

// Quality must be one of regular cells, less of others, and find the poorest.
TEST(solid_quality, of_regular_and_flat_cells) {
  const double s = std::sqrt(2.0);
  const base::Points3 regular{{1, 0, -1 / s}, {-1, 0, -1 / s}, {0, -1, 1 / s}, {0, 1, 1 / s}};
  const double q = mesh::shape_quality(regular, SolidKind::tet4, {0, 1, 2, 3, -1, -1, -1, -1, -1, -1});
  EXPECT_NEAR(std::abs(q), 1.0, 1e-14);
  SolidMesh m = block(SolidKind::hex8, {2, 2, 2}, Vec3(1, 1, 1));
  EXPECT_NEAR(mesh::poorest_cell(m).quality, 1.0, 1e-14);
  m.X[13] += Vec3(0.2, 0.2, 0.2);
  EXPECT_EQ(mesh::poorest_cell(m).cell, 7);
}

}  // namespace
