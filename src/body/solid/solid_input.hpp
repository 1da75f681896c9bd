#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/linalg.hpp"
#include "base/space.hpp"
#include "body/solid/solid_supports.hpp"
#include "material/material.hpp"
#include "mesh/solid/solid_mesh.hpp"

namespace reye::body {

using base::Matrix;
using base::Points3;
using base::Vec3;
using base::Vector;

struct SolidInput {
  std::string name;
  std::shared_ptr<const mesh::SolidMesh> mesh;
  bool rigid = false;
  material::Material material;  ///< of a body that deforms: linear_elastic
  std::vector<SolidSupport> supports;
  std::vector<SolidLoad> loads;
  /// Faces whose skin meets others in contact: on tri6 facets the displacements of their mid nodes are exchanged for
  /// Bernstein control points, u_m = b_m / 2 + (u_1 + u_2) / 4, and retained nodes are then these control points.
  std::vector<std::string> contact_faces;
  /// About which it turns where no support guides it; by default the centre of its box. It does not follow the shape.
  std::optional<Vec3> centre_mm{};
};

/// A driven quantity of a body that its equations take as given: an imposed motion [mm or rad], or a load's factor.
/// The value at a moment of a step is the sum of its parts.
struct Driven {
  int support = -1;  ///< of `SolidInput::supports`, or
  int load = -1;     ///< of `SolidInput::loads`
  int motion = 0;    ///< of the support: 0 to 2 along, 3 to 5 about, 6 normal
  base::Parts parts{};
};

}  // namespace reye::body
