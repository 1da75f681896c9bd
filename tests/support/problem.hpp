#pragma once
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "scene/read.hpp"
#include "sim/problem.hpp"

namespace reye::support {

/// The problem of the `scene.toml` among some files, name and text, in a folder that is removed again whatever happens.
inline sim::Problem problem_from(const std::vector<std::pair<std::string, std::string>>& files) {
  struct Folder {
    std::filesystem::path path;
    ~Folder() { std::filesystem::remove_all(path); }
  };
  auto name = (std::filesystem::temp_directory_path() / "reye_problem_XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
  const Folder folder{name};
  for (const auto& [file, text] : files) std::ofstream(folder.path / file) << text;
  return sim::prepare(scene::read((folder.path / "scene.toml").string()));
}

}  // namespace reye::support
