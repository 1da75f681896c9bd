#pragma once
#include "cad/raw.hpp"

/// Readers of gmsh's current model. gmsh's bare std::string exceptions pass through.
namespace reye::cad {

/// One part per face; the faces of one physical surface are one part, in which shared curves vanish.
std::vector<RawPart> parts_from_faces();

/// One part per physical surface of the mesh, or per surface where there is none.
std::vector<RawPart> parts_from_mesh();

/// Physical names of an entity; a group without a name goes by its number.
std::set<std::string> physical_names(int dim, int tag);

/// Name of a surface: its physical group (`group` true) or the last component of the label imported with it.
std::string surface_label(int tag, bool& group);

}  // namespace reye::cad
