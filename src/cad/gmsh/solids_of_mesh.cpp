#include <gmsh.h>

#include <algorithm>
#include <map>

#include "cad/gmsh/model.hpp"
#include "cad/gmsh/open_solids.hpp"

namespace reye::cad {

namespace {

struct MeshKind {
  int gmsh_type;
  mesh::SolidKind kind;
};
constexpr MeshKind mesh_kinds[] = {
    {4, mesh::SolidKind::tet4}, {11, mesh::SolidKind::tet10}, {5, mesh::SolidKind::hex8}};

mesh::SolidKind kind_of_cells(const std::string& path, const std::vector<int>& types) {
  for (const MeshKind& each : mesh_kinds)
    if (types.size() == 1 && types[0] == each.gmsh_type) return each.kind;
  refuse(path, "the mesh of a solid must be all tetrahedra of 4 or 10 nodes or all hexahedra of 8");
}

/// The nodes of a body by their number in the file.
class FileNodes {
 public:
  int add(std::size_t tag, Points3& X) {
    const auto [entry, is_new] = place_.try_emplace(tag, static_cast<int>(X.size()));
    if (is_new) {
      std::vector<double> x, parameters;
      gmsh::model::mesh::getNode(tag, x, parameters);
      X.emplace_back(x.at(0), x.at(1), x.at(2));
    }
    return entry->second;
  }
  int find(std::size_t tag) const {
    const auto found = place_.find(tag);
    return found == place_.end() ? -1 : found->second;
  }

 private:
  std::map<std::size_t, int> place_;
};

void add_cells(const std::string& path, int volume, RawSolidMesh& mesh, FileNodes& places) {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> ids, nodes;
  gmsh::model::mesh::getElements(types, ids, nodes, 3, volume);
  if (types.empty()) return;
  const mesh::SolidKind kind = kind_of_cells(path, types);
  if (!mesh.cells.empty() && mesh.kind != kind) refuse(path, "the cells of a body must be of one kind");
  mesh.kind = kind;
  const int each = mesh::solid_nodes(kind);
  for (std::size_t i = 0; i + each <= nodes[0].size(); i += each) {
    mesh::SolidCell& cell = mesh.cells.emplace_back();
    cell.fill(-1);
    for (int k = 0; k < each; ++k) cell[k] = places.add(nodes[0][i + k], mesh.nodes);
    if (kind == mesh::SolidKind::tet10) std::swap(cell[8], cell[9]);  // gmsh's last edges are 23 and 13
  }
}

/// The corners of a facet of a body, ascending; nothing where a node is not the body's.
std::optional<FacetCorners> corners_of_facet(const std::size_t* tags, int count, const FileNodes& places) {
  FacetCorners corners{-1, -1, -1, -1};
  for (int k = 0; k < count; ++k)
    if ((corners[k] = places.find(tags[k])) < 0) return std::nullopt;
  std::sort(corners.begin(), corners.end());
  return corners;
}

void name_facets(RawSolidMesh& mesh, const FileNodes& places) {
  gmsh::vectorpair surfaces;
  gmsh::model::getEntities(surfaces, 2);
  for (const auto& [dim, tag] : surfaces) {
    const std::set<std::string> names = physical_names(2, tag);
    if (names.empty()) continue;
    std::vector<int> types;
    std::vector<std::vector<std::size_t>> ids, nodes;
    gmsh::model::mesh::getElements(types, ids, nodes, 2, tag);
    for (std::size_t t = 0; t < types.size(); ++t) {
      const std::size_t each = ids[t].empty() ? 0 : nodes[t].size() / ids[t].size();
      const int corners = types[t] == 3 || types[t] == 10 || types[t] == 16 ? 4 : 3;
      for (std::size_t i = 0; each >= 3 && i + each <= nodes[t].size(); i += each)
        if (const auto facet = corners_of_facet(&nodes[t][i], corners, places))
          mesh.names[*facet].insert(names.begin(), names.end());
    }
  }
}

}  // namespace

std::vector<RawSolid> solids_of_mesh(const std::string& path) {
  std::vector<RawSolid> solids = labelled_volumes();
  for (RawSolid& solid : solids) {
    FileNodes places;
    for (int volume : solid.volumes) add_cells(path, volume, solid.mesh, places);
    name_facets(solid.mesh, places);
  }
  std::erase_if(solids, [](const RawSolid& solid) { return solid.mesh.cells.empty(); });
  if (solids.empty()) refuse(path, "holds no cells of a solid");
  return solids;
}

}  // namespace reye::cad
