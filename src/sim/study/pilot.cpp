#include "sim/study/pilot.hpp"

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "base/formatted.hpp"

namespace reye::sim {

namespace {

constexpr double pilot_reach =
    4.0;  ///< times the elements of a pilot, up to which the order of its error is extrapolated
/// The share of the accuracy that the error of the mesh may take by the estimate: the cycle jump has half of it, and
/// the true error may be 1.8 times as large as the estimate (`results/mesh_error`).
constexpr double share = 0.4;

[[noreturn]] void refuse(double accuracy, const std::string& rule) {
  throw base::InputError({{"accuracy", base::formatted("%g", accuracy), rule + "; give the fine zones their size_mm"}});
}

/// Whether the elements that a pilot asks for are near enough to its own, or too many in any case.
bool reaches(const PilotRule& rule, const Pilot& pilot) {
  const bool hopeless = pilot.suited > 2.0 * rule.most;
  return pilot.elements > 0.0 && (hopeless || pilot.suited <= pilot_reach * pilot.elements);
}

}  // namespace

Pilot piloted(const PilotRule& rule, double accuracy, const std::function<DiscretisationError(double)>& played) {
  Pilot best;
  std::string reason;
  for (double n = rule.first; n <= rule.last && !reaches(rule, best); n *= 2.0) {
    const DiscretisationError error = played(n);
    reason = error.reason;
    if (!error.surface) continue;
    const double finer = std::pow(*error.surface / (share * accuracy), 1.0 / error.order);
    best = {n, error, n * std::max(1.0, finer)};
  }
  if (best.elements > 0.0) return best;
  refuse(accuracy, base::formatted("a pilot run on %g elements per %s of the fine zones gives no error estimate: ",
                                   rule.last, rule.extent) +
                       reason);
}

std::vector<std::string> decided(const PilotRule& rule, double accuracy, const Pilot& pilot, const std::string& sizes,
                                 double seconds) {
  const auto told =
      base::formatted(
          "with %g elements per %s of the fine zones the estimated error is %.2g %% and falls with size^%g; ",
          pilot.elements, rule.extent, 100.0 * *pilot.error.surface, pilot.error.order) +
      base::formatted("%.0f elements suit the accuracy: ", pilot.suited) + sizes;
  if (pilot.suited > rule.most) refuse(accuracy, told + base::formatted("; more than %g are not chosen", rule.most));
  return {base::formatted("accuracy %g %%: ", 100.0 * accuracy) + told,
          base::formatted("    the pilot run took %.2g s of processor time; it is repeated at each restart", seconds)};
}

}  // namespace reye::sim
