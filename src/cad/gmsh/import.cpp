#include <gmsh.h>

#include <algorithm>
#include <array>

#include "cad/gmsh/section.hpp"
#include "cad/gmsh/session.hpp"
#include "cad/meshing/kernel.hpp"

namespace reye::cad {

namespace {

void import_shapes(const std::string& path) {
  gmsh::vectorpair shapes;
  // The unit is sticky in gmsh and OCCT: the setting of an earlier import is replaced each time.
  gmsh::option::setString("Geometry.OCCTargetUnit", "MM");
  try {
    gmsh::model::occ::importShapes(path, shapes);
  } catch (const std::string& message) {
    if (message.find("target unit") == std::string::npos) throw;
    // Before its first STEP import OCCT does not know the setting; then its own default, mm, still holds.
    gmsh::option::setString("Geometry.OCCTargetUnit", "");
    gmsh::model::occ::importShapes(path, shapes);
  }
  gmsh::model::occ::synchronize();
}

bool has_solids() {
  gmsh::vectorpair solids;
  gmsh::model::getEntities(solids, 3);
  return !solids.empty();
}

void check_content(const std::string& path, Format format, bool cut) {
  gmsh::vectorpair faces;
  gmsh::model::getEntities(faces, 2);
  if (faces.empty()) refuse(path, "holds no face");
  if (has_solids() && format == Format::mesh)
    refuse(path, "holds a mesh of a solid, which a plane scene has no use for");
  if (has_solids() && !cut)
    refuse(path, "holds a solid; bodies are planar faces: cut it by section = { point_mm = [...], normal = [...] }");
  if (has_solids() && !can_be_cut())
    refuse(path, "holds a solid of gmsh's own kernel; only those of SetFactory(\"OpenCASCADE\") can be cut");
  if (format != Format::mesh) return;
  std::vector<int> types;
  gmsh::model::mesh::getElementTypes(types, 2);
  if (types.empty()) refuse(path, "holds no mesh of triangles or quadrilaterals");
  constexpr std::array known{2, 3, 9, 16, 10};  // triangles of 3 nodes, quadrilaterals of 4, then of 6 and of 8 and 9
  if (types.size() > 1 || std::find(known.begin(), known.end(), types[0]) == known.end())
    refuse(path, "the mesh must be all triangles of 3 or 6 nodes or all quadrilaterals of 4, 8 or 9 nodes");
}

/// The faces of the model: those there are, and those cut from its solids.
std::vector<Face> faces_of(const std::string& path, const std::optional<Section>& section) {
  std::vector<Face> faces = free_faces();
  if (has_solids())
    for (Face& face : faces_of_section(*section, path)) faces.push_back(std::move(face));
  return faces;
}

}  // namespace

void load_model(const std::string& path, Format format) {
  const Silence silence;
  gmsh::option::setNumber("Geometry.OCCImportLabels", 1);
  gmsh::option::setNumber("Geometry.OCCScaling", 1);
  if (format == Format::shapes)
    import_shapes(path);
  else
    gmsh::merge(path);
  gmsh::option::setNumber("General.Terminal", 0);  // a script may have switched on messages
}

std::vector<RawPart> read_by_gmsh(const std::string& path, Format format, const std::optional<Section>& section) {
  const Session session;
  try {
    gmsh::model::add("import");
    load_model(path, format);
    check_content(path, format, section.has_value());
    std::vector<RawPart> parts = format == Format::mesh ? parts_from_mesh() : parts_from_faces(faces_of(path, section));
    gmsh::model::remove();
    return parts;
  } catch (const std::string& message) {
    refuse(path, "gmsh cannot read it: " + message);
  }
}

}  // namespace reye::cad
