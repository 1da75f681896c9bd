#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapt/fields.hpp"
#include "adapt/transfer/transfer.hpp"
#include "mesh/quality.hpp"
#include "support/meshes.hpp"
#include "support/surfaces.hpp"

namespace reye {
namespace {

using namespace support;  // NOLINT: test vocabulary
using adapt::Field;
using adapt::transfer;

constexpr double any_distance = 1e300;

/// A field of two components on the nodes.
template <class F>
Field nodal(const Mesh& m, F f) {
  Field field{"field", 2, {}};
  for (const Vec2& x : m.X)
    for (double v : f(x)) field.values.push_back(v);
  return field;
}

Field random_field(std::size_t items, int components) {
  std::mt19937 random(11);
  Field field{"noise", components, {}};
  for (std::size_t k = 0; k < items * components; ++k) field.values.push_back(noise(random));
  return field;
}

double largest_field_difference(const Field& a, const Field& b) {
  EXPECT_EQ(a.values.size(), b.values.size());
  double largest = 0.0;
  for (std::size_t k = 0; k < a.values.size(); ++k) largest = std::max(largest, std::abs(a.values[k] - b.values[k]));
  return largest;
}

double rms_difference(const Field& a, const Field& b) {
  double square = 0.0;
  for (std::size_t k = 0; k < a.values.size(); ++k) square += std::pow(a.values[k] - b.values[k], 2);
  return std::sqrt(square / static_cast<double>(a.values.size()));
}

// To the same mesh every value comes back to the bit, with its name and components.
TEST(Transfer, IdentityIsExact) {
  for (auto kind : linear_kinds) {
    const auto mesh = turned(rectangle({.nx = 13, .ny = 9, .kind = kind, .distortion = 0.9}), 0.3);
    const std::vector<Field> fields{random_field(mesh.X.size(), 2), random_field(mesh.X.size(), 1)};
    const auto result = transfer(mesh, fields, mesh, 0.0);
    ASSERT_EQ(result.failure, "");
    EXPECT_EQ(result.largest_distance, 0.0);
    ASSERT_EQ(result.fields.size(), 2U);
    for (int k : {0, 1}) {
      EXPECT_EQ(result.fields[k].values, fields[k].values);
      EXPECT_EQ(result.fields[k].components, fields[k].components);
      EXPECT_EQ(result.fields[k].name, "noise");
    }
  }
}

// Affine fields are exact between any two meshes of a body, triangles and quadrilaterals, coarse to fine and back.
TEST(Transfer, AffineFieldsAreExact) {
  for (auto kind : linear_kinds)
    for (auto other : linear_kinds)
      for (int n : {5, 12, 31}) {
        const auto from = turned(rectangle({.nx = 12, .ny = 7, .kind = kind, .distortion = 0.9}), 0.3);
        const auto to = turned(rectangle({.nx = n, .ny = n + 2, .kind = other, .distortion = 0.7}), 0.3);
        const auto result = transfer(from, {nodal(from, affine_field)}, to, 1e-12);
        ASSERT_EQ(result.failure, "");
        EXPECT_LT(largest_field_difference(result.fields[0], nodal(to, affine_field)), 1e-13);
      }
}

// Affine fields are exact even when the old mesh has inverted cells.
TEST(Transfer, AffineFieldsAreExactFromRuinedMeshes) {
  for (auto kind : linear_kinds) {
    const auto from = rectangle({.nx = 20, .ny = 20, .kind = kind, .distortion = 2.5});
    const auto to = rectangle({.nx = 33, .ny = 31, .kind = kind, .distortion = 0.5});
    ASSERT_LT(mesh::poorest_cell(from).scaled_jacobian, -0.1);
    const auto result = transfer(from, {nodal(from, affine_field)}, to, 1e-12);
    ASSERT_EQ(result.failure, "");
    EXPECT_LT(largest_field_difference(result.fields[0], nodal(to, affine_field)), 1e-13);
  }
}

// A fine box that moves: affine fields are exact from cells of a tenth to ten times the size.
TEST(Transfer, FineBoxMoves) {
  const auto fine_at = [](double c) {
    return mapped(rectangle({.size = {2.0, 1.0}, .nx = 80, .ny = 20}), [c](Vec2 x) {
      const double half = x.x() < 1.0 ? c : 2.0 - c, t = x.x() - 1.0;  // x'(1) is small, the ends stay
      return Vec2(c + half * (0.05 * t + 0.95 * t * t * t), 1.0 - std::pow(1.0 - x.y(), 3));
    });
  };
  const auto from = fine_at(0.9), to = fine_at(1.1);
  const auto result = transfer(from, {nodal(from, affine_field)}, to, 1e-12);
  ASSERT_EQ(result.failure, "");
  EXPECT_LT(largest_field_difference(result.fields[0], nodal(to, affine_field)), 1e-12);
}

// A smooth field loses at second order of the old mesh size, on curved bodies too, where new nodes lie outside.
TEST(Transfer, SecondOrder) {
  for (auto kind : linear_kinds) {
    std::vector<double> errors;
    for (int n : {8, 16, 32, 64}) {
      const auto from = ring({.across = n, .around = 2 * n, .kind = kind});
      const auto to = ring({.across = 5 * n / 4, .around = 9 * n / 4, .kind = kind});
      const auto result = transfer(from, {nodal(from, smooth_field)}, to, 1.0);
      EXPECT_GT(result.largest_distance, 0.0);
      errors.push_back(rms_difference(result.fields[0], nodal(to, smooth_field)));
    }
    for (int k = 0; k < 3; ++k) EXPECT_GT(std::log2(errors[k] / errors[k + 1]), 1.9);
    RecordProperty(kind == CellKind::tri3 ? "tri3_finest" : "quad4_finest", std::to_string(errors.back()));
  }
}

// A new node just outside takes the value of the closest point, and the farthest one is reported.
TEST(Transfer, NodesJustOutside) {
  const auto from = rectangle({.nx = 6, .ny = 6, .distortion = 0.5});
  const auto to = mapped(rectangle({.nx = 7, .ny = 5}), [](Vec2 x) { return Vec2(1.002 * x); });
  const auto result = transfer(from, {nodal(from, affine_field)}, to, 0.01);
  ASSERT_EQ(result.failure, "");
  EXPECT_NEAR(result.largest_distance, 0.002 * std::sqrt(2.0), 1e-14);
  const auto clamped = mapped(to, [](Vec2 x) { return Vec2(x.cwiseMin(1.0)); });
  EXPECT_LT(largest_field_difference(result.fields[0], nodal(clamped, affine_field)), 1e-13);
}

// A mesh that does not belong to the body is refused: which node, where, how far, the bound; no field comes back.
TEST(Transfer, FarNodesAreRefused) {
  const auto from = rectangle({.nx = 4, .ny = 4});
  const auto to = rectangle({.corner = {0.25, 0.0}, .nx = 4, .ny = 4});
  const auto result = transfer(from, {nodal(from, affine_field)}, to, 0.1);
  EXPECT_EQ(result.failure,
            "node 4 of the new mesh at (1.25, 0) mm lies 0.25 mm outside the old mesh, more than 0.1 mm");
  EXPECT_TRUE(result.fields.empty());
  EXPECT_EQ(result.largest_distance, 0.25);
}

// No fields cost nothing: not even meshes that cannot be searched are read.
TEST(Transfer, NothingIsBuiltWithoutFields) {
  const auto result = transfer(Mesh{}, {}, rectangle({}), 0.0);
  EXPECT_EQ(result.failure, "");
  EXPECT_EQ(result.largest_distance, 0.0);
  EXPECT_TRUE(result.fields.empty());
}

// Between straight meshes of second order, T6 distorted, quadratic fields are carried exactly.
TEST(Transfer, SecondOrderCarriesQuadratics) {
  const auto quadratic = [](const Vec2& x) { return 1.0 + x.x() - 3.0 * x.x() * x.y() + 2.0 * x.y() * x.y(); };
  for (auto kind : {CellKind::tri6, CellKind::quad8}) {
    const auto from = rectangle({.nx = 7, .ny = 6, .kind = kind, .distortion = kind == CellKind::tri6 ? 0.8 : 0.0});
    const auto to = rectangle({.nx = 5, .ny = 9, .kind = kind, .distortion = 0.5});
    Field field{"f", 1, {}};
    for (const Vec2& x : from.X) field.values.push_back(quadratic(x));
    const auto values = transfer(from, {field}, to, any_distance).fields.at(0).values;
    for (std::size_t k = 0; k < to.X.size(); ++k) EXPECT_NEAR(values[k], quadratic(to.X[k]), 1e-13);
  }
}

}  // namespace
}  // namespace reye
