#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/space.hpp"
#include "mesh/solid/solid_mesh.hpp"

/// Options of a scene of solids for geometry and mesh. Lengths in mm.
namespace reye::cad {

struct SolidMeshOptions {
  mesh::SolidKind element = mesh::SolidKind::tet10;  ///< scene: order 1 tet4, order 2 tet10; mesh files bring theirs
  double far_size_mm = 0.0;                          ///< 0: a fifteenth of the body's bounding-box diagonal
  double growth = 1.3;                               ///< ratio of neighbouring sizes away from fine zones
};

/// A body of the scene: found by a point inside, or by label (STEP product, physical volume); with neither, by its own
/// name as label, or as the only solid of all files.
struct SolidBodyOptions {
  std::string name;
  std::optional<base::Vec3> at;
  std::optional<std::string> label;
  bool rigid = false;
  SolidMeshOptions mesh;
};

/// A name for faces of one body. Every given selector narrows the choice; without one the physical surface of this
/// name, or else the whole skin.
struct FaceOptions {
  std::string name;
  std::string body;
  std::optional<std::array<double, 6>> box_mm;  ///< x_min, y_min, z_min, x_max, y_max, z_max: faces wholly inside
  std::optional<std::string> type;              ///< "plane" | "cylinder" | "sphere" | "cone" | "torus" | "spline"
  std::optional<base::Vec3> nearest_mm;         ///< the one face nearest to the point
};

/// A region round a contact in which the mesh is fine: a ball, or a box with axes x, y, z; constant size inside,
/// growing outside.
struct SolidFineZone {
  std::vector<std::string> bodies;  ///< empty: all
  base::Vec3 centre_mm = base::Vec3::Zero();
  double radius_mm = 0.0;                          ///< > 0: a ball
  base::Vec3 half_widths_mm = base::Vec3::Zero();  ///< else a box
  double size_mm = 0.0;
  std::string contact{};  ///< that asks for it
  std::string key{};      ///< of the scene that asks for it
};

struct SolidGeometryOptions {
  std::vector<std::string> files;  ///< absolute paths
  std::string folder{};            ///< of the scene, absolute: scripts may include what lies in it or below
  bool trusted = false;            ///< scripts may use all of gmsh's language, and no limits of time or memory apply
  std::vector<SolidBodyOptions> bodies;
  std::vector<FaceOptions> faces;
  std::vector<SolidFineZone> fine_zones;
};

}  // namespace reye::cad
