#include "adapt/solid/isotropic.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace reye::adapt {

namespace {

using SurfaceKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<SurfaceKernel::Point_3>;
using base::Vec3;
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

Vec3 position(const SurfaceMesh& surface, SurfaceVertex vertex) {
  const auto& p = surface.point(vertex);
  return {p.x(), p.y(), p.z()};
}

/// Whether the other diagonal of the two triangles at an edge gives the poorer of them a better shape, and folds
/// nothing.
bool other_diagonal_is_better(const SurfaceMesh& surface, SurfaceMesh::Edge_index edge) {
  const auto h = surface.halfedge(edge), g = surface.opposite(h);
  const auto va = surface.source(h), vb = surface.target(h), vc = surface.target(surface.next(h)),
             vd = surface.target(surface.next(g));
  if (surface.halfedge(vc, vd) != SurfaceMesh::null_halfedge()) return false;
  const Points3 X{position(surface, va), position(surface, vb), position(surface, vc), position(surface, vd)};
  const auto normal = [&](int i, int j, int k) { return Vec3((X[j] - X[i]).cross(X[k] - X[i])); };
  const Vec3 up = normal(0, 1, 2) + normal(1, 0, 3);
  if (!(up.dot(normal(0, 3, 2)) > 0.0) || !(up.dot(normal(3, 1, 2)) > 0.0)) return false;
  const double now = std::min(triangle_shape(X, {0, 1, 2}), triangle_shape(X, {1, 0, 3}));
  return std::min(triangle_shape(X, {0, 3, 2}), triangle_shape(X, {3, 1, 2})) > 1.01 * now;
}

/// Flips edges for shape: remeshing flips them for valence and leaves flat triangles at borders that do not move.
template <class Fixed>
void flip_for_shape(SurfaceMesh& surface, const Fixed& fixed) {
  constexpr int most_passes = 5;
  bool again = true;
  for (int pass = 0; again && pass < most_passes; ++pass) {
    again = false;
    for (const auto edge : surface.edges()) {
      if (fixed[edge] || surface.is_border(edge) || !other_diagonal_is_better(surface, edge)) continue;
      CGAL::Euler::flip_edge(surface.halfedge(edge), surface);
      again = true;
    }
  }
}

}  // namespace

double triangle_shape(const Points3& X, const PatchTriangle& t) {
  const Vec3 a = X[t[1]] - X[t[0]], b = X[t[2]] - X[t[0]];
  return 2.0 * std::sqrt(3.0) * a.cross(b).norm() / (a.squaredNorm() + b.squaredNorm() + (a - b).squaredNorm());
}

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
  flip_for_shape(surface, fixed);
  std::vector<int> from_of(surface.num_vertices() + surface.number_of_removed_vertices(), -1);
  for (const auto vertex : surface.vertices())
    if (held[vertex]) from_of[vertex.idx()] = from[vertex];
  return read_patch(surface, from_of);
}

}  // namespace reye::adapt
