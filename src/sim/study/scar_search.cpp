#include "sim/study/scar_search.hpp"

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "base/formatted.hpp"

namespace reye::sim {

namespace {

using scene::MeasuredScars;
using scene::ScarSide;

/// Runs beyond the least number, before the search gives up.
constexpr int most_corrections = 4;
/// The part of the measured cycles after which the coefficients of the scene are judged. Where the scars ask for more
/// than `too_small` times of them, or for less than `too_large`, the run is left for one with better ones: it would
/// take long, or have few blocks.
constexpr double first_look = 0.15, too_small = 1.3, too_large = 0.4;
/// A run is left before the first look, too, once it has played more than this part of what the scars ask for: its
/// blocks are then long for them.
constexpr double too_soon = 0.35;
/// How far beyond the fitted cycles a run is played, so that they lie between ends of blocks on either side.
constexpr double beyond = 1.06;
/// Change of the ratio of two coefficients below which a run with the former ratio serves.
constexpr double same_ratio = 0.03;
/// Distance of a value from the nearest run below which runs are not repeated: of its range, or of its half interval.
constexpr double same_share = 0.02, same_interval = 0.25;
/// First steps of the parameters that are varied.
constexpr double step_of_share = 0.25, step_of_factor = 0.2;

class Search {
 public:
  Search(const ScarScene& scene, std::vector<FreeKey> free, const CalibrationWatch& watch, Calibration& result)
      : scene_(scene), watch_(watch), result_(result), measured_(result.measured) {
    parameters_.keys = std::move(free);
    parameters_.scales = result_.scales = scene.no_scaling.empty();
    choose_factors();
    check();
  }

  void go() {
    Vector theta = start();
    if (!play_first(theta)) return;
    for (int correction = 0;; ++correction) {
      const auto series = series_of(measured_, runs_.back().run);
      result_.estimate = fit::estimate(series, scar_model(parameters_, measured_, runs_), parameters_.names(), theta);
      if (!result_.estimate.refused.empty()) {
        result_.failure = result_.estimate.refused;
        return;
      }
      theta = result_.estimate.theta;
      if (settled(theta)) break;
      if (correction == most_corrections) {
        result_.notes.push_back("The runs did not settle the values; the last estimate stands.");
        break;
      }
      say("the estimate has moved; another run with it");
      if (!play(within_bounds(theta))) return;
      drop_farthest(theta);
    }
    if (!result_.estimate.converged)
      result_.notes.push_back("The fit has not converged; its figures are not reliable.");
  }

 public:
  const ScarParameters& parameters() const { return parameters_; }

 private:
  std::size_t varied() const {
    return static_cast<std::size_t>(parameters_.varied(Vector::Zero(parameters_.count())).size());
  }

  /// Two factors where both sides of the only contact that wears were measured, one where something worn was, else
  /// none.
  void choose_factors() {
    int wearing = 0;
    for (const auto& contact : scene_.contacts) {
      if (!contact.wear.wears()) continue;
      ++wearing;
      const double sum = contact.wear.secondary + contact.wear.primary;
      parameters_.share = {contact.wear.secondary / sum, contact.wear.primary / sum};
    }
    bool seen[2] = {false, false};
    const auto see = [&](const scene::ScarPlace& of, bool worn) {
      most_cycles_ = std::max(most_cycles_, of.cycles);
      if (worn) seen[of.side == ScarSide::primary] = true;
    };
    for (const auto& scar : measured_.scars) see(scar.of, true);
    for (const auto& figure : measured_.figures) see(figure.of, figure.what != scene::ScarFigure::energy);
    parameters_.factors = !seen[0] && !seen[1] ? 0 : wearing == 1 && seen[0] && seen[1] ? 2 : 1;
    if (parameters_.factors != 1) return;
    auto& notes = result_.notes;
    if (wearing == 1 && parameters_.share[0] * parameters_.share[1] > 0.0)
      notes.push_back(std::string("Only the ") + (seen[0] ? "secondary" : "primary") +
                      " side was measured: both coefficients have one factor, and their ratio is that of the scene.");
    if (wearing > 1)
      notes.push_back(
          "Several contacts wear: all their coefficients have one factor, and their ratios are those of "
          "the scene.");
  }

  /// Whether the scene takes the bounds of free keys, and reaches the cycles of the measurements where it must.
  void check() {
    if (parameters_.count() == 0)
      throw base::InputError({{"--free", "",
                               "is missing: loops of friction say nothing of wear coefficients; name what they are to "
                               "give, as contact.NAME.friction=0.2:0.9"}});
    Vector theta = Vector::Zero(parameters_.count());
    for (const double bound : {0.0, 1.0}) {
      theta.tail(static_cast<Eigen::Index>(parameters_.keys.size())).setConstant(bound);
      scene_.check(values_at(theta));
    }
    if (!parameters_.scales && most_cycles_ > scene_.cycles)
      throw base::InputError({{"--measured", base::formatted("%g", most_cycles_),
                               "cycles are more than the scene has, and it cannot be extended: " + scene_.no_scaling}});
  }

  void say(const std::string& sentence) const {
    if (watch_.told) watch_.told(sentence);
  }

  KeyValues values_at(const Vector& theta) const {
    KeyValues values;
    for (std::size_t k = 0; k < parameters_.keys.size(); ++k)
      values.emplace_back(parameters_.keys[k].key, parameters_.value_of(theta, k));
    return values;
  }

  /// The scene's own values where they lie between the bounds.
  Vector start() const {
    Vector theta = Vector::Zero(parameters_.count());
    for (std::size_t k = 0; k < parameters_.keys.size(); ++k) {
      const auto& [key, low, high] = parameters_.keys[k];
      const double own = scene_.number_at(key).value_or(0.5 * (low + high));
      theta[parameters_.factors + static_cast<Eigen::Index>(k)] =
          own > low && own < high ? (own - low) / (high - low) : 0.5;
    }
    return theta;
  }

  Vector within_bounds(Vector theta) const {
    auto shares = theta.tail(static_cast<Eigen::Index>(parameters_.keys.size()));
    shares = shares.cwiseMax(0.0).cwiseMin(1.0);
    return theta;
  }

  /// The runs that a first estimate needs: one, and one more for each parameter that is varied.
  bool play_first(Vector& theta) {
    if (!play_scaled(theta)) return false;
    const auto first = parameters_.count() - static_cast<Eigen::Index>(varied());
    for (auto k = first; k < parameters_.count(); ++k) {
      Vector moved = theta;
      const bool share = k >= parameters_.factors;
      moved[k] += share ? (theta[k] < 0.5 ? step_of_share : -step_of_share) : step_of_factor;
      if (!play(moved)) return false;
    }
    return true;
  }

  /// The first run; where one run serves for all factors it is left when others are better, and played with those.
  bool play_scaled(Vector& theta) {
    if (!play(theta, true)) return false;
    if (!left_) return true;
    theta = quick_;
    say(base::formatted("the scars ask for about %.3g times the coefficients of the scene; repeated with those",
                        parameters_.total(parameters_.factors_of(theta))));
    runs_.clear();
    return play(theta);
  }

  bool play(const Vector& theta, bool may_leave = false) {
    PlayedScars played{theta, {}};
    quick_ = theta;
    left_ = false;
    double next_look = 0.0;
    const auto enough = [&](const ScarRun& now) {
      if (!parameters_.scales) return now.cycles >= most_cycles_;
      if (now.cycles < next_look) return false;
      const bool early = now.cycles < first_look * most_cycles_;
      if (early && !may_leave) return false;
      next_look = (early ? 1.5 : 1.04) * now.cycles;
      const double more = wanted(theta, now);
      if (early) return left_ = now.cycles >= too_soon * more * most_cycles_;
      if (now.cycles >= beyond * more * most_cycles_) return true;
      left_ = may_leave && now.cycles < 0.5 * most_cycles_ && (more > too_small || more < too_large);
      return left_;
    };
    played.run = scene_.play(values_at(theta), parameters_.factors_of(theta),
                             parameters_.scales ? 4.0 * most_cycles_ : 0.0, {enough, watch_.interrupted});
    ++result_.runs;
    result_.increments += played.run.counts.increments;
    result_.warnings = played.run.warnings;
    if (!played.run.failure.empty()) {
      result_.failure = "run " + std::to_string(result_.runs) + " failed: " + played.run.failure;
      return false;
    }
    runs_.push_back(std::move(played));
    return true;
  }

  /// How many times the cycles of a run the scars ask for, by what it has computed so far.
  double wanted(const Vector& theta, const ScarRun& now) {
    if (parameters_.factors == 0) return 1.0;
    ScarParameters factors = parameters_;
    factors.keys.clear();
    const std::vector<PlayedScars> run{{theta.head(factors.factors), now}};
    quick_.head(factors.factors) =
        fit::quick_theta(series_of(measured_, now), scar_model(factors, measured_, run), quick_.head(factors.factors));
    return parameters_.total(parameters_.factors_of(quick_)) / parameters_.total(parameters_.factors_of(theta));
  }

  /// Whether the last run was played near enough to the estimate, and for as long as it asks for.
  bool settled(const Vector& theta) const {
    const auto& last = runs_.back();
    const auto f = parameters_.factors_of(theta), had = parameters_.factors_of(last.theta);
    if (parameters_.scales) {
      const double ratio = std::log(f.secondary * had.primary / (f.primary * had.secondary));
      if (std::abs(ratio) > same_ratio) return false;
      if (most_cycles_ * parameters_.total(f) > last.run.cycles * parameters_.total(had)) return false;
    }
    const Vector moved = (parameters_.varied(within_bounds(theta)) - parameters_.varied(last.theta)).cwiseAbs();
    const Vector half = 0.5 * (parameters_.varied(result_.estimate.high) - parameters_.varied(result_.estimate.low));
    for (Eigen::Index k = 0; k < moved.size(); ++k)
      if (moved[k] > std::max(same_share, same_interval * half[k])) return false;
    return true;
  }

  /// Leaves as many runs as the model needs: all but the one farthest from the estimate.
  void drop_farthest(const Vector& theta) {
    const auto distance = [&](const PlayedScars& played) {
      return (parameters_.varied(theta) - parameters_.varied(played.theta)).norm();
    };
    const auto farthest = std::max_element(runs_.begin(), runs_.end() - 1,
                                           [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
    runs_.erase(farthest);
  }

  const ScarScene& scene_;
  const CalibrationWatch& watch_;
  Calibration& result_;
  const MeasuredScars& measured_;
  ScarParameters parameters_;
  double most_cycles_ = 0.0;
  std::vector<PlayedScars> runs_;
  Vector quick_;       ///< a guess while a run is played
  bool left_ = false;  ///< the last run was left because other coefficients are better
};

}  // namespace

ScarParameters search_scars(const ScarScene& scene, std::vector<FreeKey> free, const CalibrationWatch& watch,
                            Calibration& result) {
  Search search(scene, std::move(free), watch, result);
  search.go();
  return search.parameters();
}

}  // namespace reye::sim
