#include "cad/kernel.hpp"

#include <dlfcn.h>

#include <stdexcept>

namespace reye::cad {

const Kernel& kernel() {
  static const Kernel* const loaded = [] {
    // Looked for where the program's own libraries are.
    void* const library = dlopen("libreye_gmsh.so", RTLD_LAZY | RTLD_LOCAL);
    const void* const found = library ? dlsym(library, "reye_kernel") : nullptr;
    if (!found) throw std::runtime_error(std::string("gmsh cannot be loaded: ") + dlerror());
    return static_cast<const Kernel*>(found);
  }();
  return *loaded;
}

void fill(Region& region, const SizeField& size) { kernel().fill(region, size); }

}  // namespace reye::cad
