#pragma once
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "scene/read.hpp"
#include "sim/problem/problem.hpp"
#include "sim/study/prepare.hpp"
#include "support/temporary_folder.hpp"

namespace reye::support {

/// The problem of the `scene.toml` among some files, name and text, in a folder that is removed again whatever happens.
inline sim::Problem problem_from(const std::vector<std::pair<std::string, std::string>>& files) {
  const TemporaryFolder folder;
  for (const auto& [file, text] : files) std::ofstream(folder / file) << text;
  return sim::prepare(scene::read(folder / "scene.toml"));
}

}  // namespace reye::support
