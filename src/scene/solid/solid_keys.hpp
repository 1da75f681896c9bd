#pragma once
#include <span>
#include <string>

#include "scene/keys.hpp"
#include "scene/spec.hpp"

namespace reye::scene {

/// The table of keys of scenes with analysis = "solid". A key that means what it means in the plane has its name.
std::span<const Key> solid_keys();

/// The tree of `solid_keys()`, built once.
const Spec& solid_spec();

/// The table as markdown, for geo/REFERENCE.md.
std::string solid_reference();

}  // namespace reye::scene
