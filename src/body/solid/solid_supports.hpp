#pragma once
#include <array>
#include <optional>
#include <string>

#include "base/space.hpp"
#include "body/supports.hpp"

namespace reye::body {

/// A support on a face of a solid (of a rigid solid: on the whole body, `face` empty or one of its faces).
/// By node (`rigid` false): each node of the face takes the same imposed value of the held directions of `axes`
/// (columns: x, y, z of the support; unit, orthogonal) and is free in the others; `normal`, where held, acts along the
/// normal of the facets at each node, so that on a plane it is symmetry. Rigid: the face moves as a rigid body with six
/// shared motions, u = t + theta x (X - centre), each fixed, moved, loaded (with or without a spring) or free.
struct SolidSupport {
  std::string name;
  std::string face;
  std::string body;  ///< filled where `face` is empty; else it follows from the face
  base::Mat3 axes = base::Mat3::Identity();
  bool rigid = false;
  std::array<Motion, 3> along{};  ///< x, y, z of the support [mm; N; N/mm]
  std::array<Motion, 3> about{};  ///< rotation about these axes through `centre` [rad; N mm; N mm/rad]; rigid only
  Motion normal{};                ///< by node only
  std::optional<base::Vec3> centre_mm{};  ///< of rotation and of moments; default: the area's centroid of the face
};

/// What acts on a solid. One of: pressure and traction on a face, a force per volume on the body.
struct SolidLoad {
  std::string name;
  std::string face;
  std::string body;                              ///< of the force per volume
  double pressure_MPa = 0.0;                     ///< > 0 pushes on the body
  base::Vec3 traction_MPa = base::Vec3::Zero();  ///< adds to the pressure
  base::Vec3 force_N = base::Vec3::Zero();       ///< on the whole face, spread evenly over its area
  base::Vec3 force_N_per_mm3 = base::Vec3::Zero();
  std::string history;  ///< empty: full from the start
};

}  // namespace reye::body
