#pragma once
#include <string>
#include <vector>

#include "scene/spec.hpp"

/// Suggestions of the name that the user may have meant.
namespace reye::scene {

/// The name nearest to `name` by edit distance; empty when none is near.
std::string nearest(const std::string& name, const std::vector<std::string>& names);

/// `unknown key; did you mean nu?`, or the keys known at this place.
std::string unknown_rule(const std::string& name, const Spec& place);

/// `there is no material "stel"; did you mean "steel"?`
std::string unknown_name_rule(const std::string& what, const std::string& name, const std::vector<std::string>& names);

}  // namespace reye::scene
