#include "sim/reshape/gap.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "adapt/shape/shift_outline.hpp"
#include "sim/measure/sides.hpp"
#include "sim/problem/timer.hpp"
#include "sim/reshape/balance.hpp"
#include "sim/reshape/closing.hpp"

namespace reye::sim {

namespace {

using Values = std::vector<double>;

/// Whether the wear of a contact was in its gap when its pressures were found: explicit wear changes them after that.
bool keeps_pressure(const contact::ContactOptions& contact) { return contact.wear.wears() && contact.implicit_wear; }

double sum_of(const Values& v) { return std::accumulate(v.begin(), v.end(), 0.0); }

/// Subtracts the moves from the losses of the nodes; the body keeps its content, so that the sum of losses stays.
void take_off(const SideShift& side, const mortar::Surface& surface, Values& removed) {
  const double before = sum_of(removed);
  for (std::size_t k = 0; k < removed.size(); ++k)
    if (side.by[k] != 0.0) removed[k] = std::max(0.0, removed[k] - side.by[k] * surface.area[k]);
  if (const double after = sum_of(removed); after > 0.0)
    for (double& v : removed) v *= before / after;
}

/// The moves of all boundaries, by body.
using Shifts = std::vector<std::vector<adapt::OutlineShift>>;

void collect(const PlacedContact& placed, const State& state, const Closing& c, Shifts& shifts) {
  if (any_moved(c.secondary.by))
    shifts[placed.secondary.body].push_back({placed.secondary.boundary, c.secondary.by, c.secondary.free});
  if (!any_moved(c.primary.by)) return;
  std::ptrdiff_t first = 0;
  for (const auto& ref : placed.primary) {
    const auto count = static_cast<std::ptrdiff_t>(side_nodes(state.shapes, ref).size());
    const auto part = [&](const Values& v) { return Values(v.begin() + first, v.begin() + first + count); };
    shifts[ref.body].push_back({ref.boundary, part(c.primary.by), part(c.primary.free)});
    first += count;
  }
}

/// Adds the rounding error of the content to the ledger where the body wears.
void book(const Problem& problem, State& next, int body, double removed) {
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const auto& placed = problem.contacts[c];
    auto& contact = next.solution.contacts[c];
    if (!lies_on(placed, body)) continue;
    (placed.secondary.body == body ? contact.strip_secondary : contact.strip_primary) += removed;
    return;
  }
}

/// Closes the gaps of the contacts that keep their pressures, as they are at q, and takes the moves off their losses.
/// Returns the moves of the outlines.
Shifts close_gaps(const Problem& problem, const solver::System& system, const Vector& q,
                  const std::vector<HeldTraction>& held, State& next, CarriedGap& carried) {
  Shifts shifts(next.shapes.size());
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    if (!keeps_pressure(problem.contacts[c].options)) continue;
    const auto& setup = system.contacts[c];
    auto& contact = next.solution.contacts[c];
    const Closing closing = closing_of(setup, contact, solver::positions(system, setup, q), held[c]);
    carried.left_mm = std::max(carried.left_mm, closing.left_mm);
    carried.moved_mm = std::max(carried.moved_mm, closing.moved_mm);
    collect(problem.contacts[c], next, closing, shifts);
    take_off(closing.secondary, setup.secondary, contact.removed_secondary);
    take_off(closing.primary, setup.primary, contact.removed_primary);
  }
  return shifts;
}

/// Moves the outlines of all bodies. Returns why that fails, or nothing; the shapes then stay as they are.
std::string shift_outlines(const Problem& problem, const Shifts& shifts, Cache& cache, State& next) {
  Timer timer(cache, "adapt");
  auto shapes = next.shapes;
  std::vector<double> removed(shapes.size(), 0.0);
  for (std::size_t b = 0; b < shapes.size(); ++b) {
    if (shifts[b].empty()) continue;
    auto shifted = adapt::shift_outline(shapes[b], problem.scene.analysis, shifts[b], &cache.relocation);
    if (!shifted.failure.empty()) return shifted.failure;
    shapes[b] = std::move(shifted.shape);
    removed[b] = shifted.removed;
  }
  next.shapes = std::move(shapes);
  for (std::size_t b = 0; b < removed.size(); ++b) book(problem, next, static_cast<int>(b), removed[b]);
  return {};
}

/// Moves the worn nodes of `next` by one linear step from equilibrium under the held tractions.
CarriedGap carry_gap(const Problem& problem, State& next, Cache& cache, const BlockSpan& span,
                     const std::vector<HeldTraction>& held) {
  CarriedGap carried;
  State pressed = next;
  carried.failure = equilibrate_on_springs(problem, pressed, cache, span, held);
  next.counts = pressed.counts;
  if (!carried.failure.empty()) return carried;
  const auto kept = timed_system(problem, next, cache);
  const auto& system = *kept;
  const Shifts shifts = close_gaps(problem, system, pressed.solution.q.high, held, next, carried);
  carried.failure = shift_outlines(problem, shifts, cache, next);
  if (!carried.failure.empty()) return carried;
  next.solution.q = std::move(pressed.solution.q);
  next.solution.interiors = std::move(pressed.solution.interiors);
  return carried;
}

double largest_jump(const solver::System& system, const State& state, const std::vector<HeldTraction>& held) {
  double largest = 0.0;
  for (std::size_t c = 0; c < held.size(); ++c)
    if (!system.contacts[c].options.bonded && keeps_pressure(system.contacts[c].options))
      largest = std::max(largest, pressure_jump(system.contacts[c], state.solution.contacts[c], held[c]));
  return largest;
}

}  // namespace

std::string equilibrate_with_gap(const Problem& problem, State& next, Cache& cache, const BlockSpan& span,
                                 const std::vector<HeldTraction>& held, CarriedGap& gap) {
  constexpr int passes = 4;        // one linear pass is not enough where corners move
  constexpr double small = 0.003;  // jump of pressure that needs no further pass
  State carried = next;
  // Moving nodes must be better than moving none: it is compared with the equilibrium of the shape as redrawn.
  if (std::string why = re_equilibrate(problem, next, cache, span, held); !why.empty()) return why;
  double jump = largest_jump(*system_of(problem, next, cache), next, held);
  for (int pass = 0; pass < passes && jump > small; ++pass) {
    carried.counts = next.counts;
    const CarriedGap now = carry_gap(problem, carried, cache, span, held);
    if (now.moved_mm == 0.0) break;
    State tried = carried;
    if (!re_equilibrate(problem, tried, cache, span, held).empty()) break;
    const double after = largest_jump(*system_of(problem, tried, cache), tried, held);
    if (!(after < jump)) break;
    const bool settled =
        after > 0.5 * jump;  // the remaining change is not due to a gap: tractions turned with the normals
    jump = after;
    next = std::move(tried);
    gap.moved_mm += now.moved_mm;
    gap.left_mm = now.left_mm;
    gap.failure = now.failure;
    if (settled) break;
  }
  return {};
}

}  // namespace reye::sim
