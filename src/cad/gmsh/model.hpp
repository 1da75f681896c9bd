#pragma once
#include "cad/part/raw.hpp"

/// Readers of gmsh's current model. gmsh's bare std::string exceptions pass through.
namespace reye::cad {

/// Loads a file into the current model.
void load_model(const std::string& path, Format format);

/// A surface of the model with its name: of its physical group (`group`), or the last component of the label that was
/// imported with it.
struct Face {
  int tag = 0;
  std::string label;
  bool group = false;
};

/// All surfaces of the model that bound no solid.
std::vector<Face> free_faces();

/// One part per face; the faces of one physical surface are one part, in which shared curves vanish.
std::vector<RawPart> parts_from_faces(const std::vector<Face>& faces);

/// One part per physical surface of the mesh, or per surface where there is none.
std::vector<RawPart> parts_from_mesh();

/// Physical names of an entity; a group without a name goes by its number.
std::set<std::string> physical_names(int dim, int tag);

/// The last component of the label that was imported with an entity; empty when the file names none.
std::string imported_label(int dim, int tag);

}  // namespace reye::cad
