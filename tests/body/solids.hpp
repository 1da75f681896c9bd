#pragma once
#include "material/parameters.hpp"

/// What bodies of finite strain are made of.
namespace reye::support {

inline const material::Material rubber = material::NeoHookean{300.0, 0.4, material::Volumetric::log_squared};
inline const material::Material metal = material::HenckyJ2{300.0, 0.3, material::LinearHardening{2.0, 30.0}};

}  // namespace reye::support
