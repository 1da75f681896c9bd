#pragma once
#include <map>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "scene/extension.hpp"
#include "scene/solid/solid_scene.hpp"

namespace reye::scene {

/// The path of one of the scene's files, seen from the folder of the scene.
std::string path_from_scene(const SolidScene& scene, const std::string& file);

/// How a scene of solids extends another one, as in the plane: by more cycles of its last step.
Extension extension_of(const std::string& was, const std::string& was_fixed, const SolidScene& now);

/// An issue for each file of the scene whose content differs from that of the run to be resumed, whose files had these
/// hashes (`SolidScene::file_sha256`).
std::vector<base::Issue> changed_files(const SolidScene& now, const std::map<std::string, std::string>& were);

}  // namespace reye::scene
