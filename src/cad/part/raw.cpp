#include "cad/part/raw.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "base/errors.hpp"

namespace reye::cad {

std::string extension(const std::string& path) {
  std::string ext = std::filesystem::path(path).extension().string();
  std::transform(ext.begin(), ext.end(), ext.begin(), [](unsigned char c) { return std::tolower(c); });
  return ext;
}

bool needs_gmsh(const std::string& path) { return extension(path) != ".vtu"; }

void refuse(const std::string& path, const std::string& rule) {
  throw base::InputError({{"geometry", "\"" + path + "\"", rule}});
}

}  // namespace reye::cad
