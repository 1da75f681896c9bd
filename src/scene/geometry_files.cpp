#include "scene/geometry_files.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "scene/sha256.hpp"

namespace reye::scene {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view extensions[] = {".step", ".stp", ".iges", ".igs", ".brep", ".geo", ".msh", ".vtu"};

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// The rule that a file breaks; empty when it can be given to the geometry stage.
std::string broken_rule(const fs::path& file) {
  if (std::find(std::begin(extensions), std::end(extensions), lower(file.extension().string())) == std::end(extensions))
    return "not supported; use .step, .stp, .iges, .igs, .brep, .geo, .msh or .vtu";
  return unreadable_rule(file.string());
}

}  // namespace

std::string beside(const std::string& scene_path, const std::string& name) {
  return (fs::absolute(scene_path).parent_path() / name).lexically_normal().string();
}

std::string unreadable_rule(const std::string& file) {
  std::error_code error;
  const auto status = fs::status(file, error);
  if (!fs::exists(status)) return "no such file";
  if (!fs::is_regular_file(status)) return "is not a file";
  std::string bytes;
  if (!read_bytes(file, bytes)) return "cannot be read";
  return bytes.empty() ? "is empty" : "";
}

std::vector<std::string> geometry_files(const Entry& root, const std::string& path, Issues& issues) {
  const auto names = root.texts("geometry");
  if (root.empty_list("geometry")) issues.push_back({"geometry", "[]", "names no file"});
  std::vector<std::string> files;
  std::set<std::string> seen;
  for (const auto& name : names) {
    const auto file = beside(path, name);
    auto rule = broken_rule(file);
    if (rule.empty() && !seen.insert(file).second) rule = "is named twice";
    if (!rule.empty()) issues.push_back({"geometry", '"' + name + '"', rule});
    files.push_back(file);
  }
  return files;
}

bool read_bytes(const std::string& path, std::string& bytes) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return false;
  std::ostringstream all;
  all << file.rdbuf();
  bytes = std::move(all).str();
  return !file.bad();
}

std::string file_sha256(const std::string& path) {
  std::string bytes;
  read_bytes(path, bytes);
  return sha256(bytes);
}

std::string digest(const std::string& scene_text, const std::vector<std::string>& files) {
  auto all = std::to_string(scene_text.size()) + '\n' + scene_text;
  for (const auto& file : files) {
    std::string bytes;
    read_bytes(file, bytes);
    all += std::to_string(bytes.size()) + '\n' + bytes;
  }
  return sha256(all);
}

}  // namespace reye::scene
