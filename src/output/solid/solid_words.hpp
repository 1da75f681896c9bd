#pragma once
#include <string>

#include "scene/solid/solid_scene.hpp"

/// What a scene of solids says, in words for readers.
namespace reye::output {

/// "x", "-z", or "(0.6, 0.8, 0)" for a direction along no axis.
std::string direction_in_words(const base::Vec3& v);

/// "(1, 0, 2.5)"
std::string place_in_words(const base::Vec3& v);

/// "steel, E 210000 MPa, nu 0.3", or "rigid".
std::string solid_material_in_words(const scene::SolidScene& scene, const cad::SolidBodyOptions& body);

/// Where a support or a load acts: "face top", "body ball".
std::string place_of(const std::string& face, const std::string& body);

/// Its motions that are not free, each with value and history: "normal fixed", "x fixed, y 0.1 mm × slide, z 5 N".
std::string solid_support_in_words(const body::SolidSupport& support);

std::string solid_load_in_words(const body::SolidLoad& load);

/// "2 mm × slide along x" or "0.1 rad × turn about z through (0, 0, 0)"; empty without parts.
std::string sliding_in_words(const contact::ImposedSliding& sliding);

}  // namespace reye::output
