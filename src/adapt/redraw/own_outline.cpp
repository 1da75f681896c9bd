#include "adapt/redraw/own_outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "adapt/redraw/trace.hpp"
#include "mesh/measure.hpp"
#include "mesh/outline.hpp"

namespace reye::adapt {

namespace {

using base::Points;
using base::Vec2;

using Facets = std::set<std::pair<int, int>>;

Facets facets_of(const mesh::Boundary& boundary) {
  Facets facets;
  for (const auto& chain : boundary)
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) facets.insert({chain[i], chain[i + 1]});
  return facets;
}

/// Which boundaries the facet from loop[i] on belongs to.
std::vector<bool> belongs(const std::vector<Facets>& boundaries, const mesh::Chain& loop, std::size_t i) {
  std::vector<bool> all;
  for (const Facets& facets : boundaries) all.push_back(facets.contains({loop[i], loop[i + 1]}));
  return all;
}

/// Whether an edge ends at loop[i] of a closed loop.
bool ends_at(const mesh::Mesh& mesh, const std::vector<Facets>& boundaries, const mesh::Chain& loop, std::size_t i) {
  const std::size_t before = i == 0 ? loop.size() - 2 : i - 1;
  const Vec2 in = mesh.X[loop[i]] - mesh.X[loop[before]], out = mesh.X[loop[i + 1]] - mesh.X[loop[i]];
  return std::abs(std::atan2(base::cross(in, out), in.dot(out))) > mesh::corner_angle ||
         belongs(boundaries, loop, before) != belongs(boundaries, loop, i);
}

cad::Edge edge_through(Points knots) {
  const Vec2 chord = knots.back() - knots.front();
  const bool line = knots.front() != knots.back() && std::all_of(knots.begin(), knots.end(), [&](const Vec2& p) {
                      return std::abs(base::cross(chord, p - knots.front())) <= 1e-9 * chord.squaredNorm();
                    });
  if (line) return cad::make_edge(cad::EdgeType::line, {knots.front(), knots.back()}, {chord, chord});
  return cad::make_polyline(cad::EdgeType::spline, std::move(knots));
}

/// The starts of the edges of a loop; its first node when it has neither corners nor names.
std::vector<std::size_t> starts(const mesh::Mesh& mesh, const std::vector<Facets>& boundaries,
                                const mesh::Chain& loop) {
  std::vector<std::size_t> all;
  const auto order = static_cast<std::size_t>(mesh::order(mesh.kind));  // edges end at vertices
  for (std::size_t i = 0; i + 1 < loop.size(); i += order)
    if (ends_at(mesh, boundaries, loop, i)) all.push_back(i);
  return all.empty() ? std::vector<std::size_t>{0} : all;
}

/// The largest cells but for the last twentieth, as the side of a square (of two triangles).
double largest_size(const mesh::Mesh& mesh) {
  std::vector<double> size;
  for (const auto& cell : mesh.cells)
    size.push_back(std::sqrt((mesh::corners(mesh.kind) == 3 ? 2.0 : 1.0) * mesh::cell_area(mesh.X, mesh.kind, cell)));
  const auto edge = static_cast<std::size_t>(mesh::order(mesh.kind));
  for (std::size_t l = 0; mesh.cells.empty() && l < mesh.outline.size(); ++l)
    for (std::size_t i = 0; i + edge < mesh.outline[l].size(); i += edge)
      size.push_back((mesh.X[mesh.outline[l][i + edge]] - mesh.X[mesh.outline[l][i]]).norm());
  const std::size_t at = size.size() * 19 / 20;
  std::nth_element(size.begin(), size.begin() + static_cast<std::ptrdiff_t>(at), size.end());
  return size[at];
}

/// The nodes of an edge without those in the middle of quadratic facets.
std::vector<int> vertices_of(const mesh::Mesh& mesh, std::vector<int> nodes) {
  if (mesh::order(mesh.kind) == 1) return nodes;
  for (std::size_t i = 1; 2 * i < nodes.size(); ++i) nodes[i] = nodes[2 * i];
  nodes.resize(nodes.size() / 2 + 1);
  return nodes;
}

std::vector<double> facet_lengths(const mesh::Mesh& mesh, const std::vector<int>& nodes) {
  std::vector<double> facet;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) facet.push_back((mesh.X[nodes[i + 1]] - mesh.X[nodes[i]]).norm());
  return facet;
}

/// A zone along the chord from a to b, both of which it contains.
cad::FineZone zone_along(const Vec2& a, const Vec2& b, const Vec2& centre, double size) {
  const Vec2 way = b - a, along = way.normalized();
  cad::FineZone zone;
  zone.centre_mm = centre;
  zone.angle_deg = std::atan2(way.y(), way.x()) * 180.0 / std::numbers::pi;
  zone.half_width_mm = std::max(along.dot(b - centre), along.dot(centre - a));
  zone.size_mm = zone.depth_mm = size;
  return zone;
}

/// The zone that keeps the fine facets of an edge fine: from its smallest facet to those twice as long.
std::optional<cad::FineZone> zone_on(const mesh::Mesh& mesh, const std::vector<int>& edge, double far) {
  const auto nodes = vertices_of(mesh, edge);
  const auto facet = facet_lengths(mesh, nodes);
  const double smallest = *std::min_element(facet.begin(), facet.end());
  if (smallest > 0.5 * far) return {};
  const auto fine = [&](double h) { return h <= 2.0 * smallest; };
  const auto first = static_cast<std::size_t>(std::find_if(facet.begin(), facet.end(), fine) - facet.begin());
  const auto last =
      facet.size() - static_cast<std::size_t>(std::find_if(facet.rbegin(), facet.rend(), fine) - facet.rbegin());
  const Vec2 &a = mesh.X[nodes[first]], &b = mesh.X[nodes[last]];
  if (!((b - a).norm() > smallest)) return {};
  double length = 0.0;
  for (std::size_t i = first; i < last; ++i) length += facet[i];
  return zone_along(a, b, mesh.X[nodes[(first + last) / 2]], length / static_cast<double>(last - first));
}

/// The nodes of a closed loop from one place to another; the whole loop where they are the same.
Points knots_between(const mesh::Mesh& mesh, const mesh::Chain& loop, std::size_t first, std::size_t last) {
  Points knots{mesh.X[loop[first]]};
  for (std::size_t i = first; knots.size() == 1 || i != last;) {
    knots.push_back(mesh.X[loop[i + 1]]);
    i = (i + 1) % (loop.size() - 1);
  }
  return knots;
}

/// Draws a loop of the outline, one edge between each two starts, and notes to which boundaries each edge belongs.
void draw_loop(const mesh::Mesh& mesh, const std::vector<Facets>& boundaries, const mesh::Chain& loop,
               cad::Drawing& drawing) {
  const auto begin = starts(mesh, boundaries, loop);
  auto& edges = drawing.part.loops.emplace_back();
  for (const auto& [name, chains] : mesh.boundaries) drawing.boundaries[name].emplace_back();
  for (std::size_t k = 0; k < begin.size(); ++k) {
    edges.push_back(edge_through(knots_between(mesh, loop, begin[k], begin[(k + 1) % begin.size()])));
    const auto member = belongs(boundaries, loop, begin[k]);
    auto in = member.begin();
    for (const auto& [name, chains] : mesh.boundaries) drawing.boundaries[name].back().push_back(*in++);
  }
}

}  // namespace

cad::Drawing drawing_of(const mesh::Mesh& mesh) {
  cad::Drawing drawing;
  drawing.options.mesh.element = mesh::corners(mesh.kind) == 3 ? mesh::CellKind::tri3 : mesh::CellKind::quad4;
  drawing.options.mesh.order = mesh::order(mesh.kind);
  drawing.options.rigid = mesh.cells.empty();
  std::vector<Facets> boundaries;
  for (const auto& [name, chains] : mesh.boundaries) boundaries.push_back(facets_of(chains));
  for (const auto& loop : mesh.outline) draw_loop(mesh, boundaries, loop, drawing);
  wish_sizes_of(mesh, drawing);
  return drawing;
}

void wish_sizes_of(const mesh::Mesh& mesh, cad::Drawing& drawing) {
  double& far = drawing.options.mesh.far_size_mm;
  if (far == 0.0) far = largest_size(mesh);
  if (!drawing.zones.empty()) return;
  const auto traced = trace(drawing.part.loops, mesh.outline, mesh.X);
  for (std::size_t l = 0; l < traced.start.size() && traced.failure.empty(); ++l)
    for (std::size_t k = 0; k < traced.start[l].size(); ++k)
      if (auto zone = zone_on(mesh, nodes_on(mesh.outline[l], traced.start[l], k), far)) drawing.zones.push_back(*zone);
}

}  // namespace reye::adapt
