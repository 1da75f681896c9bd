#pragma once
#include "material/parameters.hpp"

/// What the blocks and rings of patch tests are made of.
namespace reye::support {

struct Elastic {
  static constexpr double E = 1000.0, nu = 0.3;  ///< E in MPa
};

inline const material::NeoHookean rubber{Elastic::E, Elastic::nu, material::Volumetric::log_squared};

}  // namespace reye::support
