#pragma once
#include <array>
#include <set>
#include <string>
#include <vector>

#include "cad/build/drawing.hpp"
#include "mesh/mesh.hpp"

namespace reye::cad {

/// The facts of one body that `reye check` prints: its area [mm^2], bounding box, and the named boundaries with their
/// lengths.
struct BodyFacts {
  std::string name;
  double area_mm2 = 0.0;
  std::array<double, 4> box_mm{};
  bool halved = false;  ///< its file has a section on both sides of the axis, of which the half x >= 0 is taken
  std::set<std::string>
      cut_off{};  ///< physical curves that name edges at x < 0 and not their mirror images: no boundaries
};

struct Geometry {
  std::vector<mesh::Mesh> bodies;  ///< in the order of the options; a rigid body has outline and boundaries, no cells
  std::vector<Drawing> drawings;   ///< what each was made from
  std::vector<BodyFacts> facts;
  bool guarded = true;  ///< false: the readers of files were restricted by their own limits alone
};

/// Imports the files, finds bodies and boundaries by their selectors, meshes and checks every body.
/// A planar face in any plane is mapped to x-y. Boundaries named by physical curves are added under their
/// physical names. In an axisymmetric scene the half x >= 0 of a section through the axis is taken. Bodies are never
/// merged: nodes of two bodies are distinct even where their CAD coincides.
/// Throws base::InputError (all issues together; keys "geometry", "body.<name>.at", "boundary.<name>.box_mm" ...)
/// for files and bodies that cannot be used: key "geometry" with the file, "body.<name>" for a face that cannot be
/// meshed.
Geometry build(const GeometryOptions& options);

}  // namespace reye::cad
