#pragma once
#include <array>
#include <map>
#include <string>
#include <vector>

#include "base/space.hpp"

/// Meshes of solids: cells in space, and the skin that bounds them.
namespace reye::mesh {

using base::Points3;
using base::Vec3;

enum class SolidKind { tet4, tet10, hex8 };
enum class FacetKind { tri3, quad4, tri6 };

inline constexpr int most_solid_nodes = 10;
inline constexpr int most_facet_nodes = 6;

/// Nodes of one cell in VTK's order: corners, then for tet10 the mid nodes of the edges 01, 12, 02, 03, 13, 23.
/// Entries beyond the nodes of the kind are -1.
using SolidCell = std::array<int, most_solid_nodes>;

inline int solid_nodes(SolidKind kind) { return kind == SolidKind::tet4 ? 4 : kind == SolidKind::hex8 ? 8 : 10; }
inline int facet_nodes(FacetKind kind) { return kind == FacetKind::tri3 ? 3 : kind == FacetKind::quad4 ? 4 : 6; }
inline int facet_corners(FacetKind kind) { return kind == FacetKind::quad4 ? 4 : 3; }
inline FacetKind facet_kind(SolidKind kind) {
  return kind == SolidKind::tet4 ? FacetKind::tri3 : kind == SolidKind::hex8 ? FacetKind::quad4 : FacetKind::tri6;
}

/// A facet of the skin: its corners counter-clockwise seen from outside, then for tri6 the mid nodes of the edges 01,
/// 12, 20. Entries beyond the nodes of the kind are -1.
struct Facet {
  FacetKind kind = FacetKind::tri3;
  std::array<int, most_facet_nodes> nodes{-1, -1, -1, -1, -1, -1};
  int group = 0;  ///< facets of one group are smooth with each other: of one face of the CAD, or at a small angle

  int count() const { return facet_nodes(kind); }
};

/// The mesh of one solid on its material configuration X [mm]. A value. All cells are of one kind; every node belongs
/// to a cell, every cell has a positive Jacobian. A rigid body has a skin and no cells.
struct SolidMesh {
  Points3 X;
  SolidKind kind = SolidKind::tet4;
  std::vector<SolidCell> cells;
  std::vector<Facet> skin;                        ///< the whole closed boundary
  std::map<std::string, std::vector<int>> faces;  ///< named in the scene or by physical surfaces: facets of the skin

  int node_count() const { return static_cast<int>(X.size()); }
  int cell_count() const { return static_cast<int>(cells.size()); }
};

}  // namespace reye::mesh
