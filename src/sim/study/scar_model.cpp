#include "sim/study/scar_model.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "algebra/decompose.hpp"

namespace reye::sim {

namespace {

using base::Matrix;
using scene::MeasuredScars;
using scene::ScarFigure;
using scene::ScarSide;

/// The part of one side in the sum of both coefficients, over the part it has in the scene.
double part_of(const ScarParameters& parameters, const WearFactors& f, ScarSide side) {
  return (side == ScarSide::primary ? f.primary : f.secondary) / parameters.total(f);
}

/// A scar, or a number, of one run with its factors replaced by those of theta.
Vector of_run(const ScarParameters& parameters, const MeasuredScars& measured, const PlayedScars& played,
              const Vector& theta, std::size_t s, const Vec2& shift) {
  const auto scars = measured.scars.size();
  const auto& of = s < scars ? measured.scars[s].of : measured.figures[s - scars].of;
  double cycles = of.cycles, part = 1.0;
  if (parameters.scales) {
    const auto wanted = parameters.factors_of(theta), had = parameters.factors_of(played.theta);
    cycles *= parameters.total(wanted) / parameters.total(had);
    const bool sided = s < scars || measured.figures[s - scars].what == ScarFigure::depth ||
                       measured.figures[s - scars].what == ScarFigure::area;
    if (sided) part = part_of(parameters, wanted, of.side) / part_of(parameters, had, of.side);
  }
  const Vec2 anywhere = Vec2::Zero();
  if (s >= scars) return part * played.run.families[s].at(cycles, std::span(&anywhere, 1));
  std::vector<Vec2> places = measured.scars[s].at;
  for (auto& place : places) place += shift;
  return part * played.run.families[s].at(cycles, places);
}

Vec2 middle_of(const std::vector<Vec2>& places) {
  Vec2 low = places.front(), high = low;
  for (const auto& place : places) {
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  return 0.5 * (low + high);
}

/// Weights of runs whose varied parameters have the wanted ones as their mean.
Vector weights(const ScarParameters& parameters, const std::vector<PlayedScars>& runs, const Vector& theta) {
  const auto n = static_cast<Eigen::Index>(runs.size());
  if (n == 1) return Vector::Ones(1);
  Matrix A = Matrix::Ones(n, n);
  Vector b = Vector::Ones(n);
  for (Eigen::Index i = 0; i < n; ++i)
    A.col(i).tail(n - 1) = parameters.varied(runs[static_cast<std::size_t>(i)].theta);
  b.tail(n - 1) = parameters.varied(theta);
  return algebra::least_squares(A, b);
}

}  // namespace

WearFactors ScarParameters::factors_of(const Vector& theta) const {
  const double first = factors > 0 ? std::exp(theta[0]) : 1.0;
  return {first, factors > 1 ? std::exp(theta[1]) : first};
}

double ScarParameters::value_of(const Vector& theta, std::size_t key) const {
  const double way = std::clamp(theta[factors + static_cast<Eigen::Index>(key)], 0.0, 1.0);
  return keys[key].low + way * (keys[key].high - keys[key].low);
}

std::vector<std::string> ScarParameters::names() const {
  std::vector<std::string> all;
  if (factors == 1) all = {"the common factor of the wear coefficients"};
  if (factors == 2) all = {"the coefficient of the secondary side", "the coefficient of the primary side"};
  for (const auto& key : keys) all.push_back(key.key);
  return all;
}

std::vector<fit::Series> series_of(const MeasuredScars& measured, const ScarRun& run) {
  std::vector<fit::Series> all;
  for (const auto& scar : measured.scars) {
    const bool moved = !scar.origin_known;
    const Vec2 near = moved ? Vec2(run.families[all.size()].middle() - middle_of(scar.at)) : Vec2(Vec2::Zero());
    all.push_back({.name = scar.of.key.empty() ? scar.file : scar.of.key,
                   .at = scar.at,
                   .value = scar.depth_mm,
                   .scatter = scar.scatter_mm,
                   .map = scar.axes.size() > 1,
                   .level = scar.level,
                   .moved = moved,
                   .near = near});
  }
  for (const auto& figure : measured.figures) {
    Vector scatter;
    if (figure.scatter > 0.0) scatter = Vector::Constant(1, figure.scatter * figure.value);
    all.push_back({.name = figure.of.key,
                   .at = {Vec2::Zero()},
                   .value = Vector::Constant(1, figure.value),
                   .scatter = scatter,
                   .map = false,
                   .level = false,
                   .moved = false,
                   .near = Vec2::Zero()});
  }
  return all;
}

fit::Model scar_model(const ScarParameters& parameters, const MeasuredScars& measured,
                      const std::vector<PlayedScars>& runs) {
  return [&](const Vector& theta, std::size_t s, const Vec2& shift) {
    const Vector w = weights(parameters, runs, theta);
    Vector sum = w[0] * of_run(parameters, measured, runs[0], theta, s, shift);
    for (Eigen::Index i = 1; i < w.size(); ++i)
      sum += w[i] * of_run(parameters, measured, runs[static_cast<std::size_t>(i)], theta, s, shift);
    return sum;
  };
}

}  // namespace reye::sim
