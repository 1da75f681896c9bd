#pragma once
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "scene/solid/solid_scene.hpp"

namespace reye::scene {

/// The scene in a text that is, or will be, the content of the file at `path`.
SolidScene read_solid_text(const std::string& text, const std::string& path);

/// The issues of a lower room in the form of `read_solid`; the line is that of the longest part of the key that the
/// file has (line 1 when it has none). Supports of symmetric faces have the line of `symmetry`.
base::InputError located(const SolidScene& scene, const std::vector<base::Issue>& issues);

}  // namespace reye::scene
