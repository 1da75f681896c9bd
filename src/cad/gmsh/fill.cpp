#include <gmsh.h>

#include <algorithm>
#include <map>
#include <optional>

#include "cad/gmsh/level_heap.hpp"
#include "cad/gmsh/session.hpp"
#include "cad/meshing/kernel.hpp"
#include "cad/part/text.hpp"
#include "mesh/outline.hpp"
#include "mesh/quality.hpp"

namespace reye::cad {

namespace {

using Tag = std::size_t;

/// The result of gmsh for a region, with gmsh's node numbers.
struct Filling {
  Points X;
  std::vector<mesh::Cell> cells;
};

/// The pairs of gmsh's 2D and recombination algorithms in the order of trust. 8 crashes in gmsh 4.8; 3 and 2 are
/// all-quad, of which 3 gives the better shapes.
struct Algorithm {
  int planar, recombination;
};
constexpr Algorithm quad_algorithms[] = {{6, 3}, {5, 3}, {6, 2}, {5, 2}};
constexpr Algorithm tri_algorithms[] = {{6, 0}, {5, 0}};

void set_options(const Algorithm& algorithm) {
  const std::pair<const char*, double> options[] = {
      {"Mesh.MeshSizeExtendFromBoundary", 0},
      {"Mesh.MeshSizeFromPoints", 0},
      {"Mesh.MeshSizeFromCurvature", 0},
      {"Mesh.MeshSizeMin", 0},
      {"Mesh.MeshSizeMax", 1e22},
      {"Mesh.MeshSizeFactor", 1},
      {"Mesh.ElementOrder", 1},
      {"Mesh.SubdivisionAlgorithm", 0},
      {"Mesh.RecombineAll", 0},
      {"Mesh.Smoothing", 5},
      {"Mesh.Renumber", 0},
      {"Mesh.RandomFactor", 1e-9},
      {"Mesh.Algorithm", static_cast<double>(algorithm.planar)},
      {"Mesh.RecombinationAlgorithm", static_cast<double>(algorithm.recombination)}};
  for (const auto& [name, value] : options) gmsh::option::setNumber(name, value);
}

/// One discrete curve from corner to corner, its nodes as given. Tags: gmsh node = region node + 1.
void add_run(int curve, const std::vector<int>& nodes, const Points& X, int begin_point, int end_point) {
  gmsh::model::addDiscreteEntity(1, curve, {begin_point, end_point});
  std::vector<Tag> inner, ends;
  std::vector<double> coordinates;
  for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
    inner.push_back(nodes[i] + 1);
    coordinates.insert(coordinates.end(), {X[nodes[i]].x(), X[nodes[i]].y(), 0.0});
  }
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    ends.push_back(nodes[i] + 1);
    ends.push_back(nodes[i + 1] + 1);
  }
  gmsh::model::mesh::addNodes(1, curve, inner, coordinates);
  gmsh::model::mesh::addElementsByType(curve, 1, {}, ends);
}

std::vector<std::size_t> corners_of(const RegionLoop& loop) {
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < loop.nodes.size(); ++i)
    if (loop.corner[i]) corners.push_back(i);
  return corners;
}

void add_corner(int point, int node, const Vec2& x) {
  gmsh::model::addDiscreteEntity(0, point);
  gmsh::model::mesh::addNodes(0, point, {static_cast<Tag>(node + 1)}, {x.x(), x.y(), 0.0});
  gmsh::model::mesh::addElementsByType(point, 15, {}, {static_cast<Tag>(node + 1)});
}

/// The nodes of a loop from one place in it to another, round its end if need be.
std::vector<int> nodes_between(const RegionLoop& loop, std::size_t first, std::size_t last) {
  const std::size_t count = loop.nodes.size();
  std::vector<int> nodes{loop.nodes[first]};
  for (std::size_t i = (first + 1) % count; i != last; i = (i + 1) % count) nodes.push_back(loop.nodes[i]);
  nodes.push_back(loop.nodes[last]);
  return nodes;
}

/// A loop as discrete points at its corners and curves between them; returns the curves in order.
std::vector<int> add_loop(const RegionLoop& loop, const Points& X, int& next_entity) {
  const std::vector<std::size_t> corners = corners_of(loop);
  const int base = next_entity;
  next_entity += static_cast<int>(corners.size());
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const int node = loop.nodes[corners[k]];
    add_corner(base + static_cast<int>(k), node, X[node]);
  }
  std::vector<int> curves;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::size_t next = (k + 1) % corners.size();
    const int point = base + static_cast<int>(k);  // and the curve that begins there
    add_run(point, nodes_between(loop, corners[k], corners[next]), X, point, base + static_cast<int>(next));
    curves.push_back(point);
  }
  return curves;
}

/// Positions by the numbers that gmsh gives to nodes.
std::map<Tag, Vec2> positions_of_nodes() {
  std::vector<Tag> tags;
  std::vector<double> coordinates, parameters;
  gmsh::model::mesh::getNodes(tags, coordinates, parameters);
  std::map<Tag, Vec2> where;
  for (std::size_t i = 0; i < tags.size(); ++i) where[tags[i]] = {coordinates[3 * i], coordinates[3 * i + 1]};
  return where;
}

/// Cells by the numbers that gmsh gives to nodes, as cells whose nodes are numbered as they come.
Filling numbered(const std::vector<Tag>& connectivity, int corners) {
  const std::map<Tag, Vec2> where = positions_of_nodes();
  Filling filling;
  std::map<Tag, int> number;
  for (std::size_t i = 0; i < connectivity.size(); i += corners) {
    mesh::Cell cell = mesh::cell_of({});
    for (int k = 0; k < corners; ++k) {
      const Tag tag = connectivity[i + k];
      const auto [entry, is_new] = number.try_emplace(tag, static_cast<int>(filling.X.size()));
      if (is_new) filling.X.push_back(where.at(tag));
      cell[k] = entry->second;
    }
    filling.cells.push_back(cell);
  }
  return filling;
}

/// Cells and nodes of the finished surface; nothing if gmsh left cells of another kind.
std::optional<Filling> read_surface(mesh::CellKind kind) {
  std::vector<int> types;
  std::vector<std::vector<Tag>> ids, connectivity;
  gmsh::model::mesh::getElements(types, ids, connectivity, 2, 1);
  const int wanted = kind == mesh::CellKind::tri3 ? 2 : 3;
  if (types.size() != 1 || types[0] != wanted) return std::nullopt;
  return numbered(connectivity[0], mesh::nodes_per_cell(kind));
}

std::optional<Filling> run_gmsh(const Region& region, const SizeField& size, const Algorithm& algorithm) {
  gmsh::model::add("region");
  int next_entity = 1;
  std::vector<int> wires;
  for (const RegionLoop& loop : region.loops) {
    const std::vector<int> curves = add_loop(loop, region.X, next_entity);
    wires.push_back(gmsh::model::geo::addCurveLoop(curves));
  }
  gmsh::model::geo::addPlaneSurface(wires, 1);
  gmsh::model::geo::synchronize();
  set_options(algorithm);
  if (region.kind == mesh::CellKind::quad4) gmsh::model::mesh::setRecombine(2, 1);
  gmsh::model::mesh::setSizeCallback([&](int, int, double x, double y, double) { return size({x, y}); });
  std::optional<Filling> filling;
  // Errors inside gmsh's mesher are thrown in a parallel region and end the process unless gmsh is set to continue.
  gmsh::option::setNumber("General.AbortOnError", 0);
  try {
    gmsh::model::mesh::generate(2);
    filling = read_surface(region.kind);
  } catch (const std::string&) {  // another algorithm may succeed
  }
  gmsh::option::setNumber("General.AbortOnError", 2);
  gmsh::model::mesh::removeSizeCallback();
  gmsh::model::remove();
  return filling;
}

/// The filling's outline loop that starts at the given point, from there onward; empty if there is none.
mesh::Chain loop_from(const std::vector<mesh::Chain>& outline, const Points& X, const Vec2& start) {
  const auto is_start = [&](int node) { return (X[node] - start).norm() <= 1e-12 * (1.0 + start.norm()); };
  for (mesh::Chain loop : outline) {
    loop.pop_back();
    const auto found = std::find_if(loop.begin(), loop.end(), is_start);
    if (found == loop.end()) continue;
    std::rotate(loop.begin(), found, loop.end());
    return loop;
  }
  return {};
}

/// Joins the filling to the region. gmsh's all-quad algorithms put every second outline node in the middle
/// of its neighbours; walking both outlines side by side puts them back. False if the outlines differ.
bool join(Region& region, const Filling& filling) {
  const std::vector<mesh::Chain> outline = mesh::outline_of(filling.X, region.kind, filling.cells);
  std::vector<int> number(filling.X.size(), -1);
  for (const RegionLoop& loop : region.loops) {
    const std::size_t start = std::find(loop.corner.begin(), loop.corner.end(), true) - loop.corner.begin();
    const mesh::Chain made = loop_from(outline, filling.X, region.X[loop.nodes[start]]);
    if (made.size() != loop.nodes.size()) return false;
    for (std::size_t i = 0; i < made.size(); ++i) number[made[i]] = loop.nodes[(start + i) % made.size()];
  }
  for (std::size_t i = 0; i < filling.X.size(); ++i) {
    if (number[i] >= 0) continue;
    number[i] = static_cast<int>(region.X.size());
    region.X.push_back(filling.X[i]);
  }
  for (mesh::Cell cell : filling.cells) {
    for (int k = 0; k < mesh::nodes_per_cell(region.kind); ++k) cell[k] = number[cell[k]];
    region.cells.push_back(cell);
  }
  return true;
}

double poorest(const Region& region) {
  double quality = 1.0;
  for (const mesh::Cell& cell : region.cells)
    quality = std::min(quality, mesh::scaled_jacobian(region.X, region.kind, cell));
  return quality;
}

}  // namespace

void fill_by_gmsh(Region& region, const SizeField& size) {
  const Session session;
  level_heap_once();
  constexpr double good_enough = 0.2;  // below it the next algorithm is tried, and the best is kept
  std::vector<Algorithm> algorithms(std::begin(quad_algorithms), std::end(quad_algorithms));
  if (region.kind == mesh::CellKind::tri3) algorithms.assign(std::begin(tri_algorithms), std::end(tri_algorithms));
  Region best;
  double quality = 0.0;
  guarded([&] {
    for (const Algorithm& algorithm : algorithms) {
      const std::optional<Filling> filling = run_gmsh(region, size, algorithm);
      Region attempt = region;
      if (!filling || !join(attempt, *filling)) continue;
      improve(attempt, static_cast<int>(region.X.size()));
      if (poorest(attempt) <= quality) continue;
      quality = poorest(attempt);
      best = std::move(attempt);
      if (quality > good_enough) break;
    }
  });
  if (best.cells.empty())
    throw base::MeshError("gmsh finds no mesh with positive Jacobians for the face round " +
                          text(region.X[region.loops[0].nodes[0]]));
  best.loops.clear();
  region = std::move(best);
}

}  // namespace reye::cad
