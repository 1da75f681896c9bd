#include "cad/meshing/kernel.hpp"

#include <dlfcn.h>

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

}  // namespace

const void* kernel_symbol(const char* name) {
  static void* const library = dlopen(beside_program("../lib/reye/libreye_gmsh.so").c_str(), mode);
  static const std::string reason = library ? "" : dlerror();  // the system says it once
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
