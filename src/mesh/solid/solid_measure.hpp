#pragma once
#include "mesh/solid/solid_shape.hpp"

/// Volumes, areas and normals of solids. What needs no cells is taken from the skin, so that a rigid body has it, too.
namespace reye::mesh {

/// Points of a facet or cell by its own numbering, columns beyond its nodes zero.
Eigen::Matrix<double, 3, most_facet_nodes> corners_of(const Points3& X, const Facet& facet);
Eigen::Matrix<double, 3, most_solid_nodes> corners_of(const Points3& X, SolidKind kind, const SolidCell& cell);

/// dx/dxi1 x dx/dxi2 at a place of a facet: outward normal times area per reference area.
Vec3 normal_at(const Points3& X, const Facet& facet, const Vec2& xi);

/// int n dA over a facet [mm^2]; its direction is the facet's mean normal.
Vec3 area_vector(const Points3& X, const Facet& facet);
/// Unit mean normal, outward.
Vec3 facet_normal(const Points3& X, const Facet& facet);
/// int dA [mm^2].
double facet_area(const Points3& X, const Facet& facet);

/// Facets of a named face. Throws base::MeshError where the solid has no such face.
std::vector<Facet> facets_of(const SolidMesh& mesh, const std::string& face);
/// The distinct nodes of facets, ascending.
std::vector<int> nodes_of(const std::vector<Facet>& facets);

/// Area of facets [mm^2], and its centroid.
double area(const Points3& X, const std::vector<Facet>& facets);
Vec3 area_centroid(const Points3& X, const std::vector<Facet>& facets);

/// Volume inside a closed skin [mm^3]: 1/3 int x . n dA, exact on curved facets.
double volume(const SolidMesh& mesh);
/// Its centroid: int 1/2 (x_i^2) n_i dA over the volume.
Vec3 volume_centroid(const SolidMesh& mesh);

/// x_min, y_min, z_min, x_max, y_max, z_max of all nodes.
std::array<double, 6> bounding_box(const Points3& X);
Vec3 box_centre(const Points3& X);
double box_diagonal(const Points3& X);

/// A node's unit outward normal, the mean by area over the facets of one group that meet in it. A node where groups
/// meet has one per group.
struct NodeNormal {
  int node = -1, group = 0;
  Vec3 normal = Vec3::Zero();
};
/// By node, then group, ascending.
std::vector<NodeNormal> node_normals(const Points3& X, const std::vector<Facet>& facets);

}  // namespace reye::mesh
