#pragma once
#include <cmath>
#include <functional>
#include <numeric>

#include "verification/wear_scene.hpp"

/// Profiles of line contacts against closed forms.
namespace reye::verification {

inline double root(double x) { return x > 0.0 ? std::sqrt(x) : 0.0; }
inline double hertz(double x, double a, double p0) { return p0 * root(1.0 - x * x / (a * a)); }

/// geo/hertz and, with friction, geo/cattaneo_mindlin (references B1b, B2): mm and MPa.
struct Hertz {
  static constexpr double a = 0.0913360, p0 = 836.410, mu = 0.6;
};

/// geo/hertz_halfplane (references B1): a low load.
struct LowHertz {
  static constexpr double a = 0.2, p0 = 109.89011;
};

/// Node values about the pressure centroid.
struct Profile {
  std::vector<double> x, value;
};

inline Profile profile(const sim::SurfaceRecord& s, const std::vector<double>& values) {
  const double total = std::accumulate(s.pressure_MPa.begin(), s.pressure_MPa.end(), 0.0);
  const double middle = std::inner_product(s.x_mm.begin(), s.x_mm.end(), s.pressure_MPa.begin(), 0.0) / total;
  Profile p{s.x_mm, values};
  for (double& x : p.x) x -= middle;
  return p;
}

using Curve = std::function<double(double)>;

/// Root of the integral of (value - exact)^2 over |x| < bound, the values linear between the nodes.
inline double l2_error(const Profile& p, double bound, const Curve& exact) {
  constexpr int parts = 50;
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < p.x.size(); ++i) {
    if (std::abs(p.x[i]) > bound) continue;
    const double h = p.x[i + 1] - p.x[i];
    for (int k = 0; k < parts; ++k) {
      const double t = (k + 0.5) / parts;
      const double error = p.value[i] + t * (p.value[i + 1] - p.value[i]) - exact(p.x[i] + t * h);
      sum += error * error * h / parts;
    }
  }
  return std::sqrt(sum);
}

/// L2 of the pressure of geo/hertz_halfplane, over its norm.
inline double low_hertz_error(const Played& run) {
  constexpr double a = LowHertz::a, p0 = LowHertz::p0;
  const auto& side = run.surface(sim::Side::secondary);
  const auto error = l2_error(profile(side, side.pressure_MPa), 2.0 * a, [](double x) { return hertz(x, a, p0); });
  return error / (p0 * std::sqrt(4.0 * a / 3.0));
}

/// Largest |value - exact| at nodes with |x| < bound.
inline double largest_error(const Profile& p, double bound, const Curve& exact) {
  double worst_error = 0.0;
  for (std::size_t i = 0; i < p.x.size(); ++i)
    if (std::abs(p.x[i]) < bound) worst_error = std::max(worst_error, std::abs(p.value[i] - exact(p.x[i])));
  return worst_error;
}

/// The frames of a run, each step's last one under its name.
inline std::map<std::string, sim::Frame> frames_of(const std::string& text) {
  const auto problem = prepared(text);
  auto state = sim::initial_state(problem);
  std::map<std::string, sim::Frame> frames;
  sim::Observer watch;
  watch.frame = [&](const sim::Frame& f) { frames[f.step] = f; };
  const auto summary = sim::run(problem, state, watch);
  EXPECT_EQ(summary.status, sim::RunStatus::done) << summary.reason;
  return frames;
}

}  // namespace reye::verification
