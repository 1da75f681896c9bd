#pragma once
#include <array>
#include <cmath>
#include <random>

#include "adapt/transfer/gauss_transfer.hpp"
#include "support/meshes.hpp"
#include "support/surfaces.hpp"

/// Fields and meshes for tests of transfers.
namespace reye::support {

inline constexpr std::array linear_kinds{CellKind::tri3, CellKind::quad4};
inline constexpr std::array transfer_ways{adapt::GaussTransfer::nearest, adapt::GaussTransfer::patch,
                                          adapt::GaussTransfer::l2};

inline Vec2 affine_field(const Vec2& x) { return {3.0 + 2.0 * x.x() - x.y(), -1.0 + 0.5 * x.x() + 4.0 * x.y()}; }
inline Vec2 smooth_field(const Vec2& x) {
  return {std::sin(3.0 * x.x()) * std::cos(2.0 * x.y()), std::exp(x.x() - x.y())};
}

/// A point of the unit square.
inline Vec2 anywhere(std::mt19937& random) { return {0.5 + 0.5 * noise(random), 0.5 + 0.5 * noise(random)}; }

}  // namespace reye::support
