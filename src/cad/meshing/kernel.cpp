#include "cad/meshing/kernel.hpp"

#include <dlfcn.h>

#include <stdexcept>

#include "cad/part/beside.hpp"

namespace reye::cad {

const Kernel& kernel() {
  static const Kernel* const loaded = [] {
    void* const library = dlopen(beside_program("../lib/libreye_gmsh.so").c_str(), RTLD_LAZY | RTLD_LOCAL);
    const void* const found = library ? dlsym(library, "reye_kernel") : nullptr;
    if (!found) throw std::runtime_error(std::string("gmsh cannot be loaded: ") + dlerror());
    return static_cast<const Kernel*>(found);
  }();
  return *loaded;
}

void fill(Region& region, const SizeField& size) { kernel().fill(region, size); }

}  // namespace reye::cad
