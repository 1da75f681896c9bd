#pragma once
#include <vector>

#include "fit/series.hpp"

/// Neighbouring values of a series, averaged.
namespace reye::fit {

/// Blocks of a series: README (3). Without averaging every value is a block of its own.
struct Blocks {
  std::vector<Vec2> at;  ///< mean places [mm]
  std::vector<int> of;   ///< block of each value; empty: as many blocks as values
  Vector count;          ///< values of each block

  /// Means over the blocks of columns with a row per value.
  Matrix averaged(const Matrix& values) const;
};

/// As many blocks as have a use: of a line at most 256 stretches of it, of a map at most 18 x 18 cells. Series with
/// given scatter are white: each value stays.
Blocks blocks_of(const Series& series);

/// Largest minus smallest coordinates of the places [mm].
Vec2 extent_of(const std::vector<Vec2>& at);

}  // namespace reye::fit
