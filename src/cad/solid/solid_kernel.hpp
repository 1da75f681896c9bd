#pragma once
#include "cad/part/raw.hpp"
#include "cad/solid/raw_solid.hpp"
#include "cad/solid/skin_surface.hpp"

namespace reye::cad {

/// What the library of gmsh (`cad/meshing/kernel`) does with solids. It holds one model at a time, from its opening to
/// the end of the program.
struct SolidKernel {
  /// The solids of a file. Throws base::InputError (key "geometry").
  std::vector<RawSolid> (*open)(const std::string& path, Format format, const Points3& probes);
  /// The mesh of one of them. Throws base::MeshError.
  RawSolidMesh (*mesh)(const SolidOrder& order);
  /// Tetrahedra in a closed surface. Throws base::MeshError.
  RawSolidMesh (*fill)(const SkinFilling& filling);
};

/// Loads it; throws std::runtime_error when it is not found.
const SolidKernel& solid_kernel();

std::vector<RawSolid> open_by_gmsh(const std::string& path, Format format, const Points3& probes);
RawSolidMesh mesh_by_gmsh(const SolidOrder& order);
RawSolidMesh fill_skin_by_gmsh(const SkinFilling& filling);

}  // namespace reye::cad
