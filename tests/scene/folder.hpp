#pragma once
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "support/temporary_folder.hpp"

/// Scenes written into a folder of their own, which the test works in: messages then say plain `scene.toml`.
namespace reye::test {

class Folder {
 public:
  Folder() : before_(std::filesystem::current_path()) { std::filesystem::current_path(path()); }
  ~Folder() { std::filesystem::current_path(before_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  static void write(const std::string& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }
  const std::filesystem::path& path() const { return folder_.path(); }

 private:
  support::TemporaryFolder folder_;
  std::filesystem::path before_;
};

/// The text with its first `from` replaced; both must be there.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error("not in the scene: " + from);
  return text.replace(at, from.size(), to);
}

}  // namespace reye::test
