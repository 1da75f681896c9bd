#pragma once
#include "scene/check.hpp"
#include "scene/entry.hpp"
#include "scene/solid/solid_scene.hpp"

/// Rules between tables of a scene of solids: named entries exist and fit their use.
/// Faces that no [face] names may be physical surfaces of the geometry: they are left to its stage.
namespace reye::scene {

void validate_solid(const Entry& root, const SolidScene& scene, Issues& issues);

/// Why lives do not scale as 1 / (wear coefficient); empty when they do.
std::string no_band_rule(const SolidScene& scene);

/// Contacts as a whole: sides on two bodies, a secondary side that can deform and is so once, no pair of faces twice.
void validate_skin_contacts(const Entry& root, const SolidScene& scene, Issues& issues);

/// Suspicious values that are not errors.
Issues suspicious_solid(const Entry& root, const SolidScene& scene);

}  // namespace reye::scene
