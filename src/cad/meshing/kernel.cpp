#include "cad/meshing/kernel.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "cad/part/beside.hpp"

namespace reye::cad {

namespace {

// Symbols of gmsh and its libraries are sought among these first: the loader takes half of the time that it takes
// behind those of the program. Sanitizers stand before everybody and refuse it.
#ifdef __SANITIZE_ADDRESS__
constexpr int mode = RTLD_LAZY | RTLD_LOCAL;
#else
constexpr int mode = RTLD_LAZY | RTLD_LOCAL | RTLD_DEEPBIND;
#endif

/// A path with so many slashes more that it is as long as those of other installations. The loader keeps it, and what
/// the libraries allocate while they are loaded lies behind it: gmsh and OpenCASCADE hash addresses, and the mesh of a
/// solid would depend on where Reye is installed. Paths of more than 800 bytes stay as they are.
std::string of_equal_length(std::string path) {
  constexpr std::size_t length = 800;
  return path.insert(path.rfind('/'), std::string(length - std::min(path.size(), length), '/'));
}

std::string with_single_slashes(std::string text) {
  text.erase(std::unique(text.begin(), text.end(), [](char a, char b) { return a == '/' && b == '/'; }), text.end());
  return text;
}

}  // namespace

const void* kernel_symbol(const char* name) {
  static void* const library = dlopen(of_equal_length(beside_program("../lib/reye/libreye_gmsh.so")).c_str(), mode);
  static const std::string reason = library ? "" : with_single_slashes(dlerror());  // the system says it once
  if (!library) throw std::runtime_error("gmsh cannot be loaded: " + reason);
  const void* const found = dlsym(library, name);
  if (!found) throw std::runtime_error(std::string("gmsh cannot be loaded: it lacks ") + name);
  return found;
}

const Kernel& kernel() {
  static const auto* const loaded = static_cast<const Kernel*>(kernel_symbol("reye_kernel"));
  return *loaded;
}

}  // namespace reye::cad
