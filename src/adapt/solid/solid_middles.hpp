#pragma once
#include "adapt/solid/redraw_skin.hpp"

namespace reye::adapt {

/// A mesh of first order on a drawn skin, or the skin alone of a rigid body, in second order: mid nodes of edges of the
/// worn skin stay where they are, those of fresh ones lie on the worn surface of their group beside the middle of the
/// edge, inner ones in the middle. The skin keeps its order.
void add_middles(mesh::SolidMesh& mesh, const DrawnSkin& drawn, const mesh::SolidMesh& worn);

/// Puts mid nodes of the skin into the middle of their edges where curved edges leave a cell less than a fifth of its
/// Jacobian and are those of fresh facets, or less than a twentieth whatever they are. `fresh`: per facet of the skin.
/// Returns how many edges became straight.
int straighten_skin(mesh::SolidMesh& mesh, const std::vector<char>& fresh);

}  // namespace reye::adapt
