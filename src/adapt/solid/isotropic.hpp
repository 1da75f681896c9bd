#pragma once
#include <array>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/space.hpp"

namespace reye::adapt {

using base::Points3;

using PatchTriangle = std::array<int, 3>;
using PatchEdge = std::pair<int, int>;  ///< the smaller node first

/// The shape of a triangle, 1 of the regular one and 0 of a flat one: 4 sqrt(3) area / sum of squared edges.
double triangle_shape(const Points3& X, const PatchTriangle& corners);

/// A part of a surface: its triangles, and edges within it that may not move. Edges of its border may not either.
struct TrianglePatch {
  Points3 X;
  std::vector<PatchTriangle> triangles;
  std::set<PatchEdge> fixed;
};

/// The patch in other triangles: `from` names the point of the patch that each point was, -1: a new one.
struct RemeshedPatch {
  Points3 X;
  std::vector<int> from;
  std::vector<PatchTriangle> triangles;
};

/// Triangles with edges of about one length [mm] on the surface of the patch, by CGAL's isotropic remeshing (Botsch &
/// Kobbelt 2004). Points of the border and of fixed edges keep their places; no such edge may be longer than 4/3 of the
/// length. Nothing where the patch is not a surface with a simple border.
std::optional<RemeshedPatch> remeshed(const TrianglePatch& patch, double length);

}  // namespace reye::adapt
