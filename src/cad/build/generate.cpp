#include "cad/build/generate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/errors.hpp"
#include "cad/meshing/bend.hpp"
#include "cad/meshing/divide.hpp"
#include "cad/meshing/points.hpp"
#include "cad/meshing/region.hpp"
#include "cad/part/text.hpp"
#include "mesh/outline.hpp"
#include "mesh/quality.hpp"
#include "mesh/second_order.hpp"

namespace reye::cad {

namespace {

/// Far size, fine zones, and the edges that need elements smaller than the far size to be resolved at all:
/// two to an edge, and 30 degrees of a curve to an element.
SizeField size_field(const BodyPlan& plan, double far) {
  SizeField size(far, plan.options->mesh.growth);
  for (const ZoneOutline& zone : plan.zones) size.add(make_source(sampled(*plan.part, zone), zone.depth, zone.size));
  for (const Loop& loop : plan.part->loops)
    for (const Edge& edge : loop) {
      const double turns = turning(edge) / (std::numbers::pi / 6.0);
      const double own = edge.length() / std::max(2.0, turns);
      if (own >= far) continue;
      Points line;
      const int pieces = edge.type == EdgeType::line ? 1 : std::max(2, static_cast<int>(std::ceil(2.0 * turns)));
      for (int i = 0; i <= pieces; ++i) line.push_back(at(edge, edge.length() * i / pieces));
      size.add(make_source(std::move(line), 0.0, own));
    }
  return size;
}

/// The node of the loop nearest to p; in all-quad meshes one that may end a run.
int node_at(const Region& region, const RegionLoop& loop, const Vec2& p) {
  const auto start = std::find(loop.corner.begin(), loop.corner.end(), true) - loop.corner.begin();
  const std::ptrdiff_t step = region.kind == mesh::CellKind::quad4 ? 2 : 1;
  int best = loop.nodes[static_cast<std::size_t>(start)];
  for (std::ptrdiff_t i = start % step; i < static_cast<std::ptrdiff_t>(loop.nodes.size()); i += step)
    if (const int node = loop.nodes[static_cast<std::size_t>(i)];
        (region.X[node] - p).squaredNorm() < (region.X[best] - p).squaredNorm())
      best = node;
  return best;
}

/// Rows of equal elements beneath a fine stretch that ends smoothly on both sides, as many as fit.
void add_zone_layers(Region& region, const std::vector<RegionLoop>& outline, const BodyPlan& plan) {
  for (const ZoneOutline& zone : plan.zones) {
    if (!zone.smooth_begin || !zone.smooth_end || zone.depth < 1.5 * zone.size) continue;
    const Loop& loop = plan.part->loops[zone.loop];
    const Stretch &begin = zone.stretches.front(), &end = zone.stretches.back();
    const int first = node_at(region, outline[zone.loop], at(loop[begin.edge], begin.begin));
    const int last = node_at(region, outline[zone.loop], at(loop[end.edge], end.end));
    const int layers = 2 * std::max(1, static_cast<int>(std::lround(0.5 * zone.depth / zone.size)));
    for (int rows = layers; rows >= 2; rows = rows / 4 * 2)  // fewer where the outline bends too much for all
      if (add_layers(region, first, last, rows, zone.depth * rows / layers)) break;
  }
}

/// Which segments of each divided loop lie on the chosen edges.
std::vector<std::vector<bool>> segments_on(const std::vector<DividedLoop>& loops, const EdgeChoice& edges) {
  std::vector<std::vector<bool>> on(loops.size());
  for (std::size_t loop = 0; loop < loops.size(); ++loop)
    for (int edge : loops[loop].edge) on[loop].push_back(edges[loop][edge]);
  return on;
}

void name_boundaries(mesh::Mesh& mesh, const BodyPlan& plan, const std::vector<DividedLoop>& divided) {
  for (const auto& [name, edges] : plan.boundaries)
    mesh.boundaries[name] = mesh::chains_along(mesh.outline, segments_on(divided, edges));
}

/// The division that the outline of a mesh from a file already has.
DividedLoop divided_as_is(const Loop& loop) {
  DividedLoop divided;
  for (int k = 0; k < static_cast<int>(loop.size()); ++k)
    for (std::size_t i = 0; i + 1 < loop[k].knots.size(); ++i) divided.edge.push_back(k);
  return divided;
}

/// Removes the cells: a rigid body consists of its outline alone.
void drop_cells(mesh::Mesh& mesh) {
  Points X;
  std::vector<int> number(mesh.X.size(), -1);
  const auto renumber = [&](mesh::Chain& chain) {
    for (int& node : chain) {
      if (number[node] < 0) {
        number[node] = static_cast<int>(X.size());
        X.push_back(mesh.X[node]);
      }
      node = number[node];
    }
  };
  for (mesh::Chain& loop : mesh.outline) renumber(loop);
  for (auto& [name, chains] : mesh.boundaries)
    for (mesh::Chain& chain : chains) renumber(chain);
  mesh.X = std::move(X);
  mesh.cells.clear();
}

mesh::Mesh take_over(const BodyPlan& plan) {
  mesh::Mesh mesh = *plan.part->mesh;
  std::vector<DividedLoop> divided;
  for (const Loop& loop : plan.part->loops) divided.push_back(divided_as_is(loop));
  name_boundaries(mesh, plan, divided);
  if (plan.options->rigid) drop_cells(mesh);
  return plan.options->mesh.order == 2 ? mesh::to_second_order(mesh) : mesh;
}

/// The divided outline of a body as a region to fill.
Region outlined(const BodyPlan& plan, const SizeField& size, std::vector<DividedLoop>& divided) {
  const bool even = plan.options->mesh.element == mesh::CellKind::quad4 && !plan.options->rigid;
  Region region;
  region.kind = plan.options->mesh.element;
  const auto marks = marks_of(*plan.part, plan.options->points_mm, size);
  for (int k = 0; k < static_cast<int>(plan.part->loops.size()); ++k) {
    std::vector<ZoneOutline> zones;
    for (const ZoneOutline& zone : plan.zones)
      if (zone.loop == k) zones.push_back(zone);
    std::vector<Mark> points;
    for (const Mark& mark : marks)
      if (mark.loop == k) points.push_back(mark);
    divided.push_back(divide(plan.part->loops[k], zones, size, even, points));
    RegionLoop loop{{}, divided.back().corner};
    for (const Vec2& p : divided.back().nodes) {
      loop.nodes.push_back(static_cast<int>(region.X.size()));
      region.X.push_back(p);
    }
    region.loops.push_back(std::move(loop));
  }
  return region;
}

/// Turning of a closed run of nodes at its i-th one [rad].
double turning_at(const Points& X, const std::vector<int>& nodes, std::size_t i) {
  const std::size_t n = nodes.size();
  const Vec2 in = X[nodes[i]] - X[nodes[(i + n - 1) % n]], out = X[nodes[(i + 1) % n]] - X[nodes[i]];
  return std::abs(std::atan2(base::cross(in, out), in.dot(out)));
}

/// Which nodes of a loop that starts at its sharpest one end a run for gmsh: ends of edges, those at an even distance
/// from the start where every other node is to be left out; at least two.
std::vector<bool> corners_of(const Points& X, const std::vector<int>& nodes, const Loop& edges, bool even) {
  std::vector<bool> corner(nodes.size(), false);
  corner[0] = true;
  int found = 1;
  for (const Edge& edge : edges) {
    const auto nearest = std::min_element(nodes.begin(), nodes.end(), [&](int a, int b) {
      return (X[a] - edge.first()).squaredNorm() < (X[b] - edge.first()).squaredNorm();
    });
    const auto i = static_cast<std::size_t>(nearest - nodes.begin());
    if (corner[i] || (even && i % 2 == 1)) continue;
    corner[i] = true;
    ++found;
  }
  if (found == 1) corner[nodes.size() / 4 * 2] = true;
  return corner;
}

/// An existing outline as a region to fill; `number`: node of the region for each of the outline's.
Region region_of(const BodyPlan& plan, const mesh::Mesh& outline, std::vector<int>& number) {
  const bool even = plan.options->mesh.element == mesh::CellKind::quad4;
  Region region;
  region.kind = plan.options->mesh.element;
  number.assign(outline.X.size(), -1);
  for (std::size_t k = 0; k < outline.outline.size(); ++k) {
    std::vector<int> nodes(outline.outline[k].begin(), outline.outline[k].end() - 1);
    std::size_t sharpest = 0;
    for (std::size_t i = 1; i < nodes.size(); ++i)
      if (turning_at(outline.X, nodes, i) > turning_at(outline.X, nodes, sharpest) + 1e-6) sharpest = i;
    std::rotate(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(sharpest), nodes.end());
    const std::vector<bool> corner = corners_of(outline.X, nodes, plan.part->loops[k], even);
    for (int& node : nodes) {
      number[node] = static_cast<int>(region.X.size());
      region.X.push_back(outline.X[node]);
      node = number[node];
    }
    region.loops.push_back({std::move(nodes), corner});
  }
  return region;
}

/// Cells inside the outline that the region is.
mesh::Mesh filled(Region region, const BodyPlan& plan, const SizeField& size) {
  mesh::Mesh mesh;
  for (const RegionLoop& loop : region.loops) {
    mesh.outline.push_back(loop.nodes);
    mesh.outline.back().push_back(loop.nodes.front());
  }
  if (const auto place = crossing(region))
    throw base::MeshError("elements this coarse make the outline cross itself near " + text(*place));
  if (!plan.options->rigid && !add_grid(region, size)) {
    add_zone_layers(region, std::vector<RegionLoop>(region.loops), plan);
    fill(region, size);
  }
  mesh.X = std::move(region.X);
  mesh.kind = region.kind;
  mesh.cells = std::move(region.cells);
  draw_to_points(mesh, *plan.part, plan.options->points_mm, size);
  return mesh;
}

mesh::Mesh make_mesh(const BodyPlan& plan, double far) {
  const SizeField size = size_field(plan, far);
  std::vector<DividedLoop> divided;
  Region region = outlined(plan, size, divided);
  mesh::Mesh mesh = filled(std::move(region), plan, size);
  name_boundaries(mesh, plan, divided);
  if (plan.options->mesh.order == 1) return mesh;
  EdgesUnder under;
  for (const DividedLoop& loop : divided) under.push_back(loop.edge);
  return second_order(mesh, plan.part->loops, under);
}

/// The best of some attempts, each with half the far size: thin places may ask for less than it.
template <class Make>
mesh::Mesh best_of_attempts(const BodyPlan& plan, Make make) {
  constexpr int attempts = 5;
  constexpr double good_enough = 0.15;  // scaled Jacobian of the poorest cell
  constexpr double worth_it =
      1.05;  // an attempt that improves less is the last: the poor place is not due to coarse elements
  mesh::Mesh best;
  double quality = 0.0, far = far_size(plan);
  for (int attempt = 1; quality < good_enough && attempt <= attempts; ++attempt, far *= 0.5) {
    try {
      mesh::Mesh mesh = make(far);
      const double poorest = mesh::poorest_cell(mesh).scaled_jacobian;
      if (poorest <= worth_it * quality) break;
      quality = poorest;
      best = std::move(mesh);
    } catch (const base::MeshError&) {
      if (attempt == attempts && quality == 0.0) throw;
    }
  }
  return best;
}

}  // namespace

mesh::Mesh generate(const BodyPlan& plan) {
  mesh::Mesh mesh =
      plan.part->mesh ? take_over(plan) : best_of_attempts(plan, [&](double far) { return make_mesh(plan, far); });
  mesh.points = vertices_at(mesh, plan.options->points_mm);
  return mesh;
}

mesh::Mesh generate_within(const BodyPlan& plan, const mesh::Mesh& given) {
  const mesh::Mesh outline = mesh::to_first_order(given);
  std::vector<int> number;
  const Region region = region_of(plan, outline, number);
  mesh::Mesh mesh = filled(region, plan, size_field(plan, far_size(plan)));
  mesh.boundaries = outline.boundaries;
  for (auto& [name, chains] : mesh.boundaries)
    for (mesh::Chain& chain : chains)
      for (int& node : chain) node = number[node];
  if (mesh::order(given.kind) == 2) mesh = second_order(mesh, given);
  mesh.points = vertices_at(mesh, plan.options->points_mm);
  return mesh;
}

void clear_axis(mesh::Mesh& mesh) {
  for (Vec2& p : mesh.X) p.x() = std::max(p.x(), 0.0);
}

}  // namespace reye::cad
