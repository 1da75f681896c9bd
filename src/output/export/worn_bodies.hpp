#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "mesh/solid/solid_mesh.hpp"

/// Bodies of a frame read back as meshes on X, the worn, stress-free shape.
namespace reye::output {

/// A plane or axisymmetric body with its outline; a rigid one has no cells.
struct WornBody {
  std::string name;
  int index = 0;  ///< in the frame
  mesh::Mesh mesh;
  std::vector<double> wear_depth_mm;  ///< at the nodes
};

/// A solid with its skin; a rigid one has no cells.
struct WornSolid {
  std::string name;
  int index = 0;
  mesh::SolidMesh mesh;
};

/// Reads a .vtu that `bodies_vtu` made; throws base::InputError when it cannot.
std::vector<WornBody> read_worn_bodies(const std::string& path);

/// Likewise one that `solid_bodies_vtu` made.
std::vector<WornSolid> read_worn_solids(const std::string& path);

}  // namespace reye::output
