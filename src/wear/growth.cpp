#include "wear/growth.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace reye::wear {

namespace {

/// The embedded pair of orders 5 and 4 by Dormand and Prince (J. Comput. Appl. Math. 6, 1980).
constexpr int stages = 7;
constexpr std::array<double, stages> at{0.0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1.0, 1.0};
constexpr std::array<std::array<double, stages - 1>, stages> from{
    {{},
     {1.0 / 5},
     {3.0 / 40, 9.0 / 40},
     {44.0 / 45, -56.0 / 15, 32.0 / 9},
     {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
     {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
     {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}}};
constexpr std::array<double, stages> error_weight{71.0 / 57600,      0.0,        -71.0 / 16695, 71.0 / 1920,
                                                  -17253.0 / 339200, 22.0 / 525, -1.0 / 40};

constexpr double tolerance = 1e-14;  ///< of the depth gained
constexpr double smallest = 1e-15;   ///< step, of the increment: less does not move its start
constexpr double shrinks_to = 0.1, grows_to = 5.0;

bool follows_way(const Formula& formula) { return formula.uses(Variable::path) || formula.uses(Variable::depth); }

/// One step from depth on, over [s, s + h] of the increment.
struct Step {
  double depth = 0.0, error = 0.0;
};

template <class Rate>
Step step(const Rate& rate, double s, double h, double depth) {
  std::array<double, stages> k{};
  Step result;
  double y = depth;
  for (int i = 0; i < stages; ++i) {
    y = depth;
    for (int j = 0; j < i; ++j) y += h * from[i][j] * k[j];
    k[i] = rate(s + at[i] * h, y);
    result.error += h * error_weight[i] * k[i];
  }
  result.depth = y;
  result.error = std::abs(result.error);
  return result;
}

template <class Rate>
double integrated(const Rate& rate) {
  double s = 0.0, h = 1.0, depth = 0.0;
  while (s < 1.0) {
    const Step next = step(rate, s, h, depth);
    const double allowed = tolerance * std::max(next.depth, h * rate(s, depth));
    if (next.error > allowed && h > smallest) {
      h *= std::max(shrinks_to, 0.9 * std::pow(allowed / next.error, 0.2));
      continue;
    }
    s += h;
    depth = next.depth;
    const double growth = next.error > 0.0 ? 0.9 * std::pow(allowed / next.error, 0.2) : grows_to;
    h = std::min(h * std::clamp(growth, shrinks_to, grows_to), 1.0 - s);
  }
  return depth;
}

/// d(f)/dx by a stencil of four points.
template <class F>
double slope_of(const F& f, double x) {
  const double h = 1e-3 * x;
  if (!(h > 0.0)) return 0.0;
  return (8.0 * (f(x + h) - f(x - h)) - (f(x + 2.0 * h) - f(x - 2.0 * h))) / (12.0 * h);
}

}  // namespace

double growth(const Formula& formula, double unit, const Place& start, const Way& way) {
  if (way.load == 0.0) return 0.0;
  if (!follows_way(formula)) return unit * formula.at(start) * way.load;
  return integrated([&](double s, double depth) {
    Place place = start;
    place.path += s * way.path;
    place.depth += depth;
    return unit * formula.at(place) * way.load;
  });
}

GrowthSlopes growth_slopes(const Formula& formula, double unit, const Place& start, const Way& way, double depth) {
  GrowthSlopes slopes;
  if (!follows_way(formula)) {
    slopes.load = unit * formula.at(start);
    slopes.pressure = unit * way.load * formula.slope(start, Variable::pressure);
    slopes.speed = unit * way.load * formula.slope(start, Variable::speed);
    return slopes;
  }
  const auto with = [&](Place place, Way along) { return growth(formula, unit, place, along); };
  const auto by = [&](Variable variable, double least) {
    Place there = start;
    if (!formula.uses(variable) || there.at(variable) <= least) return 0.0;
    return slope_of(
        [&](double x) {
          there.at(variable) = x;
          return with(there, way);
        },
        there.at(variable));
  };
  slopes.pressure = by(Variable::pressure, least_pressure_MPa);
  slopes.speed = by(Variable::speed, least_speed_mm_per_s);
  if (formula.uses(Variable::path)) {
    slopes.path = slope_of([&](double path) { return with(start, {way.load, path}); }, way.path);
    slopes.load = slope_of([&](double load) { return with(start, {load, way.path}); }, way.load);
  } else {
    Place end = start;
    end.depth += depth;
    slopes.load = unit * formula.at(end);
  }
  if (way.load == 0.0) slopes.load = unit * formula.at(start);
  return slopes;
}

}  // namespace reye::wear
