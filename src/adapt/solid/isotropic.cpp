#include "adapt/solid/isotropic.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>

namespace reye::adapt {

namespace {

using SurfaceKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<SurfaceKernel::Point_3>;
using SurfaceVertex = SurfaceMesh::Vertex_index;

/// Its points by place; empty where a triangle cannot be added.
std::vector<SurfaceVertex> add_patch(const TrianglePatch& patch, SurfaceMesh& surface) {
  std::vector<SurfaceVertex> vertices;
  for (const auto& x : patch.X) vertices.push_back(surface.add_vertex({x.x(), x.y(), x.z()}));
  for (const auto& [a, b, c] : patch.triangles)
    if (surface.add_face(vertices[a], vertices[b], vertices[c]) == SurfaceMesh::null_face()) return {};
  return vertices;
}

RemeshedPatch read_patch(const SurfaceMesh& surface, const std::vector<int>& from_of) {
  RemeshedPatch patch;
  std::vector<int> place(surface.num_vertices() + surface.number_of_removed_vertices(), -1);
  for (const auto face : surface.faces()) {
    PatchTriangle& triangle = patch.triangles.emplace_back();
    int corner = 0;
    for (const auto vertex : surface.vertices_around_face(surface.halfedge(face))) {
      int& known = place[vertex.idx()];
      if (known < 0) {
        known = static_cast<int>(patch.X.size());
        const auto& p = surface.point(vertex);
        patch.X.emplace_back(p.x(), p.y(), p.z());
        patch.from.push_back(from_of[vertex.idx()]);
      }
      triangle[corner++] = known;
    }
  }
  return patch;
}

}  // namespace

std::optional<RemeshedPatch> remeshed(const TrianglePatch& patch, double length) {
  constexpr int iterations = 5, relaxations = 3;
  SurfaceMesh surface;
  const auto vertices = add_patch(patch, surface);
  if (vertices.empty()) return std::nullopt;
  auto from = surface.add_property_map<SurfaceVertex, int>("v:from", -1).first;
  for (std::size_t k = 0; k < vertices.size(); ++k) from[vertices[k]] = static_cast<int>(k);
  auto fixed = surface.add_property_map<SurfaceMesh::Edge_index, bool>("e:fixed", false).first;
  auto held = surface.add_property_map<SurfaceVertex, bool>("v:held", false).first;
  for (const auto edge : surface.edges()) {
    const auto a = surface.vertex(edge, 0), b = surface.vertex(edge, 1);
    fixed[edge] = surface.is_border(edge) || patch.fixed.contains(std::minmax({from[a], from[b]}));
    if (fixed[edge]) held[a] = held[b] = true;
  }
  namespace pmp = CGAL::Polygon_mesh_processing;
  pmp::isotropic_remeshing(surface.faces(), length, surface,
                           CGAL::parameters::number_of_iterations(iterations)
                               .number_of_relaxation_steps(relaxations)
                               .protect_constraints(true)
                               .edge_is_constrained_map(fixed)
                               .vertex_is_constrained_map(held));
  std::vector<int> from_of(surface.num_vertices() + surface.number_of_removed_vertices(), -1);
  for (const auto vertex : surface.vertices())
    if (held[vertex]) from_of[vertex.idx()] = from[vertex];
  return read_patch(surface, from_of);
}

}  // namespace reye::adapt
