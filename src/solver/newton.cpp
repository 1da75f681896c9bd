#include "solver/newton.hpp"

#include <algorithm>
#include <cmath>

#include "body/turning.hpp"
#include "solver/newton_path.hpp"

namespace reye::solver {

using contact::Start;

namespace {

/// Whether a body is turned so far in one increment that contact moves to nodes out of reach.
bool turns_beyond_reach(const System& system, const SolverState& before, const Controls& controls) {
  constexpr double facets = 4.0;  // the reach has a margin of six
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const auto* linear = std::get_if<body::LinearBody>(&system.bodies[b]);
    if (!linear || !linear->turning()) continue;
    const int column = system.offset[b] + linear->turning()->angle;
    const auto imposed = std::find_if(controls.prescribed.begin(), controls.prescribed.end(),
                                      [&](const auto& p) { return p.first == column; });
    if (imposed == controls.prescribed.end()) continue;
    const double way = std::abs(imposed->second - before.q.high[column]) * 0.5 * system.extent;
    for (const auto& setup : system.contacts)
      if (way > facets * facet_length(setup)) return true;
  }
  return false;
}

/// Whether a loaded contact has friction that this increment has to decide.
bool rubs(const System& system, const SolverState& before, const Controls& controls) {
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const auto& options = system.contacts[c].options;
    const auto& status = before.contacts[c].status;
    if (options.friction > 0.0 && !options.imposed && !controls.contacts[c].held &&
        std::any_of(status.begin(), status.end(), [](auto s) { return s != contact::ContactStatus::inactive; }))
      return true;
  }
  return false;
}

bool nonlinear(const System& system) {
  return std::any_of(system.bodies.begin(), system.bodies.end(),
                     [](const auto& b) { return std::holds_alternative<body::NonlinearBody>(b); });
}

}  // namespace

SolveResult Newton::solve(const System& system, const SolverState& before, const Controls& controls) {
  increment_.choose_reach(system, before, controls, turns_beyond_reach(system, before, controls), options_.limit_reach);
  const Start predicted = nonlinear(system) && !controls.guess ? Start::continued : Start::predicted;
  std::vector<Attempt> attempts;
  if (controls.guess || (controls.continues > 0.0 && increment_.follows(before)))
    attempts.push_back({predicted, options_.chords});
  const bool ahead = !attempts.empty() && increment_.look_ahead(system, before, controls);
  attempts.push_back({Start::sticking, options_.chords});
  // A body that is free to turn rolls about nodes that stick, by far more than it will once they slide: contact is then
  // lost. Such an increment starts with the former friction, which then yields.
  if (rubs(system, before, controls)) attempts.push_back({Start::sheared, options_.chords});
  // Far from the solution kept or symmetric tangents may diverge where Newton's own do not.
  if (options_.chords && nonlinear(system)) {
    if (attempts.front().from == predicted) attempts.push_back({predicted, false});
    attempts.push_back({Start::sticking, false});
  }
  SolveResult result;
  int solves = 0, matrices = 0, compliant = 0, tangents = 0;
  for (std::size_t k = 0; k < attempts.size(); ++k) {
    const Attempt attempt = attempts[k];
    // The previous start, or the prediction that it came from, may have moved the reach away from contact.
    if (attempt.from == Start::sheared || (ahead && attempt.from == Start::sticking) || increment_.followed())
      increment_.choose_reach(system, before, controls, true, options_.limit_reach);
    SolveResult found =
        NewtonPath(increment_, options_, system, before, controls, attempt).follow(options_.limit_reach);
    solves += found.report.solves;
    matrices += found.report.matrices;
    compliant += found.report.compliant;
    tangents += found.report.tangents;
    const bool converged = found.report.converged;
    if (!converged && found.report.compliant > 0)
      attempts.insert(attempts.begin() + static_cast<std::ptrdiff_t>(k) + 1, {attempt.from, false});
    if (converged || attempt.from != Start::sheared)
      result = std::move(found);  // a start that may not fit gives no reason
    if (converged) break;
  }
  result.report.solves = solves;
  result.report.matrices = matrices;
  result.report.compliant = compliant;
  result.report.tangents = tangents;
  if (result.report.converged)
    increment_.remember(before, result.state);
  else if (increment_.followed())
    increment_.choose_reach(system, before, controls, true, options_.limit_reach);
  return result;
}

Newton::Newton() = default;
Newton::Newton(NewtonOptions options) : options_(options) {}
Newton::Newton(const Newton&) = default;
Newton::Newton(Newton&&) noexcept = default;
Newton& Newton::operator=(const Newton&) = default;
Newton& Newton::operator=(Newton&&) noexcept = default;
Newton::~Newton() = default;

void Newton::reset() { increment_.forget(); }

}  // namespace reye::solver
