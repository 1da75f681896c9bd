#pragma once
#include <variant>

namespace reye::material {

/// Isotropic linear elasticity.
struct LinearElastic {
  double E_MPa = 0.0;
  double nu = 0.0;  ///< in (-1, 0.5)
};

using Material = std::variant<LinearElastic>;

}  // namespace reye::material
