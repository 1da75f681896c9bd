#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/linalg.hpp"
#include "mesh/mesh.hpp"

/// What a scene may ask of geometry and mesh. Lengths in mm.
namespace reye::cad {

using base::Vec2;

struct MeshOptions {
  mesh::CellKind element = mesh::CellKind::quad4;  ///< scene: "tri" | "quad"
  double far_size_mm = 0.0;                        ///< 0: a twentieth of the body's bounding-box diagonal
  double growth = 1.3;                             ///< ratio of neighbouring sizes away from fine zones
};

/// A body of the scene: found by a point inside, or by label (STEP product, physical surface);
/// with neither, by its own name as label.
struct BodyOptions {
  std::string name;
  std::optional<Vec2> at;
  std::optional<std::string> label;
  bool rigid = false;  ///< a rigid body has no cells, only its outline
  MeshOptions mesh;
};

/// A name for edges of one body. Every given selector narrows the choice.
struct BoundaryOptions {
  std::string name;
  std::string body;
  std::optional<std::array<double, 4>> box_mm;  ///< x_min, y_min, x_max, y_max: edges wholly inside
  std::optional<std::string> type;              ///< "line" | "circle" | "spline"
  std::optional<Vec2> nearest_mm;               ///< the one edge nearest to the point
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
  std::string contact{};   ///< that asks for it
};

struct GeometryOptions {
  std::vector<std::string> files;  ///< absolute paths
  std::vector<BodyOptions> bodies;
  std::vector<BoundaryOptions> boundaries;
  std::vector<FineZone> fine_zones;
  bool axisymmetric = false;
};

}  // namespace reye::cad
