#pragma once
#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/issue.hpp"
#include "base/space.hpp"
#include "mesh/solid/solid_mesh.hpp"

/// What the importer and the program exchange about the solids in a file. Lengths in mm.
namespace reye::cad {

using base::Points3;

enum class FaceType { plane, cylinder, sphere, cone, torus, spline };

/// "plane", "cylinder", ... as the scene names it.
std::string to_string(FaceType type);

using SolidBox = std::array<double, 6>;  ///< x_min, y_min, z_min, x_max, y_max, z_max

/// A face of a solid.
struct RawFace {
  int tag = 0;  ///< within its file: solids that hold the same tag share the face
  FaceType type = FaceType::spline;
  SolidBox box_mm{};
  double area_mm2 = 0.0;
  std::set<std::string> names;      ///< of its physical surfaces
  std::vector<double> distance_mm;  ///< from each probe
};

/// The corners of a facet in ascending order; that of a triangle begins with -1.
using FacetCorners = std::array<int, 4>;

/// Cells and skin. Facets are not turned outward yet; their group is the place of their face in the solid's list.
struct RawSolidMesh {
  Points3 nodes;
  mesh::SolidKind kind = mesh::SolidKind::tet4;
  std::vector<mesh::SolidCell> cells;                   ///< none of a rigid body
  std::vector<mesh::Facet> facets;                      ///< of the skin; none of a mesh that came with its file
  std::map<FacetCorners, std::set<std::string>> names;  ///< physical surfaces of a mesh that came with its file
};

/// A solid of a file: one volume, or all of a physical group.
struct RawSolid {
  std::string file;  ///< that holds it, as the options name it
  std::string label;
  bool group = false;  ///< the label is a physical group: its volumes are one body
  std::vector<int> volumes;
  double volume_mm3 = 0.0;
  SolidBox box_mm{};
  std::vector<RawFace> faces;
  std::vector<char> inside;  ///< whether each probe is
  RawSolidMesh mesh;         ///< that came with its file
};

/// A ball or box in which the mesh has one size.
struct SizeZone {
  base::Vec3 centre = base::Vec3::Zero();
  double radius = 0.0;                          ///< > 0: a ball
  base::Vec3 half_widths = base::Vec3::Zero();  ///< else a box
  double size = 0.0;

  /// Of p from the ball or box, zero inside.
  double distance(const base::Vec3& p) const;
};

/// How a solid is to be meshed.
struct SolidOrder {
  std::vector<int> volumes;
  bool skin_only = false;
  bool second_order = false;
  double far_size = 1.0;
  double growth = 1.3;
  std::vector<SizeZone> zones;
};

/// The points that the program wants to know of whether solids hold them and how far faces are.
struct SolidQuery {
  Points3 probes;
};

/// The importer's answer to a query: the solids of a file, or what is wrong with it.
struct SolidAnswer {
  std::vector<RawSolid> solids;
  std::vector<base::Issue> issues;
};

/// The importer's answer to an order: the mesh, or why there is none.
struct SolidMeshAnswer {
  RawSolidMesh mesh;
  std::string failure;
};

}  // namespace reye::cad
