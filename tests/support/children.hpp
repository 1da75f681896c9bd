#pragma once
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>

/// The processes that this one has started.
namespace reye::support {

/// Numbers of the processes whose parent is this one, from /proc/<number>/stat: "number (name) state parent ...".
inline std::set<pid_t> children() {
  std::set<pid_t> found;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string name = entry.path().filename();
    if (name.find_first_not_of("0123456789") != name.npos) continue;
    std::ifstream file(entry.path() / "stat");
    std::string line;
    std::getline(file, line);
    const auto after_name = line.rfind(") ");
    if (after_name == line.npos) continue;  // it has just ended
    if (std::stol(line.substr(after_name + 4)) == ::getpid()) found.insert(static_cast<pid_t>(std::stol(name)));
  }
  return found;
}

}  // namespace reye::support
