#pragma once
#include <set>
#include <span>
#include <string>

#include "scene/check.hpp"
#include "scene/entry.hpp"
#include "scene/histories.hpp"
#include "scene/scene.hpp"

/// Rules between tables: named entries must exist and fit their use.
/// Edges that no [boundary] names may be physical curves of the geometry: they are left to its stage.
namespace reye::scene {

void validate(const Entry& root, const Scene& scene, Issues& issues);

/// Why lives do not scale as 1 / (wear coefficient); empty when they do.
std::string no_band_rule(const Scene& scene);

/// Contacts as a whole: sides on two bodies, a secondary side that can deform, no ring.
void validate_contacts(const Entry& root, const Scene& scene, Issues& issues);

/// Notes values that are impossible in the unit of their key, with their value in the unit probably meant, and a jump
/// beyond its step.
void suspicious_values(const Entry& root, const Scene& scene, Issues& found);

/// Notes histories that no step plays, and those that nothing names.
void warn_of_idle(const Entry& root, const Played& played, const std::set<std::string>& acting, Issues& found);

/// Notes what thinning has taken from a measured history, and a duration that is not its own.
void warn_of_measured(const Entry& root, const std::map<std::string, Measured>& all, Issues& found);

/// Notes a modulus that no solid has, and a friction that no dry contact has.
void look_at_modulus(const Entry& material, Issues& found);
void look_at_friction(const Entry& contact, double friction, Issues& found);
/// Notes motions of a support, by their names, that are probably in metres.
void look_at_motions(const Entry& support, std::span<const char* const> names, const Played& played, Issues& found);

/// Suspicious values that are not errors.
Issues suspicious(const Entry& root, const Scene& scene);

}  // namespace reye::scene
