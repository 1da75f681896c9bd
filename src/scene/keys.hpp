#pragma once
#include <span>

#include "scene/key.hpp"

/// The one table of keys of a plane scene. Scenes of solids have their own.
namespace reye::scene {

std::span<const Key> keys();

}  // namespace reye::scene
