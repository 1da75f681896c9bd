#pragma once
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "algebra/decompose.hpp"
#include "body/solid/solid_body.hpp"
#include "mesh/solid/facet_control_points.hpp"
#include "support/solid_blocks.hpp"

/// Supports and bodies of solids for tests.
namespace reye::support::solids {

using base::Mat3;
using base::Matrix;
using base::Points3;
using base::Vec3;
using base::Vector;
using body::Drive;
using body::Motion;
using body::SolidBody;
using body::SolidInput;
using body::SolidSupport;
using mesh::SolidKind;

inline const Motion fixed{Drive::fixed, {}, 0.0};

inline Motion moved(double value, const std::string& history = "") { return {Drive::moved, {{value, history}}, 0.0}; }
inline Motion loaded(double value, double stiffness = 0.0) { return {Drive::loaded, {{value, ""}}, stiffness}; }

inline SolidSupport by_node(const std::string& face, std::array<Motion, 3> along, const Mat3& axes = Mat3::Identity()) {
  SolidSupport s;
  s.name = s.face = face;
  s.along = along;
  s.axes = axes;
  return s;
}

inline SolidSupport along_normal(const std::string& face, const Motion& motion = fixed) {
  SolidSupport s;
  s.name = s.face = face;
  s.normal = motion;
  return s;
}

inline SolidSupport rigid_face(const std::string& face, std::array<Motion, 3> along, std::array<Motion, 3> about,
                               const Mat3& axes = Mat3::Identity()) {
  SolidSupport s = by_node(face, along, axes);
  s.rigid = true;
  s.about = about;
  return s;
}

inline const Mat3 turned = Eigen::AngleAxisd(0.7, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();

/// A block of 1 x 1.2 x 0.8 that is steel, its top bent where `curved`.
inline SolidInput input_of(SolidKind kind, bool curved = false) {
  SolidInput input;
  input.name = "block";
  auto shape = [&](const Vec3& X) {
    return curved ? Vec3(X + 0.1 * X.z() * Vec3(0, 0, std::sin(2 * X.x() + X.y()))) : X;
  };
  input.mesh = std::make_shared<mesh::SolidMesh>(block(kind, {2, 2, 2}, Vec3(1, 1.2, 0.8), shape));
  input.material = material::LinearElastic{1000.0, 0.3};
  return input;
}

inline std::vector<int> nodes_of_face(const mesh::SolidMesh& m, const std::string& face) {
  return mesh::nodes_of(mesh::facets_of(m, face));
}

inline std::vector<mesh::Facet> control_facets(const SolidInput& input) {
  std::vector<mesh::Facet> facets;
  for (const auto& face : input.contact_faces)
    for (const auto& facet : mesh::facets_of(*input.mesh, face)) facets.push_back(facet);
  return facets;
}

inline Vector wave(Eigen::Index n) {
  return Vector::LinSpaced(n, 0.3, 0.3 + 1.7 * static_cast<double>(n)).array().sin();
}

inline Vec3 centre_of(const SolidInput& input, int s) {
  const auto& support = input.supports[s];
  if (support.centre_mm) return *support.centre_mm;
  return mesh::area_centroid(input.mesh->X,
                             support.face.empty() ? input.mesh->skin : mesh::facets_of(*input.mesh, support.face));
}

/// A rigid body: the skin of a curved tet10, its top a contact face.
inline SolidInput rigid_input() {
  SolidInput input = input_of(SolidKind::tet10, true);
  input.rigid = true;
  input.contact_faces = {"z1"};
  auto skin = *input.mesh;
  skin.cells.clear();
  input.mesh = std::make_shared<mesh::SolidMesh>(skin);
  return input;
}

/// Forces on what is retained that balance the loads s in the free motions: A^T f + B s = 0.
inline Vector balanced(const SolidBody& b, const Vector& s) {
  Vector f = wave(b.C().rows());
  f -= b.A() * algebra::solve_symmetric(b.A().transpose() * b.A(), b.A().transpose() * f + b.B() * s);
  return f;
}

}  // namespace reye::support::solids
