#include "mesh/solid/solid_place.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <limits>

#include "mesh/solid/solid_shape.hpp"

namespace reye::mesh {

namespace {

/// How far a reference place lies outside of its cell; zero or less inside.
double outside(SolidKind kind, const Vec3& xi) {
  if (kind == SolidKind::hex8) return xi.cwiseAbs().maxCoeff() - 1.0;
  return std::max({-xi.minCoeff(), xi.sum() - 1.0});
}

/// The reference place of x by Newton's iteration from the middle.
Vec3 reference_place(const SolidMesh& mesh, const SolidCell& cell, const Vec3& x) {
  const int count = solid_nodes(mesh.kind);
  Vec3 xi = mesh.kind == SolidKind::hex8 ? Vec3(Vec3::Zero()) : Vec3(Vec3::Constant(0.25));
  for (int turn = 0; turn < 20; ++turn) {
    const SolidValues N = shape_functions(mesh.kind, xi);
    const SolidGradients dN = shape_gradients(mesh.kind, xi);
    Vec3 rest = x;
    base::Mat3 J = base::Mat3::Zero();
    for (int a = 0; a < count; ++a) {
      rest -= N[a] * mesh.X[cell[a]];
      J += mesh.X[cell[a]] * dN.row(a);
    }
    const Vec3 step = J.inverse() * rest;
    if (!step.allFinite()) return Vec3::Constant(std::numeric_limits<double>::infinity());
    xi += step;
    if (step.norm() < 1e-12) break;
  }
  return xi;
}

bool near_cell(const SolidMesh& mesh, const SolidCell& cell, const Vec3& x) {
  Eigen::AlignedBox3d box;
  for (int a = 0; a < solid_nodes(mesh.kind); ++a) box.extend(mesh.X[cell[a]]);
  const Vec3 margin = Vec3::Constant(0.2 * box.diagonal().norm());
  return Eigen::AlignedBox3d(box.min() - margin, box.max() + margin).contains(x);
}

}  // namespace

std::vector<std::pair<int, double>> place_in(const SolidMesh& mesh, const Vec3& x) {
  constexpr double beside = 0.1;
  double least = beside;
  std::vector<std::pair<int, double>> place;
  for (const auto& cell : mesh.cells) {
    if (!near_cell(mesh, cell, x)) continue;
    const Vec3 xi = reference_place(mesh, cell, x);
    const double out = outside(mesh.kind, xi);
    if (!(out < least)) continue;
    least = out;
    place.clear();
    const SolidValues N = shape_functions(mesh.kind, xi);
    for (int a = 0; a < solid_nodes(mesh.kind); ++a) place.emplace_back(cell[a], N[a]);
    if (least <= 0.0) break;
  }
  return place;
}

}  // namespace reye::mesh
