#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "base/linalg.hpp"

/// What was measured, and what is computed at its places.
namespace reye::fit {

using base::Matrix;
using base::Vec2;
using base::Vector;

/// Depths measured along a line (profile) or over a face (map), or one number.
struct Series {
  std::string name;      ///< of messages: "scar[0]", "figure[2]"
  std::vector<Vec2> at;  ///< places in the frame of the instrument [mm]; a profile has y = 0 and increasing x; one
                         ///< number has one place
  Vector value;          ///< [mm] (of a number its own unit)
  Vector scatter;        ///< standard deviation of each value, independent of each other; empty: not known, found from
                         ///< the residuals
  bool map = false;      ///< places fill a plane (two tilts, shift in two directions), else a line
  bool level = true;     ///< offset and tilt(s) of the instrument are unknown
  bool moved = true;     ///< where the instrument's origin lies is unknown
  Vec2 near{0.0, 0.0};   ///< shift about which it is sought, by up to 0.75 of the extent of the places
};

/// What is computed at the places of series s moved by `shift`, for parameters theta (logarithms of factors). Cheap,
/// piecewise smooth.
using Model = std::function<Vector(const Vector& theta, std::size_t s, const Vec2& shift)>;

}  // namespace reye::fit
