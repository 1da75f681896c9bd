#include <gmsh.h>

#include <algorithm>

#include "cad/gmsh/model.hpp"

namespace reye::cad {

namespace {

using Tag = std::size_t;

struct Elements {
  int nodes_each = 0;
  std::vector<Tag> nodes;
};

/// Quadrilaterals of nine nodes without their centre nodes, which follow the others of each.
Elements without_centres(const Elements& of_nine) {
  Elements of_eight{8, {}};
  for (std::size_t i = 0; i < of_nine.nodes.size(); ++i)
    if (i % 9 != 8) of_eight.nodes.push_back(of_nine.nodes[i]);
  return of_eight;
}

Elements elements_of(int dim, int tag) {
  std::vector<int> types;
  std::vector<std::vector<Tag>> ids, nodes;
  gmsh::model::mesh::getElements(types, ids, nodes, dim, tag);
  if (types.empty()) return {};
  const Elements elements{static_cast<int>(nodes[0].size() / ids[0].size()), nodes[0]};
  return elements.nodes_each == 9 ? without_centres(elements) : elements;
}

mesh::CellKind kind_of(int nodes_each) {
  for (auto kind : {mesh::CellKind::tri3, mesh::CellKind::tri6, mesh::CellKind::quad8})
    if (mesh::nodes_per_cell(kind) == nodes_each) return kind;
  return mesh::CellKind::quad4;
}

/// Node tags of a part in ascending order: their places are the part's own node numbers.
std::vector<Tag> distinct(std::vector<Tag> tags) {
  std::sort(tags.begin(), tags.end());
  tags.erase(std::unique(tags.begin(), tags.end()), tags.end());
  return tags;
}

int place(const std::vector<Tag>& sorted, Tag tag) {
  const auto found = std::lower_bound(sorted.begin(), sorted.end(), tag);
  return found != sorted.end() && *found == tag ? static_cast<int>(found - sorted.begin()) : -1;
}

void name_edges(RawMesh& mesh, const std::vector<Tag>& tags) {
  gmsh::vectorpair curves;
  gmsh::model::getEntities(curves, 1);
  for (const auto& [dim, curve] : curves) {
    const std::set<std::string> names = physical_names(1, curve);
    if (names.empty()) continue;
    const Elements edges = elements_of(1, curve);
    for (std::size_t i = 0; i + 1 < edges.nodes.size(); i += edges.nodes_each) {
      const auto [a, b] = std::minmax({place(tags, edges.nodes[i]), place(tags, edges.nodes[i + 1])});
      if (a >= 0) mesh.names[{a, b}].insert(names.begin(), names.end());
    }
  }
}

RawMesh make_mesh(const Elements& elements) {
  RawMesh mesh;
  mesh.kind = kind_of(elements.nodes_each);
  const std::vector<Tag> tags = distinct(elements.nodes);
  for (Tag tag : tags) {
    std::vector<double> x, parameters;
    gmsh::model::mesh::getNode(tag, x, parameters);
    mesh.nodes.emplace_back(x[0], x[1], x[2]);
  }
  for (std::size_t i = 0; i < elements.nodes.size(); i += elements.nodes_each) {
    mesh::Cell cell = mesh::cell_of({});
    for (int k = 0; k < elements.nodes_each; ++k) cell[k] = place(tags, elements.nodes[i + k]);
    mesh.cells.push_back(cell);
  }
  name_edges(mesh, tags);
  return mesh;
}

}  // namespace

std::vector<RawPart> parts_from_mesh() {
  std::vector<RawPart> parts;
  std::vector<Elements> elements;
  for (const Face& face : free_faces()) {
    const Elements own = elements_of(2, face.tag);
    if (own.nodes.empty()) continue;
    std::size_t k = 0;
    while (k < parts.size() && !(face.group && parts[k].group && parts[k].label == face.label)) ++k;
    if (k == parts.size()) {
      parts.push_back({{}, face.label, face.group, {}, {}, {}});
      elements.push_back({own.nodes_each, {}});
    }
    elements[k].nodes.insert(elements[k].nodes.end(), own.nodes.begin(), own.nodes.end());
  }
  for (std::size_t k = 0; k < parts.size(); ++k) parts[k].mesh = make_mesh(elements[k]);
  return parts;
}

}  // namespace reye::cad
