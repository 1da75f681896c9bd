#pragma once
#include "cad/build/plan.hpp"

namespace reye::cad {

/// The mesh of a body with its outline and named boundaries, made in the running gmsh session or, if its file brought
/// one, taken over. A rigid body gets its outline only.
/// Throws base::MeshError, naming the place, when no mesh with positive Jacobians is found.
mesh::Mesh generate(const BodyPlan& plan);

/// The mesh of a body inside a given outline, whose nodes stay where they are and keep their boundaries (its order is
/// the mesh's); cells and inner nodes of `outline` are not read. Corners of the plan's edges lie on nodes of it;
/// all-quad meshes need an even number of nodes between sharp ones, as `generate` leaves it.
mesh::Mesh generate_within(const BodyPlan& plan, const mesh::Mesh& outline);

/// Nodes that lie at a negative radius by round-off alone go to the axis.
void clear_axis(mesh::Mesh& mesh);

}  // namespace reye::cad
