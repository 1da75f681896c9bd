#pragma once
#include <vector>

#include "contact/solid/skin_options.hpp"
#include "mesh/solid/solid_mesh.hpp"

namespace reye::contact {

/// A point of one side of a contact: a node of a body, on tri6 facets a control point, and its place among the points
/// of the whole system of equations.
struct SkinPoint {
  int body = 0;
  int node = 0;
  int column = 0;
};

/// One side of a contact, as far as it may touch.
struct SkinSide {
  mortar::Skin skin;  ///< on X, control points where the facets are tri6
  std::vector<SkinPoint> points;
  std::vector<char> rim;  ///< per point: a facet of the named faces beside it was left out, so that it must not touch
};

/// A face of the scene and its body.
struct FaceRef {
  int body = 0;
  std::string face;
};

/// A contact of solids, prepared for its equations.
struct SkinSetup {
  SkinContactOptions options;
  SkinSide secondary, primary;
  std::vector<double> stiffness;  ///< c_n = c_t per secondary point: E / h [MPa/mm]
  base::Vector primary_area;      ///< of the primary points, on X [mm^2]
  double search = 0.0;
  std::vector<int> order;  ///< secondary points along a curve through space: neighbours follow each other

  int count() const { return static_cast<int>(secondary.points.size()); }
};

/// Nodes that contact was prepared for: `column[body][node]` is the place in the system, -1 of other nodes.
using Columns = std::vector<std::vector<int>>;

/// The side made of those facets of the faces all of whose nodes have a column.
SkinSide make_side(const std::vector<FaceRef>& faces, const std::vector<const mesh::SolidMesh*>& meshes,
                   const Columns& columns);

/// `modulus_MPa` scales the complementarity functions.
SkinSetup make_skin_setup(const SkinContactOptions& options, SkinSide secondary, SkinSide primary, double modulus_MPa,
                          double search);

}  // namespace reye::contact
