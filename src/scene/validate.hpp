#pragma once
#include "scene/check.hpp"
#include "scene/entry.hpp"
#include "scene/scene.hpp"

/// Rules between tables: named entries must exist and fit their use.
/// Edges that no [boundary] names may be physical curves of the geometry: they are left to its stage.
namespace reye::scene {

void validate(const Entry& root, const Scene& scene, Issues& issues);

/// Contacts as a whole: sides on two bodies, a secondary side that can deform, no ring.
void validate_contacts(const Entry& root, const Scene& scene, Issues& issues);

/// Notes values that are impossible in the unit of their key, with their value in the unit probably meant, and a jump
/// beyond its step.
void suspicious_values(const Entry& root, const Scene& scene, Issues& found);

/// Suspicious values that are not errors.
Issues suspicious(const Entry& root, const Scene& scene);

}  // namespace reye::scene
