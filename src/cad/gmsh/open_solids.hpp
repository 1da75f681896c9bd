#pragma once
#include <map>

#include "cad/solid/raw_solid.hpp"
#include "cad/solid/solid_size.hpp"
#include "cad/solid/triangles.hpp"

/// Readers of the solids of gmsh's current model. gmsh's bare std::string exceptions pass through.
namespace reye::cad {

/// Whether the model's volumes hold cells.
bool has_cells();

/// Whether a script made gmsh put quadrilaterals on faces.
bool has_quadrilaterals();

/// Meshes the surface of visible entities coarsely, so that distances can be found.
void triangulate();

/// Mesh options of every kind of meshing: those that a script may have set are put back.
void reset_mesh_options();

/// What the scene may choose among, of B-reps: volumes of a physical group are one solid. Needs `triangulate`.
std::vector<RawSolid> solids_of_shapes(const Points3& probes);

/// The meshes of a .msh. Throws base::InputError (key "geometry") for cells of other kinds than tetrahedra of 4 or 10
/// nodes and hexahedra of 8.
std::vector<RawSolid> solids_of_mesh(const std::string& path);

/// Solids without faces: their labels and volumes.
std::vector<RawSolid> labelled_volumes();

/// Faces that bound one of these volumes alone; those between two of them lie inside the body.
std::vector<int> outer_faces(const std::vector<int>& volumes);

/// The coarse triangles of a face.
std::vector<Triangle> triangles_of(int face);

/// The smallest radius of curvature (as size) at the coarse nodes of a face; none on planes.
std::vector<SizePoint> radii_of(int face);

/// Those of every face of the model that is open, from before it was meshed.
std::map<int, std::vector<SizePoint>>& kept_radii();

/// The type of a face: by its kind in the CAD, or where that is a spline by its curvatures.
FaceType type_of_face(int face);

}  // namespace reye::cad
