#pragma once
#include <array>
#include <string>
#include <vector>

#include "fit/estimate.hpp"
#include "scene/scars.hpp"
#include "sim/study/scar_run.hpp"

/// Scars as a function of wear coefficients and of values of other keys, from a few runs.
namespace reye::sim {

/// A key besides the wear coefficients whose value is looked for, between two bounds.
struct FreeKey {
  std::string key;
  double low = 0.0, high = 1.0;
};

/// What the parameters of a fit stand for: logarithms of one common factor of all wear coefficients, or of the factors
/// of both sides of the only contact that wears, or of none; then values of keys, 0 at their lower bound and 1 at their
/// upper one.
struct ScarParameters {
  int factors = 1;
  /// Scars depend on coefficient x cycles alone, so that one run stands for all factors; else factors are varied as
  /// keys are.
  bool scales = true;
  std::array<double, 2> share{1.0, 0.0};  ///< of secondary and primary in the sum of both coefficients of the scene
  std::vector<FreeKey> keys;

  Eigen::Index count() const { return factors + static_cast<Eigen::Index>(keys.size()); }
  WearFactors factors_of(const Vector& theta) const;
  double value_of(const Vector& theta, std::size_t key) const;  ///< within its bounds
  /// What a run of its own is needed for: the parameters without those that scale.
  Vector varied(const Vector& theta) const { return theta.tail(count() - (scales ? factors : 0)); }
  /// The sum of both coefficients over that of the scene.
  double total(const WearFactors& f) const { return share[0] * f.secondary + share[1] * f.primary; }
  std::vector<std::string> names() const;
};

/// A run with the parameters that it was played with.
struct PlayedScars {
  Vector theta;
  ScarRun run;
};

/// The measurements as series of a fit, in the order of the families of a run. Where an instrument's origin is unknown
/// its places are sought with their middle about that of the computed scar.
std::vector<fit::Series> series_of(const scene::MeasuredScars& measured, const ScarRun& run);

/// Scars at parameters from one run: depths depend on the sum of both coefficients times the cycles, and either side
/// has its part of them. From n + 1 runs for n varied parameters they are interpolated linearly between these, by
/// weights w with sum w_i = 1 and sum w_i v_i = v. All arguments must outlive the model.
fit::Model scar_model(const ScarParameters& parameters, const scene::MeasuredScars& measured,
                      const std::vector<PlayedScars>& runs);

}  // namespace reye::sim
