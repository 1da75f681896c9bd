#pragma once
#include <string>

#include "mesh/mesh.hpp"

/// Where loads and supports act.
namespace reye::fem {

/// The node nearest to a point; the lowest index among equals.
int nearest_node(const mesh::Mesh& mesh, const base::Vec2& point);

/// The boundary of that name; throws base::InputError on `key` (say "load.top.edge") when there is none.
const mesh::Boundary& boundary_of(const mesh::Mesh& mesh, const std::string& name, const std::string& key);

}  // namespace reye::fem
