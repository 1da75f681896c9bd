#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/errors.hpp"
#include "fem/assemble_loads.hpp"
#include "support/meshes.hpp"

namespace {

using namespace reye;
using base::Analysis;
using base::Vec2;
using base::Vector;
using support::rectangle;

Vec2 force(const Vector& f) {
  Vec2 sum{0, 0};
  for (int k = 0; k < f.size(); k += 2) sum += f.segment<2>(k);
  return sum;
}

double moment(const mesh::Mesh& m, const Vector& f) {
  double sum = 0.0;
  for (int k = 0; k < m.node_count(); ++k) sum += base::cross(m.X[k], f.segment<2>(2 * k));
  return sum;
}

// Pressure on an interval must give p times its length, at its middle, with facets cut at both ends,
// the arc length counted from the end with smaller x although the chain runs the other way.
TEST(loads, interval_gives_exact_resultant) {
  const auto m = rectangle({.corner = {1, 0}, .size = {3, 2}, .nx = 7, .ny = 5});
  const Vector f = fem::load_vector(m, Analysis::plane_strain, {"p", "top", 8.0, {0, 0}, {{0.31, 1.73}}, ""});
  EXPECT_NEAR(force(f).x(), 0.0, 1e-13);
  EXPECT_NEAR(force(f).y(), -8.0 * 1.42, 1e-12);
  EXPECT_NEAR(moment(m, f), -8.0 * 1.42 * (1 + 0.5 * (0.31 + 1.73)), 1e-12);
}

// Where both ends have the same x the arc length must start at the smaller y.
TEST(loads, vertical_edges_count_upwards) {
  const auto m = rectangle({.size = {3, 2}, .nx = 4, .ny = 5});
  for (const char* edge : {"left", "right"}) {
    const Vector f = fem::load_vector(m, Analysis::plane_stress, {"p", edge, 0.0, {2.0, 0.0}, {{0.1, 0.5}}, ""});
    EXPECT_NEAR(force(f).x(), 0.8, 1e-13);
    EXPECT_NEAR(moment(m, f), -0.8 * 0.3, 1e-13);
  }
}

// Pressure must push on the body from every side, and on a closed outline balance itself.
TEST(loads, pressure_pushes_on_the_body) {
  auto m = support::turned(rectangle({.size = {3, 2}}), 0.4);
  const Vector f = fem::load_vector(m, Analysis::plane_strain, {"p", "bottom", 5.0, {0, 0}, {}, ""});
  EXPECT_LT((force(f) - 15.0 * Vec2{-std::sin(0.4), std::cos(0.4)}).norm(), 1e-12);
  m.boundaries["all"] = {m.outline.front()};
  const Vector g = fem::load_vector(m, Analysis::plane_strain, {"p", "all", 5.0, {0, 0}, {}, ""});
  EXPECT_LT(force(g).norm(), 1e-12);
  EXPECT_NEAR(moment(m, g), 0.0, 1e-12);
}

// In axisymmetry a part of an edge must carry the pressure times the area of its ring.
TEST(loads, ring_pressure_has_exact_resultant) {
  const auto m = rectangle({.corner = {1, 0}, .size = {3, 2}, .nx = 4});
  const Vector f = fem::load_vector(m, Analysis::axisymmetric, {"p", "top", 8.0, {0, 0}, {{0.3, 1.7}}, ""});
  EXPECT_NEAR(force(f).y(), -8.0 * std::numbers::pi * (2.7 * 2.7 - 1.3 * 1.3), 1e-11);
}

// A body force must add up to force density times volume, and act at the centroid.
TEST(loads, body_force_has_exact_resultant) {
  for (auto kind : {mesh::CellKind::tri3, mesh::CellKind::quad4, mesh::CellKind::tri6, mesh::CellKind::quad8}) {
    const auto m = rectangle({.corner = {1, 0}, .size = {3, 2}, .kind = kind, .distortion = 0.7});
    const fem::BodyForce b{"g", "", {0.5, -2.0}, ""};
    const Vector f = fem::load_vector(m, Analysis::plane_strain, b);
    EXPECT_LT((force(f) - 6.0 * Vec2{0.5, -2.0}).norm(), 1e-12);
    EXPECT_NEAR(moment(m, f), 6.0 * base::cross(Vec2{2.5, 1.0}, Vec2{0.5, -2.0}), 1e-12);
    const Vector r = fem::load_vector(m, Analysis::axisymmetric, b);
    EXPECT_NEAR(force(r).y(), -2.0 * 2 * std::numbers::pi * 2.5 * 6.0, 1e-10);
  }
}

// A point load must act at the nearest node.
TEST(loads, point_load_takes_the_nearest_node) {
  const auto m = rectangle({.size = {3, 2}, .nx = 3, .ny = 2});
  const Vector f = fem::load_vector(m, Analysis::plane_strain, fem::PointLoad{"f", "", {2.9, 1.2}, {3, -4}, ""});
  EXPECT_EQ(f[2 * support::node_at(m, {3, 1}) + 1], -4.0);
  EXPECT_EQ(force(f), Vec2(3, -4));
}

// An unknown edge and an interval beside the edge must be input errors.
TEST(loads, bad_edges_are_input_errors) {
  const auto m = rectangle({});
  EXPECT_THROW(fem::load_vector(m, Analysis::plane_strain, {"p", "roof", 1, {0, 0}, {}, ""}), base::InputError);
  EXPECT_THROW(fem::load_vector(m, Analysis::plane_strain, {"p", "top", 1, {0, 0}, {{1.2, 1.5}}, ""}),
               base::InputError);
}

}  // namespace
