#pragma once
#include <array>
#include <optional>
#include <string>

#include "base/linalg.hpp"
#include "mesh/mesh.hpp"

namespace reye::adapt {

/// Two facets of an outline that meet although they are not neighbours, or neighbours folded onto each other.
struct Crossing {
  std::array<int, 2> first{}, second{};  ///< their nodes
  base::Vec2 at{0.0, 0.0};               ///< middle of the first
};

/// The first place where the loops of an outline cross or touch themselves or each other; n log^2 n, exact. Curved
/// edges count as the eight chords between points on them, which leave them by 1/64 of their height over the whole
/// chord.
std::optional<Crossing> find_crossing(const mesh::Mesh& mesh);

/// What a crossing means for the body: "worn through to boundary 'bottom'" (or "the unworn outline") when only one of
/// the two facets has moved since birth and they are of different sides, or of different loops; "the body is worn into
/// two pieces" when two worn sides of one loop meet; else "the worn outline crosses itself".
std::string meaning(const Crossing& crossing, const mesh::Mesh& now, const mesh::Mesh& born);

}  // namespace reye::adapt
