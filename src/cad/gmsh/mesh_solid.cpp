#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cad/gmsh/open_solids.hpp"
#include "cad/gmsh/session.hpp"
#include "cad/solid/solid_kernel.hpp"
#include "cad/solid/solid_shape.hpp"

namespace reye::cad {

namespace {

using base::Vec3;

/// The most that an element turns along a curved face [rad], and its smallest size for that as a share of the far size.
constexpr double turn_first_order = std::numbers::pi / 9.0, turn_second_order = std::numbers::pi / 6.0;
constexpr double least_share = 0.1;

/// gmsh's node numbers as places in the order in which they are met.
class Numbering {
 public:
  Numbering() {
    std::vector<std::size_t> tags;
    std::vector<double> x, parameters;
    gmsh::model::mesh::getNodes(tags, x, parameters);
    std::size_t most = 0;
    for (std::size_t tag : tags) most = std::max(most, tag);
    place_.assign(most + 1, -1);
    where_.assign(most + 1, Vec3::Zero());
    for (std::size_t i = 0; i < tags.size(); ++i) where_[tags[i]] = {x[3 * i], x[3 * i + 1], x[3 * i + 2]};
  }

  int operator()(std::size_t tag) {
    int& place = place_.at(tag);
    if (place < 0) {
      place = static_cast<int>(X.size());
      X.push_back(where_[tag]);
    }
    return place;
  }

  Points3 X;

 private:
  std::vector<int> place_;
  Points3 where_;
};

SolidSize size_of(const SolidOrder& order, const std::vector<int>& faces, double far_size) {
  const double turn = order.second_order ? turn_second_order : turn_first_order;
  std::vector<SizePoint> points;
  for (int face : faces)
    for (SizePoint point : kept_radii()[face]) {
      point.size = std::max(least_share * far_size, turn * point.size);
      points.push_back(point);
    }
  return SolidSize(far_size, order.growth, order.zones, std::move(points));
}

void show_alone(const std::vector<int>& volumes) {
  gmsh::vectorpair all, shown;
  gmsh::model::getEntities(all);
  gmsh::model::setVisibility(all, 0, false);
  for (int volume : volumes) shown.emplace_back(3, volume);
  gmsh::model::setVisibility(shown, 1, true);
}

/// Algorithms of gmsh for surfaces and volumes, and the share of the far size, in the order of trust: Frontal-Delaunay
/// and HXT, Delaunay, MeshAdapt; the worst that comes with thin walls mends itself with smaller elements.
struct SolidAlgorithm {
  int surface, volume;
  double share;
};
constexpr SolidAlgorithm solid_algorithms[] = {{6, 10, 1.0}, {6, 1, 1.0}, {1, 10, 1.0}, {6, 10, 0.5}, {6, 1, 0.25}};

void run_mesher(const SolidOrder& order, const SolidAlgorithm& algorithm, const SolidSize& size) {
  gmsh::model::mesh::clear();
  reset_mesh_options();
  gmsh::option::setNumber("Mesh.Algorithm", algorithm.surface);
  gmsh::option::setNumber("Mesh.Algorithm3D", algorithm.volume);
  gmsh::option::setNumber("Mesh.MeshOnlyVisible", 1);
  show_alone(order.volumes);
  gmsh::model::mesh::setSizeCallback([&](int, int, double x, double y, double z) { return size({x, y, z}); });
  try {
    gmsh::model::mesh::generate(order.skin_only ? 2 : 3);
    if (order.second_order) gmsh::model::mesh::setOrder(2);
  } catch (...) {
    gmsh::model::mesh::removeSizeCallback();
    throw;
  }
  gmsh::model::mesh::removeSizeCallback();
}

/// Nodes of the elements of the one kind that an entity may hold.
std::vector<std::size_t> elements_of_kind(int dim, int tag, int kind) {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> ids, nodes;
  gmsh::model::mesh::getElements(types, ids, nodes, dim, tag);
  if (types.empty()) throw std::string(dim == 3 ? "the volume stays empty" : "a face stays empty");
  if (types.size() != 1 || types[0] != kind) throw std::string("elements of another kind than asked for");
  return nodes[0];
}

RawSolidMesh read_solid_mesh(const SolidOrder& order, const std::vector<int>& faces) {
  RawSolidMesh mesh;
  mesh.kind = order.second_order ? mesh::SolidKind::tet10 : mesh::SolidKind::tet4;
  Numbering number;
  const int per_cell = mesh::solid_nodes(mesh.kind), per_facet = order.second_order ? 6 : 3;
  for (int volume : order.skin_only ? std::vector<int>{} : order.volumes) {
    const auto nodes = elements_of_kind(3, volume, order.second_order ? 11 : 4);
    for (std::size_t i = 0; i < nodes.size(); i += per_cell) {
      mesh::SolidCell& cell = mesh.cells.emplace_back();
      cell.fill(-1);
      for (int k = 0; k < per_cell; ++k) cell[k] = number(nodes[i + k]);
      if (order.second_order) std::swap(cell[8], cell[9]);  // gmsh's last edges are 23 and 13
    }
  }
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto nodes = elements_of_kind(2, faces[f], order.second_order ? 9 : 2);
    for (std::size_t i = 0; i < nodes.size(); i += per_facet) {
      mesh::Facet& facet = mesh.facets.emplace_back();
      facet.kind = mesh::facet_kind(mesh.kind);
      facet.group = static_cast<int>(f);
      for (int k = 0; k < per_facet; ++k) facet.nodes[k] = number(nodes[i + k]);
    }
  }
  mesh.nodes = std::move(number.X);
  return mesh;
}

/// Cells whose curved edges take more than four fifths of their Jacobian.
std::size_t bent_cells(const RawSolidMesh& mesh) {
  constexpr double least = 0.2;
  return static_cast<std::size_t>(std::count_if(mesh.cells.begin(), mesh.cells.end(), [&](const mesh::SolidCell& cell) {
    return least_jacobian(mesh.nodes, mesh.kind, cell) < least;
  }));
}

/// Lets gmsh move nodes where a few cells are bent badly; where many are, elements are too large for their faces and it
/// would take long for little.
void mend_bent_cells(const SolidOrder& order, const std::vector<int>& faces, RawSolidMesh& mesh) {
  constexpr double few = 0.02;
  const std::size_t bent = bent_cells(mesh);
  if (bent == 0 || static_cast<double>(bent) > few * static_cast<double>(mesh.cells.size())) return;
  try {
    gmsh::option::setNumber("Mesh.HighOrderThresholdMin", 0.2);
    gmsh::model::mesh::optimize("HighOrder");
    RawSolidMesh mended = read_solid_mesh(order, faces);
    if (bent_cells(mended) < bent) mesh = std::move(mended);
  } catch (const std::string&) {  // its edges become straight instead
  }
}

RawSolidMesh attempt(const SolidOrder& order, const std::vector<int>& faces, const SolidAlgorithm& algorithm) {
  const SolidSize size = size_of(order, faces, algorithm.share * order.far_size);
  run_mesher(order, algorithm, size);
  RawSolidMesh mesh = read_solid_mesh(order, faces);
  if (order.second_order) mend_bent_cells(order, faces, mesh);
  return mesh;
}

}  // namespace

RawSolidMesh mesh_by_gmsh(const SolidOrder& order) {
  constexpr double good_enough = 0.1;  // mean ratio of the worst cell; below it the next algorithm is tried
  const Silence silence;
  const std::vector<int> faces = outer_faces(order.volumes);
  RawSolidMesh best;
  double quality = 0.0;
  std::string failure = "no mesh";
  for (const SolidAlgorithm& algorithm : solid_algorithms) {
    try {
      RawSolidMesh made = attempt(order, faces, algorithm);
      const double worst = worst_mean_ratio(made);
      if (worst <= quality) continue;
      quality = worst;
      best = std::move(made);
      if (quality > good_enough) break;
    } catch (const std::string& message) {
      failure = message;
    }
  }
  if (best.facets.empty()) throw base::MeshError("gmsh: " + failure);
  return best;
}

}  // namespace reye::cad
