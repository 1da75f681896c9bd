#pragma once
#include "base/dual.hpp"
#include "wear/formula.hpp"

/// Growth of a depth whose coefficient is a formula.
namespace reye::wear {

/// The way of a node through one increment, all of its cycles together.
struct Way {
  double load = 0.0;  ///< the law's work per area [mJ/mm^2, MPa mm, mm]
  double path = 0.0;  ///< of slip [mm]
};

/// d(depth) by what the increment does.
struct GrowthSlopes {
  double pressure = 0.0, speed = 0.0, load = 0.0, path = 0.0;
};

/// The depth that an increment adds:  d depth = unit x formula(pressure, speed, path, depth, cycle) d load,
/// where path and depth start at `start` and path grows in proportion to the load. It is integrated by steps of fifth
/// order, to 1e-13 of the depth: where the formula jumps, as a coating is worn through, the steps close in on the jump.
double growth(const Formula& formula, double unit, const Place& start, const Way& way);

/// Its derivatives: exact in the load where the formula does not depend on the path, otherwise by stencils of four
/// points.
GrowthSlopes growth_slopes(const Formula& formula, double unit, const Place& start, const Way& way, double depth);

/// The growth for any scalar.
template <class T>
T growth(const Formula& formula, double unit, Place start, const T& pressure, const T& speed, const T& load,
         const T& path) {
  using base::value;
  start.pressure = value(pressure);
  start.speed = value(speed);
  const Way way{value(load), value(path)};
  T depth(growth(formula, unit, start, way));
  if constexpr (!std::is_same_v<T, double>) {
    const auto slope = growth_slopes(formula, unit, start, way, depth.v);
    depth += slope.pressure * (pressure - value(pressure)) + slope.speed * (speed - value(speed)) +
             slope.load * (load - value(load)) + slope.path * (path - value(path));
  }
  return depth;
}

/// A formula of pressure and speed at a place, for any scalar.
template <class T>
T value_of(const Formula& formula, Place place, const T& pressure, const T& speed) {
  using base::value;
  place.pressure = value(pressure);
  place.speed = value(speed);
  T result(formula.at(place));
  if constexpr (!std::is_same_v<T, double>)
    result += formula.slope(place, Variable::pressure) * (pressure - value(pressure)) +
              formula.slope(place, Variable::speed) * (speed - value(speed));
  return result;
}

}  // namespace reye::wear
