#pragma once
#include <array>
#include <optional>

#include "base/linalg.hpp"
#include "mesh/mesh.hpp"

namespace reye::adapt {

/// Two facets of an outline that meet although they are not neighbours, or neighbours folded onto each other.
struct Crossing {
  std::array<int, 2> first{}, second{};  ///< their nodes
  base::Vec2 at{0.0, 0.0};               ///< middle of the first
};

/// The first place where the loops of an outline cross or touch themselves or each other; n log^2 n, exact.
std::optional<Crossing> find_crossing(const mesh::Mesh& mesh);

}  // namespace reye::adapt
