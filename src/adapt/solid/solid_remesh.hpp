#pragma once
#include <memory>
#include <string>
#include <vector>

#include "cad/solid/raw_solid.hpp"
#include "mesh/solid/solid_mesh.hpp"

namespace reye::adapt {

/// What becomes of the facets of the scar: drawn again where they have lost their shape, kept, or all drawn again.
enum class ScarRoute { where_poor, keep, redraw };

struct SolidRemeshOptions {
  double far_size_mm = 0.0;  ///< of elements far from the skin; 0: the largest mean edge of a cell at birth
  double growth = 1.3;
  std::vector<cad::SizeZone> zones{};
  ScarRoute scar = ScarRoute::where_poor;
};

struct SolidRemeshResult {
  std::shared_ptr<const mesh::SolidMesh> mesh;  ///< null when it failed
  int fresh_facets = 0;                         ///< of the skin
  int straightened = 0;                         ///< edges of the skin whose mid nodes left no room for a sound cell
  double volume_residue = 0.0;                  ///< that the fresh skin lacked before the correction [mm^3]
  double correction_mm = 0.0;                   ///< by which the nodes of the scar moved for it
  double quality = 1.0;                         ///< smallest shape of a cell
  double mesh_seconds = 0.0;
  std::string failure;  ///< empty; else why there is no mesh
};

/// Whether `remesh_solid` takes such a mesh.
bool can_be_remeshed(const mesh::SolidMesh& mesh);

/// A fresh mesh of tetrahedra inside the worn skin, with the same faces and groups and, to round-off, the same volume.
/// Facets that have not moved since `born` stay node by node, and so do those of the scar unless they are poor: then
/// they are drawn again between their borders and creases, and where that cannot be filled they stay after all. A rigid
/// body has its scar drawn again. In second order mid nodes of fresh facets lie on the worn surface, inner edges are
/// straight. Hexahedra are not remeshed.   (README, 17)
SolidRemeshResult remesh_solid(const mesh::SolidMesh& worn, const mesh::SolidMesh& born,
                               const SolidRemeshOptions& options = {});

}  // namespace reye::adapt
