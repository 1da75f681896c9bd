#include "scene/solid/solid_extension.hpp"

#include <filesystem>

#include "scene/geometry_files.hpp"
#include "scene/rewrite.hpp"

namespace reye::scene {

namespace {

/// The key that names a file: of a measured history, or of the geometry.
std::string key_of_file(const SolidScene& scene, const std::string& file) {
  for (const auto& [name, measured] : scene.measured)
    if (path_from_scene(scene, beside(scene.path, measured.file)) == file) return "history." + name + ".file";
  return "geometry";
}

}  // namespace

std::string path_from_scene(const SolidScene& scene, const std::string& file) {
  return std::filesystem::path(file).lexically_relative(scene.geometry.folder).string();
}

Extension extension_of(const std::string& was, const std::string& was_fixed, const SolidScene& now) {
  return extension_of(was, was_fixed, Written{now.text, now.fixed_sha256, now.path, now.lines});
}

std::vector<base::Issue> changed_files(const SolidScene& now, const std::map<std::string, std::string>& were) {
  std::vector<base::Issue> issues;
  for (const auto& [file, sha256] : now.file_sha256)
    if (const auto was = were.find(file); was != were.end() && was->second != sha256)
      issues.push_back(
          {key_of_file(now, file), quoted(file), "its content differs from that in the run to be resumed"});
  return issues;
}

}  // namespace reye::scene
