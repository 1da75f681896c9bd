#include "solver/newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/errors.hpp"
#include "body/turning.hpp"
#include "solver/chord_rule.hpp"

namespace reye::solver {

using body::Tangent;

using contact::Start;

namespace {

constexpr int all_at_once = 5;           ///< iterations in which nodes open and close together
constexpr int few_changes = 4;           ///< changes of status in an iteration of an active set that is nearly settled
constexpr int marching = 10;             ///< iterations in a row with so few changes: a moving edge of contact
constexpr double worse = 1.5;            ///< growth of the imbalance at which a start does not fit,
constexpr double far_out = 0.01;         ///< where it exceeds this share of the forces
constexpr int settling = 5;              ///< iterations that follow the last change
constexpr int symmetric_ones = 5;        ///< tangents of an increment that are symmetric parts; later ones are exact
constexpr int most_on_one_tangent = 15;  ///< iterations of contact before nonlinear bodies are linearised again

/// The mean length of a facet of a contact's surfaces.
double facet_length(const contact::Setup& setup) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const auto* surface : {&setup.secondary, &setup.primary}) {
    for (const auto& facet : surface->facets) sum += (surface->X[facet[1]] - surface->X[facet[0]]).norm();
    count += surface->facets.size();
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

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
    const double way = std::abs(imposed->second - before.q[column]) * 0.5 * system.extent;
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

/// One attempt at an increment: its start, and whether tangents are kept and symmetric while that is worth it.
struct Attempt {
  Start from;
  bool chords;
};

bool nonlinear(const System& system) {
  return std::any_of(system.bodies.begin(), system.bodies.end(),
                     [](const auto& b) { return std::holds_alternative<body::NonlinearBody>(b); });
}

}  // namespace

SolveResult Newton::iterate(const System& system, const SolverState& before, const Controls& controls,
                            contact::Start from, bool chords, bool narrowing) {
  SolveResult result;
  auto& report = result.report;
  base::TwoPart q;
  try {
    q = increment_.begin(system, before, controls, from, chords ? Tangent::symmetric_part : Tangent::exact);
  } catch (const base::SolveError& error) {
    report.reason = error.what();
    return result;
  }
  report.tangents = increment_.nonlinear() ? 1 : 0;
  /// The error as a multiple of the tolerances.
  const auto error_of = [&](const Iteration& row) {
    return std::max(row.force / options_.force_tolerance, row.condition / options_.condition_tolerance);
  };
  ActiveSetWatch watch;
  ChordRule rule, tangents;
  bool late = false, on_chord = false, keeps_tangent = false, on_tangent_kept = false;
  double least = std::numeric_limits<double>::infinity();  ///< force out of balance so far
  int renewals = 0, limit = most_on_one_tangent, last = options_.max_iterations, steps = 0;
  for (int iteration = 0, since = 0; iteration <= last; ++iteration, ++since) {
    const bool fresh =
        !increment_.nonlinear() || since == 0;  // the residual is that of the nonlinear body, not of its linearisation
    increment_.place(system, q);
    const bool one_by_one = watch.cycling();
    const int stage = late ? options_.max_iterations : iteration;
    const Allowed together = stage < all_at_once ? Allowed::all : Allowed::opening_first;
    const int changes = increment_.decide(stage, from, one_by_one ? Allowed::none : together);
    Iteration row = increment_.measure(system, controls, q, fresh);
    if (one_by_one && changes > 0 && error_of(row) < 1.0) {
      increment_.decide(stage, from, Allowed::one);
      row = increment_.measure(system, controls, q, fresh);
    }
    row.changes = changes;
    const auto set = increment_.active_set();
    watch.add(set);
    // An edge of contact may move by a node in each iteration, past all nodes.
    steps = changes > 0 && changes <= few_changes ? steps + 1 : 0;
    if (!increment_.nonlinear() && steps >= marching)
      last = std::max(last, std::min(iteration + settling, options_.max_iterations + static_cast<int>(set.size())));
    if (watch.cycling() && !one_by_one) limit = since + most_on_one_tangent;
    if (fresh) report.table.push_back(row);
    if (!std::isfinite(row.force) || !std::isfinite(row.condition)) {
      report.reason = "the residual is not finite after " + std::to_string(iteration) +
                      " iterations: displacements grow without bound, as when a body is unsupported";
      return result;
    }
    const double off = error_of(row);
    if (fresh && increment_.nonlinear()) {
      if (from == Start::predicted && row.force > std::max(worse * least, far_out)) {
        report.reason = "the predicted start leads away from equilibrium";
        return result;
      }
      least = std::min(least, row.force);
      keeps_tangent = tangents.allows(row.force, 0) && chords;
    }
    const bool renewed = since == 0 && renewals > 0;
    bool chord = chords && rule.allows(off, changes);
    if (renewed && keeps_tangent && changes == 0) chord = true;  // contact's matrix goes with the tangent
    // Newton's last step falls far below the tolerance; chord steps continue until it has, too.
    bool met = iteration > 0 && changes == 0 && off < ((on_chord && chord) || on_tangent_kept ? 1e-2 : 1.0);
    // Early decisions leave out the wear by neighbours, so that a node it opens would stay in tension. They are
    // repeated.
    if (met && !late &&
        increment_.decide(options_.max_iterations, from, one_by_one ? Allowed::one : Allowed::all) != 0) {
      met = chord = false;
      late = true;
      increment_.measure(system, controls, q, fresh);
    }
    if (met && fresh) {
      report.converged = true;
      if (increment_.accept(system, q, result.state)) {
        report.reason = increment_.passed_through();
        report.converged = report.reason.empty();
        return result;
      }
      narrowing = false;
      if (!increment_.follow(system, controls, q)) {
        increment_.choose_reach(system, before, true, options_.limit_reach);
        return iterate(system, before, controls, from, chords, false);
      }
      rule = {};
      report.converged = on_chord = false;
      continue;
    }
    // Contact has settled on the bodies as they were linearised: these are linearised again there.
    if (increment_.nonlinear() && (met || since == limit || watch.stuck())) {
      if (renewals++ == options_.max_iterations) break;
      report.reason = increment_.renew(q);
      if (!report.reason.empty()) return result;
      watch = {};
      rule = {};
      limit = most_on_one_tangent;
      iteration = 0;
      since = -1;
      continue;
    }
    if (iteration == last || watch.stuck()) break;
    if (renewed) {
      on_tangent_kept = keeps_tangent;
      if (!keeps_tangent) {
        ++report.tangents;
        const bool exact = !chords || report.tangents > symmetric_ones;
        report.reason = increment_.linearise(q, exact ? Tangent::exact : Tangent::symmetric_part);
        if (!report.reason.empty()) return result;
        increment_.measure(system, controls, q, fresh);
      }
    }
    const bool narrowed = narrowing && !chord && increment_.narrow(system, controls, q);
    if (narrowed) {
      increment_.place(system, q);
      increment_.measure(system, controls, q, fresh);
    }
    try {
      const Vector dq = increment_.step(system, controls, q, chord);
      on_chord = chord;
      ++report.solves;
      report.matrices += chord ? 0 : 1;
      q += dq;
      // Far away the rounding of S q hides that nothing is in balance.
      const double way = increment_.way(dq), bound = 1e3 * system.extent;
      if (!system.contacts.empty() && !(way < bound)) {
        report.reason = "a body moves by " + std::to_string(way) + " in one iteration: it is unsupported";
        return result;
      }
      if (narrowed && iteration == 0) {  // nodes that the first step closes are judged among all nodes
        increment_.widen(system, controls, q);
        rule = {};
      }
    } catch (const base::SolveError& error) {
      report.reason = error.what();
      if (!increment_.touching()) report.reason = "no node is in contact, and a body is unsupported";
      return result;
    }
  }
  report.reason = increment_.not_found(system, report.table, options_, watch.stuck());
  return result;
}

SolveResult Newton::solve(const System& system, const SolverState& before, const Controls& controls) {
  increment_.choose_reach(system, before, turns_beyond_reach(system, before, controls), options_.limit_reach);
  std::vector<Attempt> attempts;
  if (controls.guess || (controls.continues > 0.0 && increment_.follows(before)))
    attempts.push_back({Start::predicted, options_.chords});
  attempts.push_back({Start::sticking, options_.chords});
  // A body that is free to turn rolls about nodes that stick, by far more than it will once they slide: contact is then
  // lost. Such an increment starts with the former friction, which then yields.
  if (rubs(system, before, controls)) attempts.push_back({Start::sheared, options_.chords});
  // Far from the solution kept or symmetric tangents may diverge where Newton's own do not.
  if (options_.chords && nonlinear(system)) {
    if (attempts.front().from == Start::predicted) attempts.push_back({Start::predicted, false});
    attempts.push_back({Start::sticking, false});
  }
  SolveResult result;
  int solves = 0, matrices = 0, tangents = 0;
  for (const auto& [from, chords] : attempts) {
    // The previous start may have moved the reach away from contact.
    if (from == Start::sheared) increment_.choose_reach(system, before, true, options_.limit_reach);
    SolveResult found = iterate(system, before, controls, from, chords, options_.limit_reach);
    solves += found.report.solves;
    matrices += found.report.matrices;
    tangents += found.report.tangents;
    const bool converged = found.report.converged;
    if (converged || from != Start::sheared) result = std::move(found);  // a start that may not fit gives no reason
    if (converged) break;
  }
  result.report.solves = solves;
  result.report.matrices = matrices;
  result.report.tangents = tangents;
  if (result.report.converged) increment_.remember(before, result.state);
  return result;
}

}  // namespace reye::solver
