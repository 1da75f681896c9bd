#pragma once
#include "support/meshes.hpp"

/// Cook's membrane, on which plain quadrilaterals lock.
namespace reye::support {

inline mesh::Mesh cook_membrane(int n) {
  return mapped(rectangle({.nx = n, .ny = n}), [](const base::Vec2& p) {
    const double x = 48 * p.x(), low = 44 * p.x(), high = 44 + 16 * p.x();
    return base::Vec2{x, low + p.y() * (high - low)};
  });
}

}  // namespace reye::support
