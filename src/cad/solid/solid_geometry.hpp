#pragma once
#include <array>
#include <string>
#include <vector>

#include "cad/solid/solid_options.hpp"
#include "mesh/solid/solid_mesh.hpp"

namespace reye::cad {

/// The facts of one body that `reye check` prints.
struct SolidFacts {
  std::string name;
  double volume_mm3 = 0.0;
  std::array<double, 6> box_mm{};               ///< x_min, y_min, z_min, x_max, y_max, z_max
  std::map<std::string, double> face_area_mm2;  ///< of the named faces
};

struct SolidGeometry {
  std::vector<mesh::SolidMesh> bodies;  ///< in the order of the options; a rigid body has a skin, no cells
  std::vector<SolidFacts> facts;
  std::vector<std::string> warnings;  ///< what a user must know of a file, one sentence each
  bool guarded = true;                ///< false: the readers of files were restricted by their own limits alone
};

/// Imports the files, finds solids and faces by their selectors, meshes and checks every body. Nodes of two bodies are
/// distinct even where their CAD coincides. Throws base::InputError (all issues together; keys "geometry",
/// "body.<name>", "body.<name>.at", "face.<name>.box_mm" ...).
SolidGeometry build_solids(const SolidGeometryOptions& options);

}  // namespace reye::cad
