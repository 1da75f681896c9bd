#pragma once
#include "cad/plan.hpp"

namespace reye::cad {

/// The mesh of a body with its outline and named boundaries, made in the running gmsh session or, if its file brought
/// one, taken over. A rigid body gets its outline only.
/// Throws base::MeshError, naming the place, when no mesh with positive Jacobians is found.
mesh::Mesh generate(const BodyPlan& plan);

/// Nodes that lie at a negative radius by round-off alone go to the axis.
void clear_axis(mesh::Mesh& mesh);

}  // namespace reye::cad
