#include "fem/places.hpp"

#include <algorithm>

#include "base/errors.hpp"

namespace reye::fem {

int nearest_node(const mesh::Mesh& mesh, const base::Vec2& point) {
  const auto nearer = [&](const base::Vec2& a, const base::Vec2& b) {
    return (a - point).squaredNorm() < (b - point).squaredNorm();
  };
  return static_cast<int>(std::min_element(mesh.X.begin(), mesh.X.end(), nearer) - mesh.X.begin());
}

const mesh::Boundary& boundary_of(const mesh::Mesh& mesh, const std::string& name, const std::string& key) {
  const auto found = mesh.boundaries.find(name);
  if (found == mesh.boundaries.end()) throw base::InputError({{key, name, "names no boundary of this body"}});
  return found->second;
}

}  // namespace reye::fem
