#pragma once
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cad/part/edge.hpp"
#include "cad/part/options.hpp"
#include "mesh/mesh.hpp"

/// The content of a file, in space, before it is mapped to the plane of the scene.
namespace reye::cad {

struct RawCurve {
  int tag = 0;  ///< within its file: curves of the same tag are the same curve
  EdgeType type = EdgeType::line;
  std::vector<Vec3> points;
  std::vector<Vec3> directions;
  std::set<std::string> names;
};

/// A mesh that came with the file.
struct RawMesh {
  std::vector<Vec3> nodes;
  mesh::CellKind kind = mesh::CellKind::quad4;
  std::vector<mesh::Cell> cells;
  std::map<std::pair<int, int>, std::set<std::string>> names;  ///< of edges (smaller vertex first), by physical curve
};

struct RawPart {
  std::string file;  ///< that holds it, as the options name it
  std::string label;
  bool group = false;  ///< the label is a physical group: its faces are one body
  std::vector<RawCurve> curves;
  std::vector<Vec3> surface_points;  ///< inside faces not known to be plane, to see whether they are
  RawMesh mesh;
};

/// The format of a file by the end of its name: STEP, IGES, BREP; .geo; .msh; .vtu.
enum class Format { shapes, script, mesh, vtu };

/// The end of a file's name from its last point, in small letters.
std::string extension(const std::string& path);

/// Whether gmsh reads such a file.
bool needs_gmsh(const std::string& path);

/// Throws base::InputError, key "geometry".
[[noreturn]] void refuse(const std::string& path, const std::string& rule);

}  // namespace reye::cad
