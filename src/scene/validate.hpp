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

/// Values that nothing has in the unit of their key, with what they would be in the unit that was meant; a jump beyond
/// its step.
void suspicious_values(const Entry& root, const Scene& scene, Issues& found);

/// What is suspicious but no error.
Issues suspicious(const Entry& root, const Scene& scene);

}  // namespace reye::scene
