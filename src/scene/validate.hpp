#pragma once
#include "scene/check.hpp"
#include "scene/entry.hpp"
#include "scene/scene.hpp"

/// Rules between tables: what is named must exist, and must be able to play its part.
/// Edges that no [boundary] names may be physical curves of the geometry: they are left to its stage.
namespace reye::scene {

void validate(const Entry& root, const Scene& scene, Issues& issues);

/// Contacts as a whole: sides on two bodies, a secondary side that can deform, no ring.
void validate_contacts(const Entry& root, const Scene& scene, Issues& issues);

/// What is suspicious but no error.
Issues suspicious(const Entry& root, const Scene& scene);

}  // namespace reye::scene
