#include "sim/measure/shared_wear.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "sim/measure/sides.hpp"

namespace reye::sim {

namespace {

using Contacts = std::vector<contact::ContactState>;

/// A boundary as one side of a contact, or a part of it.
struct Part {
  std::size_t contact = 0;
  bool secondary = true;
  std::size_t first = 0, count = 0;  ///< its nodes among those of the side

  const std::vector<double>& pending(const Contacts& of) const {
    return secondary ? of[contact].pending_secondary : of[contact].pending_primary;
  }
};

/// Boundaries that belong to several sides, by body and name.
using Shared = std::map<std::pair<int, std::string>, std::vector<Part>>;

Shared shared_boundaries(const Problem& problem, const std::vector<body::ShapePtr>& shapes) {
  std::map<std::pair<int, std::string>, int> sides;
  for (const auto& placed : problem.contacts) {
    ++sides[{placed.secondary.body, placed.secondary.boundary}];
    for (const auto& ref : placed.primary) ++sides[{ref.body, ref.boundary}];
  }
  Shared shared;
  if (std::none_of(sides.begin(), sides.end(), [](const auto& side) { return side.second > 1; })) return shared;
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const auto add = [&](const contact::BoundaryRef& ref, bool secondary, std::size_t first) {
      const auto count = side_nodes(shapes, ref).size();
      if (sides[{ref.body, ref.boundary}] > 1) shared[{ref.body, ref.boundary}].push_back({c, secondary, first, count});
      return first + count;
    };
    add(problem.contacts[c].secondary, true, 0);
    std::size_t first = 0;
    for (const auto& ref : problem.contacts[c].primary) first = add(ref, false, first);
  }
  return shared;
}

/// A boundary as a side of a contact, whether it wears there, and the key that names it.
struct Named {
  const PlacedContact* contact = nullptr;
  contact::BoundaryRef ref;
  bool wears = false;
  std::string key;
};

std::vector<Named> named_sides(const Problem& problem) {
  std::vector<Named> sides;
  for (const auto& placed : problem.contacts) {
    const auto& law = placed.options.wear;
    const std::string key = "contact." + placed.options.name;
    sides.push_back({&placed, placed.secondary, law.wears() && law.secondary > 0.0, key + ".secondary"});
    for (const auto& ref : placed.primary)
      sides.push_back({&placed, ref, law.wears() && law.primary > 0.0, key + ".primary"});
  }
  return sides;
}

std::set<std::pair<int, int>> facets_of(const Problem& problem, const contact::BoundaryRef& ref) {
  std::set<std::pair<int, int>> facets;
  for (const auto& chain : problem.shapes[ref.body]->mesh.boundaries.at(ref.boundary))
    for (std::size_t i = 1; i < chain.size(); ++i) facets.insert(std::minmax(chain[i - 1], chain[i]));
  return facets;
}

/// Waiting volume at node k of a part that other parts have removed.
double waiting(const std::vector<Part>& parts, const Part& own, std::size_t k, const Contacts& contacts) {
  double sum = 0.0;
  for (const auto& part : parts)
    if (&part != &own) sum += part.pending(contacts)[part.first + k];
  return sum;
}

}  // namespace

std::vector<base::Issue> shared_wear_issues(const Problem& problem) {
  std::vector<base::Issue> issues;
  const auto sides = named_sides(problem);
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto &a = sides[i], &b = sides[j];
      if (a.contact == b.contact || a.ref.body != b.ref.body || a.ref.boundary == b.ref.boundary ||
          !(a.wears || b.wears))
        continue;
      const auto own = facets_of(problem, a.ref), other = facets_of(problem, b.ref);
      if (std::none_of(own.begin(), own.end(), [&](const auto& facet) { return other.contains(facet); })) continue;
      issues.push_back({a.key, '"' + a.ref.boundary + '"',
                        "has edges in common with \"" + b.ref.boundary + "\" of contact \"" + b.contact->options.name +
                            "\", and what wears there is booked by boundary: give both contacts the same one"});
    }
  return issues;
}

std::vector<LeftByOthers> left_by_others(const Problem& problem, const State& state) {
  std::vector<LeftByOthers> left(problem.contacts.size());
  const auto& contacts = state.solution.contacts;
  for (const auto& [key, parts] : shared_boundaries(problem, state.shapes))
    for (const auto& part : parts) {
      auto& own = left[part.contact];
      auto& values = part.secondary ? own.waiting_secondary : own.waiting_primary;
      values.resize(part.pending(contacts).size(), 0.0);
      for (std::size_t k = 0; k < part.count; ++k) values[part.first + k] = waiting(parts, part, k, contacts);
      if (!part.secondary) continue;
      own.energy.resize(part.count, 0.0);
      for (const auto& other : parts)
        for (std::size_t k = 0; other.secondary && &other != &part && k < part.count; ++k)
          own.energy[k] += contacts[other.contact].energy_secondary[k];
    }
  return left;
}

Volumes removed_as_shown(const Problem& problem, const State& state) {
  Volumes shown = removed_volumes(state.solution.contacts);
  const auto left = left_by_others(problem, state);
  const auto add = [](std::vector<double>& removed, const std::vector<double>& others,
                      const std::vector<double>& waiting) {
    for (std::size_t k = 0; k < removed.size(); ++k)
      if (removed[k] > 0.0) removed[k] += contact::elsewhere(others, k) + contact::elsewhere(waiting, k);
  };
  for (std::size_t c = 0; c < left.size(); ++c) {
    add(shown[c][0], state.solution.contacts[c].others_secondary, left[c].waiting_secondary);
    add(shown[c][1], state.solution.contacts[c].others_primary, left[c].waiting_primary);
  }
  return shown;
}

std::vector<contact::ContactState> as_shown(const Problem& problem, const State& state) {
  Contacts shown = state.solution.contacts;
  auto removed = removed_as_shown(problem, state);
  for (std::size_t c = 0; c < shown.size(); ++c) {
    shown[c].removed_secondary = std::move(removed[c][0]);
    shown[c].removed_primary = std::move(removed[c][1]);
  }
  return shown;
}

std::vector<std::string> told_shared(const Problem& problem) {
  std::vector<std::string> lines;
  for (const auto& [key, parts] : shared_boundaries(problem, problem.shapes)) {
    std::string names;
    int wearing = 0;
    for (const auto& part : parts) {
      const auto& options = problem.contacts[part.contact].options;
      if (!options.wear.wears() || (part.secondary ? options.wear.secondary : options.wear.primary) == 0.0) continue;
      names += (wearing++ > 0 ? ", " : "") + options.name;
    }
    if (wearing > 1)
      lines.push_back("contacts " + names + " wear the same boundary, " + key.second +
                      ": depths there are the sum over all of them, areas and energies are counted per contact");
  }
  return lines;
}

void note_others(const Problem& problem, State& state) {
  const auto left = left_by_others(problem, state);
  const auto add = [](std::vector<double>& others, const std::vector<double>& waiting) {
    if (!waiting.empty()) others.resize(waiting.size(), 0.0);
    for (std::size_t k = 0; k < waiting.size(); ++k) others[k] += waiting[k];
  };
  for (std::size_t c = 0; c < left.size(); ++c) {
    add(state.solution.contacts[c].others_secondary, left[c].waiting_secondary);
    add(state.solution.contacts[c].others_primary, left[c].waiting_primary);
  }
}

}  // namespace reye::sim
