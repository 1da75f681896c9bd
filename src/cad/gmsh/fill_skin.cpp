#include <gmsh.h>

#include <algorithm>

#include "base/errors.hpp"
#include "cad/gmsh/level_heap.hpp"
#include "cad/gmsh/open_solids.hpp"
#include "cad/gmsh/session.hpp"
#include "cad/solid/solid_kernel.hpp"
#include "cad/solid/solid_shape.hpp"

namespace reye::cad {

namespace {

/// HXT and Delaunay, in the order of trust.
constexpr int filling_algorithms[] = {10, 1};

/// A discrete surface with the triangles, and the volume in it. Tags: gmsh node = place + 1.
void add_surface(const SkinFilling& filling) {
  std::vector<std::size_t> tags, corners;
  std::vector<double> coordinates;
  for (std::size_t k = 0; k < filling.X.size(); ++k) {
    tags.push_back(k + 1);
    coordinates.insert(coordinates.end(), filling.X[k].data(), filling.X[k].data() + 3);
  }
  for (const auto& triangle : filling.triangles)
    for (int corner : triangle) corners.push_back(static_cast<std::size_t>(corner) + 1);
  gmsh::model::addDiscreteEntity(2, 1);
  gmsh::model::mesh::addNodes(2, 1, tags, coordinates);
  gmsh::model::mesh::addElementsByType(1, 2, {}, corners);
  gmsh::model::geo::addSurfaceLoop({1}, 1);
  gmsh::model::geo::addVolume({1}, 1);
  gmsh::model::geo::synchronize();
}

RawSolidMesh read_filling(const SkinFilling& filling) {
  std::vector<std::size_t> tags;
  std::vector<double> x, parameters;
  gmsh::model::mesh::getNodes(tags, x, parameters);
  RawSolidMesh mesh;
  mesh.nodes = filling.X;
  std::vector<int> place(tags.empty() ? 1 : *std::max_element(tags.begin(), tags.end()) + 1, -1);
  for (std::size_t k = 0; k < filling.X.size() && k + 1 < place.size(); ++k) place[k + 1] = static_cast<int>(k);
  for (std::size_t i = 0; i < tags.size(); ++i)
    if (place[tags[i]] < 0) {
      place[tags[i]] = static_cast<int>(mesh.nodes.size());
      mesh.nodes.emplace_back(x[3 * i], x[3 * i + 1], x[3 * i + 2]);
    }
  std::vector<std::size_t> ids, nodes;
  gmsh::model::mesh::getElementsByType(4, ids, nodes, 1);
  for (std::size_t i = 0; i + 4 <= nodes.size(); i += 4) {
    mesh::SolidCell& cell = mesh.cells.emplace_back();
    cell.fill(-1);
    for (int k = 0; k < 4; ++k) cell[k] = place[nodes[i + k]];
  }
  for (const auto& [a, b, c] : filling.triangles)
    mesh.facets.push_back({mesh::FacetKind::tri3, {a, b, c, -1, -1, -1}, 0});
  return mesh;
}

RawSolidMesh run_filling(const SkinFilling& filling, int algorithm) {
  const SolidSize size(filling.far_size, filling.growth, filling.zones, filling.points);
  gmsh::model::add("filling");
  RawSolidMesh mesh;
  try {
    add_surface(filling);
    reset_mesh_options();
    gmsh::option::setNumber("Mesh.Algorithm3D", algorithm);
    gmsh::model::mesh::setSizeCallback([&](int, int, double x, double y, double z) { return size({x, y, z}); });
    gmsh::model::mesh::generate(3);
    mesh = read_filling(filling);
  } catch (...) {
    gmsh::model::mesh::removeSizeCallback();
    gmsh::model::remove();
    throw;
  }
  gmsh::model::mesh::removeSizeCallback();
  gmsh::model::remove();
  return mesh;
}

}  // namespace

RawSolidMesh fill_skin_by_gmsh(const SkinFilling& filling) {
  constexpr double good_filling = 0.1;  // mean ratio of the worst cell; below it the next algorithm is tried
  const Silence silence;
  const Session session;
  level_heap_once();
  RawSolidMesh best;
  double quality = 0.0;
  std::string failure = "no mesh";
  for (int algorithm : filling_algorithms) {
    try {
      RawSolidMesh made = run_filling(filling, algorithm);
      const double worst = made.cells.empty() ? 0.0 : worst_mean_ratio(made);
      if (worst <= quality) continue;
      quality = worst;
      best = std::move(made);
      if (quality > good_filling) break;
    } catch (const std::string& message) {
      failure = message;
    }
  }
  if (best.cells.empty()) throw base::MeshError("gmsh: " + failure);
  return best;
}

}  // namespace reye::cad
