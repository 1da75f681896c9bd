#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/linalg.hpp"
#include "mesh/mesh.hpp"

/// Options of a scene for geometry and mesh. Lengths in mm.
namespace reye::cad {

using base::Vec2;
using Vec3 = Eigen::Vector3d;

/// The plane that cuts solids into faces; the normal's length and sign do not matter.
struct Section {
  Vec3 point_mm = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();
};

/// A start profile: height [mm], positive out of the body, over arc length [mm] along a boundary from its end with
/// smaller x (then smaller y). Zero outside of the range given.
struct Profile {
  std::string file;  ///< as the scene names it, for messages
  std::vector<double> arc_mm;
  std::vector<double> height_mm;
};

struct MeshOptions {
  mesh::CellKind element = mesh::CellKind::quad4;  ///< scene: "tri" | "quad"; with `order` 2 it is tri6 or quad8
  double far_size_mm = 0.0;                        ///< 0: a twentieth of the body's bounding-box diagonal
  double growth = 1.3;                             ///< ratio of neighbouring sizes away from fine zones
  int order = 1;  ///< 2: a node on every edge; a mesh that came with its file in second order stays so
};

/// A body of the scene: found by a point inside, or by label (STEP product, physical surface);
/// with neither, by its own name as label.
struct BodyOptions {
  std::string name;
  std::optional<Vec2> at;
  std::optional<std::string> label;
  bool rigid = false;  ///< a rigid body has no cells, only its outline
  MeshOptions mesh;
  std::vector<Vec2> points_mm{};  ///< where point loads and supports act: a vertex of every mesh of the body
};

/// A name for edges of one body. Every given selector narrows the choice.
struct BoundaryOptions {
  std::string name;
  std::string body;
  std::optional<std::array<double, 4>> box_mm;  ///< x_min, y_min, x_max, y_max: edges wholly inside
  std::optional<std::string> type;              ///< "line" | "circle" | "spline"
  std::optional<Vec2> nearest_mm;               ///< the one edge nearest to the point
  std::optional<Profile> profile;               ///< put on the edges once they are chosen
};

/// A box round a contact in which the mesh is fine: constant size within
/// |along the tangent| <= half_width and depth below the boundary of either body, growing outside.
struct FineZone {
  std::vector<std::string> bodies;  ///< empty: all
  Vec2 centre_mm{0.0, 0.0};
  double half_width_mm = 0.0;
  double depth_mm = 0.0;
  double size_mm = 0.0;
  double angle_deg = 0.0;  ///< direction of the width, from x
  std::string contact{};   ///< or bond that asks for it
  std::string key{};       ///< of the scene that asks for it: each contact may have several zones
  bool turns = false;      ///< made wide for a body that turns under it: it does not follow its contact
};

struct GeometryOptions {
  std::vector<std::string> files;  ///< absolute paths
  std::string folder{};            ///< of the scene, absolute: scripts may include what lies in it or below
  bool trusted = false;            ///< scripts may use all of gmsh's language, and no limits of time or memory apply
  std::vector<BodyOptions> bodies;
  std::vector<BoundaryOptions> boundaries;
  std::vector<FineZone> fine_zones;
  bool axisymmetric = false;
  std::optional<Section> section;
};

}  // namespace reye::cad
