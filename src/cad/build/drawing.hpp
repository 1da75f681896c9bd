#pragma once
#include <map>
#include <string>
#include <vector>

#include "cad/part/options.hpp"
#include "cad/part/select.hpp"

namespace reye::cad {

/// The input of a mesh of one body, as a value that outlives the gmsh session: the outline as curves, those of each
/// boundary, the wished sizes, and the fine zones. Wear changes the curves; a new mesh comes from `remesh`.
struct Drawing {
  Part part;
  std::map<std::string, EdgeChoice> boundaries;
  BodyOptions options;
  std::vector<FineZone> zones;  ///< those that apply to this body
  bool axisymmetric = false;
};

/// Nodes a mesh of the drawing would have, about: int dA / size^2.
double estimated_nodes(const Drawing& drawing);

/// Fixes the origin of arc length of each boundary of a mesh where it is now; for a ring in the middle of the longest
/// stretch between the centres of the fine zones on it, opposite to a single one, so that no table is cut where there
/// is contact.
void choose_arc_origins(mesh::Mesh& mesh, const Drawing& drawing);

/// A fresh mesh with the same boundaries and of the order asked for, in a gmsh session of its own. A mesh that came
/// with the drawing's part is returned as it is. Throws base::MeshError: more than `most_nodes` expected (saying how
/// many), or no mesh with positive Jacobians.
mesh::Mesh remesh(const Drawing& drawing, double most_nodes = 2e6);

/// A fresh mesh inside an existing outline: its nodes and boundaries stay as they are, so that no field on them has to
/// be carried over. The drawing's edges pass through its nodes, or near them.
mesh::Mesh refill(const Drawing& drawing, const mesh::Mesh& outline, double most_nodes = 2e6);

}  // namespace reye::cad
