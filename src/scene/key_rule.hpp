#pragma once
#include <string>

#include "scene/document.hpp"
#include "scene/spec.hpp"

namespace reye::scene {

/// The rule that a key which is to be set breaks: unknown, or below a name that the scene does not have; empty when it
/// is fine. `root`: the scene; `keys`: of its kind.
std::string key_rule(const std::string& key, const Node& root, const Spec& keys);

}  // namespace reye::scene
