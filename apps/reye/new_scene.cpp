#include "new_scene.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "base/errors.hpp"
#include "base/printable.hpp"
#include "cad/part/beside.hpp"
#include "output/folder/files.hpp"
#include "scene/nearest.hpp"

namespace reye::apps {

namespace fs = std::filesystem;

namespace {

/// The folder of the kinds, beside the program: where it is installed, and in its build, where it is a link.
fs::path kinds_folder() { return cad::beside_program("../share/reye/geo/like"); }

/// The first line of a scene, which is a comment of what it is.
std::string first_comment(const fs::path& scene) {
  const std::string text = output::read_text(scene.string());
  return text.starts_with("# ") ? text.substr(2, text.find('\n') - 2) : "";
}

/// What each kind is, by its name.
std::map<std::string, std::string> kinds() {
  std::map<std::string, std::string> all;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(kinds_folder(), error))
    if (const auto scene = entry.path() / "scene.toml"; fs::is_regular_file(scene))
      all[entry.path().filename().string()] = first_comment(scene);
  if (all.empty()) throw std::runtime_error("there are no scenes to start from in " + kinds_folder().string());
  return all;
}

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '.';
}

void check_name(const std::string& name, std::vector<base::Issue>& issues) {
  const bool plain = !name.empty() && std::all_of(name.begin(), name.end(), is_plain);
  if (name.empty())
    issues.push_back({"NAME", "", "name your part: reye new NAME --like KIND"});
  else if (!plain || name.front() == '.' || name.front() == '-')
    issues.push_back({"NAME", name,
                      "a name has letters a to z, digits, '_', '-' and '.', and begins with a letter, a digit or '_'; "
                      "another folder than ./NAME is given by --out"});
}

void check_kind(const std::string& like, std::vector<base::Issue>& issues) {
  std::vector<std::string> names;
  for (const auto& [name, what] : kinds()) names.push_back(name);
  if (like.empty())
    issues.push_back({"--like", "", "name the kind of contact; reye new --list shows them"});
  else if (std::find(names.begin(), names.end(), like) == names.end())
    issues.push_back({"--like", like, scene::unknown_name_rule("kind", like, names)});
}

void check_folder(const fs::path& folder, std::vector<base::Issue>& issues) {
  std::error_code error;
  const auto parent = fs::absolute(folder).parent_path();
  if (fs::exists(fs::symlink_status(folder, error)))
    issues.push_back({"--out", folder.string(), "it exists already, and nothing is replaced; choose another folder"});
  else if (!fs::is_directory(parent, error) || ::access(parent.c_str(), W_OK | X_OK) != 0)
    issues.push_back({"--out", folder.string(), "it cannot be made in " + parent.string()});
}

/// The scene with the name before its headline.
std::string titled(std::string text, const std::string& name) {
  const auto key = text.find("\ntitle");
  const auto quote = text.find('"', key);
  if (key == std::string::npos || quote == std::string::npos)
    throw std::logic_error("a scene to start from has a title");
  return text.insert(quote + 1, name + ": ");
}

/// The files of a kind in a folder that is made whole under another name first: a kill leaves no half of it.
void copy_kind(const fs::path& from, const fs::path& to, const std::string& name) {
  const fs::path unfinished = to.string() + '.' + std::to_string(::getpid()) + ".tmp";
  try {
    output::make_folder(unfinished.string());
    for (const auto& entry : fs::directory_iterator(from)) {
      const auto file = entry.path().filename();
      const std::string text = output::read_text(entry.path().string());
      output::atomic_write((unfinished / file).string(), file == "scene.toml" ? titled(text, name) : text);
    }
    fs::rename(unfinished, to);
  } catch (...) {
    std::error_code ignored;
    fs::remove_all(unfinished, ignored);
    throw;
  }
}

int list_kinds() {
  for (const auto& [name, what] : kinds()) std::printf("%-14s %s\n", name.c_str(), what.c_str());
  return 0;
}

}  // namespace

int new_scene(const NewRequest& request) {
  if (request.list) return list_kinds();
  std::vector<base::Issue> issues;
  check_name(request.name, issues);
  check_kind(request.like, issues);
  fs::path folder = fs::path(request.out.empty() ? request.name : request.out).lexically_normal();
  if (!folder.has_filename()) folder = folder.parent_path();
  if (!folder.empty()) check_folder(folder, issues);
  if (!issues.empty()) throw base::InputError(std::move(issues));
  copy_kind(kinds_folder() / request.like, folder, request.name);
  const std::string scene = base::printable((folder / "scene.toml").string());
  std::printf("%s\n\nnext:\n", base::printable(folder.string()).c_str());
  std::printf("  reye check %s --picture %s   reads it and draws it\n", scene.c_str(),
              base::printable((folder / "scene.svg").string()).c_str());
  std::printf("  reye run %s   computes it, in less than a minute as it is\n", scene.c_str());
  std::printf("Its comments give meaning and unit of each line; change them step by step to your own part.\n");
  return 0;
}

}  // namespace reye::apps
