#include "cad/part/beside.hpp"

#include <filesystem>

namespace reye::cad {

std::string beside_program(const std::string& name) {
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
  return (program.parent_path() / name).lexically_normal().string();
}

}  // namespace reye::cad
