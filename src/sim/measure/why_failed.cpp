#include "sim/measure/why_failed.hpp"

#include <algorithm>
#include <cmath>

#include "base/formatted.hpp"
#include "body/motions.hpp"
#include "body/operator.hpp"
#include "mesh/measure.hpp"
#include "scene/histories.hpp"
#include "sim/measure/nodal_depth.hpp"
#include "sim/measure/roundness.hpp"
#include "sim/measure/sides.hpp"
#include "sim/measure/sizes.hpp"
#include "sim/measure/small_strain.hpp"
#include "sim/measure/worn_through.hpp"

namespace reye::sim {

namespace {

constexpr double crushed = 0.3;  ///< mean strain
constexpr int too_few = 2;       ///< nodes in contact

/// One contact in the last good state.
struct Seen {
  const Problem& problem;
  const PlacedContact& placed;
  const contact::Setup& setup;
  const contact::ContactState& state;
  const char* name() const { return placed.options.name.c_str(); }
  double pressure() const {
    double most = 0.0;
    for (std::size_t j = 0; j < state.lambda.size(); ++j) most = std::max(most, state.lambda[j].dot(state.normal[j]));
    return most;
  }
  /// Length of the elements where the pressure is largest [mm].
  double facet() const {
    int peak = 0;
    const auto at = [&](int j) { return state.lambda[j].dot(state.normal[j]); };
    for (int j = 1; j < setup.secondary_count(); ++j)
      if (at(j) > at(peak)) peak = j;
    return spacing(setup.secondary, peak);
  }
};

/// The sliding distance of the sides in one play of the step: as supports move them, or as imposed.
double way_of_play(const Seen& c, const scene::Step& step) {
  double way = 0.0;
  if (c.placed.options.imposed) {
    const auto& parts = c.placed.options.imposed_sliding;
    for (const auto& part : parts)
      if (part.history.empty()) way += std::abs(part.value);
    return way + scene::path_of(c.problem.scene, step, parts);
  }
  const auto look = [&](int body) {
    for (const auto& support : c.problem.inputs[body].supports)
      for (const auto* motion : {&support.x, &support.y}) {
        if (motion->drive == body::Drive::moved)
          way = std::max(way, scene::path_of(c.problem.scene, step, motion->parts));
      }
  };
  look(c.placed.secondary.body);
  for (const auto& ref : c.placed.primary) look(ref.body);
  return way;
}

std::string wears_too_fast(const Seen& c, const Attempt& attempt) {
  const auto& law = c.placed.options.wear;
  if (!law.wears() || !attempt.step->wear || law.secondary_formula || law.primary_formula) return {};
  double traction = law.kind == wear::LawKind::rate ? 1.0 : c.pressure();
  if (law.kind == wear::LawKind::energy) traction *= c.state.friction;
  const double depth = std::max(law.secondary, law.primary) * attempt.jump * traction * way_of_play(c, *attempt.step);
  if (depth <= c.facet()) return {};
  return base::formatted(
      "contact %s would wear by some %.2g mm in a block of %g cycle%s, more than its elements of %.3g mm are long; "
      "check its wear "
      "coefficients, or write a smaller jump",
      c.name(), depth, attempt.jump, attempt.jump == 1.0 ? "" : "s", c.facet());
}

std::string waits_in_the_gap(const Seen& c) {
  const double own = deepest(c.setup.secondary, c.state.removed_secondary),
               other = deepest(c.setup.primary, c.state.removed_primary);
  if (c.problem.scene.shape || own + other <= 0.5 * c.setup.search) return {};
  return base::formatted(
      "wear of %.3g mm waits in the gap of contact %s, as shape = \"off\" asks, and facets are paired no farther than "
      "search_mm = %.3g; "
      "write shape = \"on\", or a longer search_mm",
      own + other, c.name(), c.setup.search);
}

/// The shortest way between the sides, from nodes of the secondary to nodes of the primary side.
std::string out_of_reach(const Seen& c, const solver::System& system, const State& last) {
  const auto x = solver::positions(system, c.setup, last.solution.q.high);
  double gap = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, mid] : c.setup.primary.facets)
    for (const Vec2& s : x.secondary) gap = std::min(gap, mesh::distance_to_edge(x.primary[a], x.primary[b], s));
  if (gap <= c.setup.search) return {};
  return base::formatted(
      "the sides of contact %s are %.4g mm apart, and facets are paired no farther than search_mm = %.4g; write "
      "search_mm = %.2g",
      c.name(), gap, c.setup.search, 1.5 * gap);
}

std::string few_nodes(const Seen& c) {
  const auto touching = std::count_if(c.state.status.begin(), c.state.status.end(),
                                      [](auto s) { return s != contact::ContactStatus::inactive; });
  if (touching == 0 || touching > too_few) return {};
  return base::formatted(
      "only %d node%s of contact %s touch%s, on elements of %.3g mm: too coarse to carry its load; make them shorter "
      "there, "
      "with a fine_zone",
      static_cast<int>(touching), touching == 1 ? "" : "s", c.name(), touching == 1 ? "es" : "", c.facet());
}

std::string strained(const Problem& problem, const State& last, const solver::System& system) {
  for (int b = 0; b < problem.body_count(); ++b) {
    if (problem.rigid[b]) continue;
    if (auto why = why_crushed(problem, b); !why.empty()) return why;
    const double strain = distortion_of(problem, last, system, b).strain;
    if (strain > crushed)
      return base::formatted(
          "body %s is strained by %.2g %% on average already: more than it can bear; check loads, motions and E_MPa",
          problem.inputs[b].name.c_str(), 100.0 * strain);
  }
  return {};
}

/// What friction holds along a contact, summed over its nodes.
struct Hold {
  double used = 0.0;   ///< share of the friction that its pressure allows
  std::string motion;  ///< the motion that it resists, as `unheld_together` names it
};

Hold hold_by_friction(const contact::Setup& setup, const contact::ContactState& state) {
  Vec2 shear = Vec2::Zero();
  double pressure = 0.0;
  for (std::size_t j = 0; j < state.lambda.size(); ++j) {
    const Vec2 n = state.normal[j], force = state.lambda[j] * setup.secondary.area[j];
    pressure += force.dot(n);
    shear += force - force.dot(n) * n;
  }
  const double most = state.friction * pressure;
  return {most > 0.0 ? shear.norm() / most : 0.0,
          std::abs(shear.x()) > std::abs(shear.y()) ? "translation along x" : "translation along y"};
}

/// A body that friction of this contact alone held along it, once that friction is spent.
std::string slides_off(const Seen& c, const std::string& body, const std::vector<std::string>& free) {
  constexpr double nearly_all = 0.95;
  const Hold hold = hold_by_friction(c.setup, c.state);
  if (hold.used < nearly_all || std::find(free.begin(), free.end(), hold.motion) == free.end()) return {};
  return base::formatted(
      "body %s slides off: friction of contact %s carries %.1f %% of what it can, and no support holds its %s; check "
      "its loads and the friction, or support it",
      body.c_str(), c.name(), 100.0 * hold.used, hold.motion.c_str());
}

/// Bodies that supports leave free, and the contacts that no longer hold them: friction is spent, or pressure is gone.
std::string let_go(const Problem& problem, const State& last, const solver::System& system) {
  for (int b = 0; b < problem.body_count(); ++b) {
    const auto joins = [b](const PlacedContact& joint) { return lies_on(joint, b); };
    if (std::any_of(problem.bonds.begin(), problem.bonds.end(), joins))
      continue;  // it moves with the body to which it is bonded
    const auto free = body::unheld_together({{&problem.shapes[b]->mesh, &problem.inputs[b].supports}},
                                            problem.scene.analysis == base::Analysis::axisymmetric);
    if (free.empty()) continue;
    std::string contacts;
    for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
      if (!joins(problem.contacts[c])) continue;
      const Seen seen{problem, problem.contacts[c], system.contacts[c], last.solution.contacts[c]};
      if (auto words = slides_off(seen, problem.inputs[b].name, free); !words.empty()) return words;
      contacts += std::string(contacts.empty() ? "" : " or ") + seen.name();
    }
    if (contacts.empty()) continue;
    return "body " + problem.inputs[b].name + " has come away from contact " + contacts +
           ", and no support holds its " + free.front() +
           "; check the direction of its loads, and that they press it on throughout the step";
  }
  return {};
}

}  // namespace

std::string why_failed(const Problem& problem, const State& last, const Attempt& attempt,
                       const solver::System& system) {
  const bool lost = attempt.failure == solver::Failure::contact_lost;
  if (attempt.failure == solver::Failure::no_law) return attempt.reason;
  std::string why;
  const auto ask = [&why](std::string words) {
    if (why.empty()) why = std::move(words);
  };
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const Seen seen{problem, problem.contacts[c], system.contacts[c], last.solution.contacts[c]};
    ask(wears_too_fast(seen, attempt));
    ask(waits_in_the_gap(seen));
    if (c + 1 == problem.contacts.size()) ask(worn_through(problem, last));
    if (lost) ask(out_of_reach(seen, system, last));
  }
  ask(strained(problem, last, system));
  if (lost) ask(let_go(problem, last, system));
  for (std::size_t c = 0; c < problem.contacts.size() && !lost; ++c)
    ask(few_nodes({problem, problem.contacts[c], system.contacts[c], last.solution.contacts[c]}));
  return why.empty() ? attempt.reason : why;
}

}  // namespace reye::sim
