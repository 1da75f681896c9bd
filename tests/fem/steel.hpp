#pragma once
#include "material/parameters.hpp"
#include "material/stress.hpp"

/// The elastic solid of tests at small strain.
namespace reye::fem_tests {

struct Steel {
  static constexpr double E = 1000.0, nu = 0.3;  ///< E in MPa
  static constexpr double mu = E / (2 * (1 + nu)), lambda = E * nu / ((1 + nu) * (1 - 2 * nu));
};

inline const material::Material steel = material::LinearElastic{Steel::E, Steel::nu};

}  // namespace reye::fem_tests
