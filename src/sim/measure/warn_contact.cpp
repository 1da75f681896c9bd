#include "sim/measure/warn_contact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/formatted.hpp"
#include "cad/part/zone.hpp"
#include "scene/histories.hpp"
#include "sim/measure/roundness.hpp"
#include "sim/measure/zones.hpp"
#include "sim/problem/warnings.hpp"

namespace reye::sim {

namespace {

constexpr double facet_share = 0.1;  ///< of the approach: facets beyond it carry the load on their corners
constexpr double milder_side = 0.2;  ///< a limit's side wears less than this share of the other
constexpr double remesh_jump = 0.1;  ///< of the pressure, L2: beyond it the mesh rules the pressure
constexpr int edge_nodes = 2;        ///< one at each edge of contact, which is not a slip zone that the mesh resolves

/// Approximate approach of the two sides under the load [mm]: 2 P / E* of a line contact, in axisymmetry under the
/// force per length of the circle through its peak; P / (E* a) of a contact round the axis.
double approach_of(const Problem& problem, std::size_t c, const Pressed& p) {
  const double modulus = effective_modulus(problem, problem.contacts[c]);
  if (problem.scene.analysis != base::Analysis::axisymmetric) return 2.0 * p.force / modulus;
  if (p.peak_mm <= p.length_mm) return p.force / (modulus * p.length_mm);
  return p.force / (std::numbers::pi * p.peak_mm * modulus);
}

std::string nodes_touching(const Pressed& p, const State& state) {
  return base::formatted("%.3g mm of it touch at cycle %g", p.length_mm, state.cycle);
}

/// Largest motion that a support imposes [mm].
double largest_motion(const scene::Scene& scene) {
  double most = 0.0;
  for (const auto& support : scene.supports)
    for (const auto* motion : {&support.x, &support.y})
      if (motion->drive == body::Drive::moved) most = std::max(most, scene::largest_value(scene, motion->parts));
  return most;
}

/// Whether a step that wears has been played.
bool has_worn(const scene::Scene& scene, const State& state) {
  for (int i = 0; i < static_cast<int>(scene.steps.size()); ++i)
    if (scene.steps[i].wear && (i < state.step || (i == state.step && state.step_blocks > 0))) return true;
  return false;
}

void warn_of_limit(const scene::Scene& scene, const scene::Limit& limit, const ContactSummary& contact, State& state,
                   const Observer& observer) {
  if (limit.side == "sum") return;
  const bool primary = limit.side == "primary";
  const auto of = [&](const SideSummary& side) { return limit.depth_mm ? side.max_depth_mm : side.worn_area; };
  const double own = of(primary ? contact.primary : contact.secondary),
               other = of(primary ? contact.secondary : contact.primary);
  if (other <= 0.0 || own >= milder_side * other) return;
  const bool watched = std::any_of(scene.limits.begin(), scene.limits.end(), [&](const scene::Limit& l) {
    return l.contact == limit.contact && l.side != limit.side;
  });
  if (watched) return;
  const char* what = limit.depth_mm ? "deep" : "much";
  warn(
      state, observer,
      {"limit_side", "limit " + limit.name,
       base::formatted(
           "It watches the %s side; the %s side wears %.3g times as %s. Set side = \"%s\", or a limit for each side.",
           limit.side.c_str(), primary ? "secondary" : "primary", other / own, what, primary ? "secondary" : "primary"),
       other / own});
}

void warn_of_ledger(const ContactSummary& contact, State& state, const Observer& observer) {
  constexpr double open_book = 1e-6;  // relative
  constexpr double rounding = 1e-12;  // mm^2 or mm^3, below the resolution of stored coordinates
  const double error = contact.ledger_relative_error.value_or(0.0);
  if (error <= open_book || contact.secondary.worn_area + contact.primary.worn_area <= rounding) return;
  warn(state, observer,
       {"ledger", "contact " + contact.name,
        base::formatted(
            "The volume that its bodies have lost and coefficient x work differ by %.2g %%; they should agree to "
            "rounding. "
            "Please report this scene.",
            100.0 * error),
        error});
}

}  // namespace

const cad::FineZone* zone_round(const body::Shape& shape, const std::string& contact, const Vec2& X) {
  if (!shape.drawing || shape.drawing->part.mesh) return nullptr;
  const auto zones = zones_of(*shape.drawing, contact);
  return zones.empty() ? nullptr : zones[cad::zone_at(zones, X)];
}

double wanted_across(const Problem& problem, const contact::ContactOptions& contact) {
  const auto& steps = problem.scene.steps;
  const bool worn =
      contact.wear.wears() && std::any_of(steps.begin(), steps.end(), [](const auto& step) { return step.wear; });
  return worn ? fewest_before_wear : fewest_across;
}

void warn_of_resolution(std::vector<Warning>& warnings, const std::string& contact, double across, double wanted,
                        double length_mm, const std::string& how) {
  if (across >= wanted) return;
  warn(warnings,
       {"resolution", "contact " + contact,
        base::formatted("%.2g elements lie across the contact (%s): its pressure and what wears first are those of the "
                        "mesh. Make elements "
                        "there %.2g mm long or shorter, for at least %g across.",
                        across, how.c_str(), length_mm / fewest_across, fewest_across),
        fewest_across / across});
}

void warn_of_facets(std::vector<Warning>& warnings, const std::string& contact, double sagitta_mm, double approach_mm,
                    double size_mm) {
  const double share = sagitta_mm / approach_mm;
  if (share < facet_share) return;
  warn(warnings,
       {"facets", "contact " + contact,
        base::formatted("Straight facets leave the curved sides by %.2g mm, where the load presses these together by "
                        "some %.2g mm (2 P / E*): the "
                        "pressure peaks at the corners of facets. Use order = 2, or elements of %.2g mm.",
                        sagitta_mm, approach_mm, size_mm * std::sqrt(facet_share / share)),
        share});
}

void note_boundary_end(const std::string& contact, const Pressed& p, double cycle, std::vector<Warning>& found) {
  if (p.cut.empty()) return;
  found.push_back(
      {"boundary_end", "contact " + contact,
       base::formatted("The contact runs to the end of %s at cycle %g, where the outline continues smoothly: what "
                       "would touch there does not, "
                       "and the pressure rises at the end. Name the edges beyond it as well.",
                       p.cut.c_str(), cycle)});
}

void note_beside_zone(const std::string& contact, const Pressed& p, double cycle, std::vector<Warning>& found) {
  if (p.beside_zone <= 0.0) return;
  found.push_back(
      {"fine_zone", "contact " + contact,
       base::formatted("At cycle %g most of the load is carried beside the fine zone, on elements %.3g times as "
                       "long as it asks for. Set "
                       "fine_zone.centre_mm and half_width_mm to where the sides touch.",
                       cycle, p.beside_zone),
       p.beside_zone});
}

void warn_of_block(const Problem& problem, State& state, const Observer& observer) {
  for (std::size_t c = 0; c < state.watch.size(); ++c) {
    const Pressed& p = state.watch[c].pressed;
    if (p.force <= 0.0 || p.force < 0.5 * state.watch[c].force_most) continue;
    const auto& name = problem.contacts[c].options.name;
    std::vector<Warning> found;
    if (!p.bounded)
      warn_of_resolution(found, name, p.across, wanted_across(problem, problem.contacts[c].options), p.length_mm,
                         nodes_touching(p, state));
    note_boundary_end(name, p, state.cycle, found);
    note_beside_zone(name, p, state.cycle, found);
    if (p.facets_mm > 0.0 && p.across >= fewest_across)
      warn_of_facets(found, name, p.facets_mm, approach_of(problem, c, p), p.size_mm);
    for (auto& warning : found) warn(state, observer, std::move(warning));
  }
}

void warn_of_never_closed(const std::string& contact, State& state, const Observer& observer) {
  warn(state, observer,
       {"never_closed", "contact " + contact,
        "No node of it ever carried a force; check gap, direction and size of what "
        "presses the sides together."});
}

/// The end of a run is shown, so its pressure must be resolved.
void warn_of_last_resolution(const std::string& contact, const Pressed& p, State& state, const Observer& observer) {
  if (p.force <= 0.0 || p.bounded) return;
  std::vector<Warning> found;
  warn_of_resolution(found, contact, p.across, fewest_across, p.length_mm, nodes_touching(p, state));
  for (auto& warning : found) warn(state, observer, std::move(warning));
}

void warn_of_no_slip(const Problem& problem, std::size_t c, State& state, const Observer& observer) {
  const auto& options = problem.contacts[c].options;
  if (!options.wear.wears() || !has_worn(problem.scene, state)) return;
  const int slipped = state.watch[c].slipped_most;
  const bool sticks = options.friction > 0.0 && !options.imposed && slipped <= edge_nodes;
  if (!sticks && state.solution.contacts[c].law_volume != 0.0) return;
  warn(state, observer,
       {"no_slip", "contact " + options.name,
        base::formatted(
            "It should wear, but at most %d of its nodes slipped in a step that wears, while supports move by up "
            "to %.3g "
            "mm. Check the stroke (mm), that both sides are held along it, and the coefficient of friction.",
            slipped, largest_motion(problem.scene))});
}

void warn_of_run(const Problem& problem, State& state, const Summary& summary, const Observer& observer) {
  for (const auto& contact : summary.contacts) warn_of_ledger(contact, state, observer);
  for (std::size_t c = 0; c < state.watch.size(); ++c) {
    const auto& name = problem.contacts[c].options.name;
    if (state.watch[c].force_most == 0.0) {
      warn_of_never_closed(name, state, observer);
      continue;
    }
    warn_of_last_resolution(name, state.watch[c].pressed, state, observer);
    warn_of_no_slip(problem, c, state, observer);
  }
  for (const auto& limit : problem.scene.limits)
    for (const auto& contact : summary.contacts)
      if (contact.name == limit.contact) warn_of_limit(problem.scene, limit, contact, state, observer);
}

void warn_of_remesh(State& state, const Observer& observer, const RemeshRecord& record) {
  if (record.pressure_jump <= remesh_jump) return;
  warn(state, observer,
       {"remesh", "body " + record.body,
        base::formatted(
            "The fresh mesh at cycle %g changed the pressure by %.0f %% in the mean: pressures after it are those of "
            "the mesh, "
            "until wear has levelled them. More elements across the contact make the change smaller.",
            record.cycle, 100.0 * record.pressure_jump),
        record.pressure_jump});
}

}  // namespace reye::sim
