#include "cad/solid/solid_kernel.hpp"

#include "cad/meshing/kernel.hpp"

namespace reye::cad {

const SolidKernel& solid_kernel() {
  static const auto* const found = static_cast<const SolidKernel*>(kernel_symbol("reye_solid_kernel"));
  return *found;
}

}  // namespace reye::cad
