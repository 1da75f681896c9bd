#pragma once
#include "cad/gmsh/model.hpp"

namespace reye::cad {

/// Cuts every solid of gmsh's current model by the section plane: returns the faces, labelled like their solids
/// (physical volume, STEP product). A solid that only touches the plane with a face gives that face; one that the plane
/// misses gives none. Lines and circles stay lines and circles. The model must have been made in the OpenCASCADE
/// kernel, and keeps its solids. Throws base::InputError, key "section.point_mm", when the plane misses all of them,
/// saying where each lies.
std::vector<Face> faces_of_section(const Section& section, const std::string& file);

/// Whether the OpenCASCADE kernel knows all the solids of the model; those of other kernels cannot be cut.
bool can_be_cut();

}  // namespace reye::cad
