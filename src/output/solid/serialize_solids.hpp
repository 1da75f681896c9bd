#pragma once
#include "mesh/solid/solid_mesh.hpp"
#include "output/run/serialize.hpp"

/// cereal functions for meshes of solids.
namespace reye::mesh {

template <class Archive>
void serialize(Archive& archive, Facet& s) {
  auto& [kind, nodes, group] = s;
  archive(kind, nodes, group);
}

template <class Archive>
void serialize(Archive& archive, SolidMesh& s) {
  auto& [X, kind, cells, skin, faces] = s;
  archive(X, kind, cells, skin, faces);
}

}  // namespace reye::mesh
