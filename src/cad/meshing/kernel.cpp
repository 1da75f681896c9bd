#include "cad/meshing/kernel.hpp"

#include <dlfcn.h>

#include <stdexcept>
#include <string>

#include "cad/part/beside.hpp"

namespace reye::cad {

const void* kernel_symbol(const char* name) {
  static void* const library = dlopen(beside_program("../lib/reye/libreye_gmsh.so").c_str(), RTLD_LAZY | RTLD_LOCAL);
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

void fill(Region& region, const SizeField& size) { kernel().fill(region, size); }

}  // namespace reye::cad
