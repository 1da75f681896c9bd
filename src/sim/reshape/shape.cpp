#include "sim/reshape/shape.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>

#include "adapt/shape/shape_step.hpp"
#include "base/errors.hpp"
#include "base/formatted.hpp"
#include "sim/measure/drawn_gap.hpp"
#include "sim/measure/shared_wear.hpp"
#include "sim/measure/sides.hpp"
#include "sim/measure/warn_contact.hpp"
#include "sim/measure/why_failed.hpp"
#include "sim/measure/worn_through.hpp"
#include "sim/problem/scene_line.hpp"
#include "sim/problem/timer.hpp"
#include "sim/reshape/balance.hpp"
#include "sim/reshape/gap.hpp"
#include "sim/reshape/stay_in_gaps.hpp"

namespace reye::sim {

namespace {

/// Adds removed volumes to those of the same boundary, and to the total.
void add_volumes(std::span<const double> volumes, std::vector<double>& sum, double& total) {
  sum.resize(volumes.size(), 0.0);
  for (std::size_t i = 0; i < volumes.size(); ++i) {
    sum[i] += volumes[i];
    total += volumes[i];
  }
}

/// Removed volumes per boundary of one body; several contacts may wear the same boundary.
std::vector<adapt::WornBoundary> worn_boundaries(const Problem& problem, const State& state, int body, double& total) {
  std::map<std::string, std::vector<double>> sums;
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const auto& placed = problem.contacts[c];
    const auto& contact = state.solution.contacts[c];
    if (placed.secondary.body == body) add_volumes(contact.pending_secondary, sums[placed.secondary.boundary], total);
    std::span<const double> rest(contact.pending_primary);
    for (const auto& ref : placed.primary) {
      const auto count = side_nodes(state.shapes, ref).size();
      if (ref.body == body) add_volumes(rest.first(count), sums[ref.boundary], total);
      rest = rest.subspan(count);
    }
  }
  std::vector<adapt::WornBoundary> worn;
  for (auto& [name, removed] : sums) worn.push_back({name, std::move(removed)});
  return worn;
}

/// Enters the strip in the ledger, share by share, once the body has lost the volume that waited in the gap.
void book_strips(const Problem& problem, State& state, const std::vector<double>& ratio) {
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const auto& placed = problem.contacts[c];
    auto& contact = state.solution.contacts[c];
    for (double& v : contact.pending_secondary) {
      contact.strip_secondary += v * ratio[placed.secondary.body];
      v = 0.0;
    }
    std::size_t l = 0;
    for (const auto& ref : placed.primary)
      for (std::size_t k = side_nodes(state.shapes, ref).size(); k > 0; --k, ++l) {
        contact.strip_primary += contact.pending_primary[l] * ratio[ref.body];
        contact.pending_primary[l] = 0.0;
      }
  }
}

double relative(double now, double before) { return before != 0.0 ? std::abs(now - before) / std::abs(before) : 0.0; }

/// Moves the outlines of all worn bodies by the volume that waited in the gap; `ratio`: strip over waiting volume.
std::string move_outlines(const Problem& problem, const State& state, Cache& cache, std::vector<Moved>& moved,
                          std::vector<double>& ratio) {
  Timer timer(cache, "adapt");
  for (int b = 0; b < problem.body_count(); ++b) {
    moved.push_back({state.shapes[b], {}});
    double total = 0.0;
    const auto worn = worn_boundaries(problem, state, b, total);
    if (total <= 0.0) continue;
    auto step = adapt::evolve(state.shapes[b], problem.scene.analysis, worn, {}, &cache.relocation);
    if (!step.failure.empty()) return "body " + problem.inputs[b].name + ": " + step.failure;
    ratio[b] = step.removed / total;
    moved[b] = {std::move(step.shape), std::move(step.poor)};
    if (!moved[b].poor.empty() && !problem.scene.remesh.automatic)
      return "body " + problem.inputs[b].name + ": " + moved[b].poor;
  }
  return {};
}

/// Bodies that would be too thin to be meshed.
std::string too_thin(const Problem& problem, const State& state, const std::vector<Moved>& moved) {
  std::vector<body::ShapePtr> shapes;
  for (const auto& body : moved) shapes.push_back(body.shape);
  const auto place = shapes == state.shapes ? std::nullopt : thinnest(problem, shapes);
  return place && place->share_left() < thinnest_share ? in_words(problem, *place, state.cycle) : std::string();
}

/// The state before the block, in the parts that the search for a cause reads.
State without_block(State state, const BlockSpan& span) {
  if (span.cycles) state.cycle -= span.jump;
  return state;
}

void tell(const Observer& observer, const std::vector<RemeshRecord>& records) {
  for (const auto& r : records) {
    if (observer.remesh) observer.remesh(r);
    if (!observer.log) continue;
    const std::string text = base::formatted(
        "body %s remeshed at cycle %g: %d -> %d nodes, poorest scaled Jacobian %.3f -> %.3f; pressure changed by "
        "%.2g, force by %.2g, strain energy by %.2g; a node lay %.2g mm outside; %.2f s, of which %.2f s meshing; ",
        r.body.c_str(), r.cycle, r.nodes_before, r.nodes_after, r.scaled_jacobian_before, r.scaled_jacobian_after,
        r.pressure_jump, r.force_jump, r.energy_jump, r.projection_mm, r.seconds, r.mesh_seconds);
    observer.log(text + r.reason);
  }
}

/// Fills in the jumps from the equilibrium before to the new one.
void fill_jumps(const Problem& problem, const State& next, const solver::System& system, const Balance& before,
                const std::vector<HeldTraction>& held, std::vector<RemeshRecord>& records) {
  const Balance now = balance_of(problem, next, system);
  for (auto& r : records) {
    int body = 0;
    while (problem.inputs[body].name != r.body) ++body;
    r.energy_jump = relative(now.energy[body], before.energy[body]);
    for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
      if (!lies_on(problem.contacts[c], body)) continue;
      r.pressure_jump =
          std::max(r.pressure_jump, pressure_jump(system.contacts[c], next.solution.contacts[c], held[c]));
      r.peak_jump = std::max(r.peak_jump, peak_jump(system.contacts[c], next.solution.contacts[c], held[c]));
      if (before.force[c].norm() > 0.0)
        r.force_jump = std::max(r.force_jump, (now.force[c] - before.force[c]).norm() / before.force[c].norm());
    }
  }
}

/// The state as it is, where its shapes cannot be moved.
Outcome unshaped(const Problem& problem, const State& state, Cache& cache, const BlockSpan& span,
                 const Observer& observer, const std::string& failure) {
  if (observer.log) observer.log("no shape: " + failure);
  const auto kept = timed_system(problem, state, cache);
  const auto& present = *kept;
  const Attempt attempt{span.step, span.jump, solver::Failure::none, failure};
  return {state,
          scene_line(problem.scene, "step " + span.step->name) +
              why_failed(problem, without_block(state, span), attempt, present),
          false};
}

bool asks(const RemeshReason& reason) { return !reason.text.empty(); }

bool any_asks(const std::vector<RemeshReason>& reasons) { return std::any_of(reasons.begin(), reasons.end(), asks); }

/// The moved shapes, with the wear of the block in the ledger; `ratio`: strip over waiting volume.
State worn_state(const Problem& problem, const State& state, const std::vector<Moved>& moved,
                 const std::vector<double>& ratio) {
  State next = state;
  for (std::size_t b = 0; b < moved.size(); ++b) next.shapes[b] = moved[b].shape;
  note_others(problem, next);
  book_strips(problem, next, ratio);
  return next;
}

/// `settle` after a shape step; a body that is worn through, or cannot be meshed, leaves the state as it is.
Outcome settle_worn(const Problem& problem, const State& state, Change change, Cache& cache, const BlockSpan& span,
                    const Observer& observer) {
  try {
    Outcome outcome = settle(problem, state, std::move(change), cache, span, observer);
    if (outcome.failure.empty() || worn_through(problem, without_block(state, span)).empty()) return outcome;
    return unshaped(problem, state, cache, span, observer, outcome.failure);
  } catch (const base::MeshError& error) {
    return unshaped(problem, state, cache, span, observer, error.what());
  }
}

}  // namespace

Outcome evolve_shape(const Problem& problem, State state, Cache& cache, const BlockSpan& span, const Observer& observer,
                     const std::vector<RemeshReason>& asked) {
  // Nothing here holds the system: the factors of old shapes are released before new ones are made.
  const auto system = [&] { return timed_system(problem, state, cache); };
  std::vector<double> ratio(state.shapes.size(), 1.0);
  std::vector<Moved> moved;
  std::string failure = move_outlines(problem, state, cache, moved, ratio);
  if (failure.empty()) failure = too_thin(problem, state, moved);
  if (!failure.empty()) return unshaped(problem, state, cache, span, observer, failure);
  std::vector<RemeshReason> reasons(moved.size());
  if (span.remesh || span.extrapolated) reasons = remesh_reasons(problem, state, *system(), moved);
  const bool put_off = !span.remesh && any_asks(reasons);
  if (!span.remesh) reasons.assign(moved.size(), {});
  for (std::size_t b = 0; b < asked.size(); ++b)
    if (asks(asked[b])) reasons[b] = asked[b];
  Change change{worn_state(problem, state, moved, ratio), std::move(reasons), held_tractions(*system(), state)};
  Outcome outcome = settle_worn(problem, state, std::move(change), cache, span, observer);
  outcome.remesh_due = put_off;
  return outcome;
}

Outcome wear_down(const Problem& problem, State state, Cache& cache, const BlockSpan& span, const Observer& observer) {
  if (!may_stay_in_gaps(problem, state, *timed_system(problem, state, cache), span))
    return evolve_shape(problem, std::move(state), cache, span, observer);
  if (!span.extrapolated) return {std::move(state), {}, false};
  State next = state;
  const auto held = held_tractions(*timed_system(problem, state, cache), state);
  const std::string failure = re_equilibrate(problem, next, cache, span, held);
  return failure.empty() ? Outcome{std::move(next), {}, false} : Outcome{std::move(state), failure, false};
}

State worn_by_what_waits(const Problem& problem, const State& state, Cache& cache, const scene::Step& step) {
  if (!problem.scene.shape || !wear_waits(state)) return state;
  BlockSpan span;
  span.step = &step;
  span.remesh = false;
  try {
    return evolve_shape(problem, state, cache, span, {}).state;  // a failure leaves the state as it is
  } catch (const base::SolveError&) {
    return state;
  } catch (const base::MeshError&) {
    return state;
  }
}

Outcome settle(const Problem& problem, State state, Change change, Cache& cache, const BlockSpan& span,
               const Observer& observer) {
  const auto start = std::chrono::steady_clock::now();
  auto& next = change.next;
  std::vector<RemeshRecord> records;
  Balance before;
  if (any_asks(change.reasons)) {
    before = balance_of(problem, state, *timed_system(problem, state, cache));
    const std::string failure = remesh_bodies(problem, state, change, cache, records);
    if (!failure.empty()) return {std::move(state), failure, false};
    next.recall = {};
    next.last_wear = {};  // it is of other nodes
  }
  if (next.shapes == state.shapes) return {std::move(state), {}, false};
  next.shown = false;
  for (std::size_t b = 0; b < next.shapes.size(); ++b) next.counts.factorisations += next.shapes[b] != state.shapes[b];
  CarriedGap gap;
  const std::string failure = span.extrapolated ? re_equilibrate(problem, next, cache, span, change.held)
                                                : equilibrate_with_gap(problem, next, cache, span, change.held, gap);
  if (!failure.empty()) return {std::move(state), failure, false};
  if (!gap.failure.empty() && observer.log) observer.log("the gap is not carried over the remesh: " + gap.failure);
  if (!records.empty()) {
    fill_jumps(problem, next, *system_of(problem, next, cache), before, change.held, records);
    for (auto& r : records) {
      r.step = span.step->name;
      r.gap_moved_mm = gap.moved_mm;
      r.gap_left_mm = gap.left_mm;
      r.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
    tell(observer, records);
    for (const auto& r : records) warn_of_remesh(next, observer, r);
  }
  return {std::move(next), {}, false};
}

}  // namespace reye::sim
