#include "sim/place/held.hpp"

#include <algorithm>
#include <utility>

#include "body/motions.hpp"
#include "body/operator.hpp"
#include "sim/measure/sides.hpp"
#include "sim/place/held_by_contact.hpp"

namespace reye::sim {

namespace {

using base::Issue;

/// Whether contacts hold a motion; a rotation only where the body cannot lift off them: where they or supports hold it
/// in place.
bool contacts_hold(const Problem& p, int b, const std::string& motion) {
  if (!held_by_contact(p, b, motion)) return false;
  if (motion != "rotation") return true;
  const auto left = body::unheld_together({{&p.shapes[b]->mesh, &p.inputs[b].supports}},
                                          p.scene.analysis == base::Analysis::axisymmetric);
  return std::all_of(left.begin(), left.end(),
                     [&](const std::string& other) { return other == motion || held_by_contact(p, b, other); });
}

void check_rigid_motions(const Problem& p, std::vector<Issue>& issues) {
  for (int b = 0; b < p.body_count(); ++b) {
    bool friction = false;
    for (const auto& contact : p.contacts)
      friction = friction || (lies_on(contact, b) && contact.options.friction > 0.0 && !contact.options.imposed);
    for (const auto& bond : p.bonds) friction = friction || lies_on(bond, b);
    for (const auto& motion : body::unheld_motions(p.shapes[b]->mesh, p.inputs[b], friction))
      if (!contacts_hold(p, b, motion))
        issues.push_back(
            {"body." + p.inputs[b].name, "", motion + " is free: no support holds it and no load drives it"});
  }
}

/// Bodies that contacts and bonds join, each list in the order of the scene.
std::vector<std::vector<int>> groups_in_contact(const Problem& p) {
  std::vector<int> group(p.body_count());
  for (int b = 0; b < p.body_count(); ++b) group[b] = b;
  const auto join = [&](int a, int b) {
    const int from = group[std::max(a, b)], to = group[std::min(a, b)];
    for (int& g : group)
      if (g == from) g = to;
  };
  for (const auto* joints : {&p.contacts, &p.bonds})
    for (const auto& joint : *joints)
      for (const auto& ref : joint.primary) join(joint.secondary.body, ref.body);
  std::map<int, std::vector<int>> members;
  for (int b = 0; b < p.body_count(); ++b) members[group[b]].push_back(b);
  std::vector<std::vector<int>> groups;
  for (auto& [first, list] : members) groups.push_back(std::move(list));
  return groups;
}

/// Checks that each group of touching bodies is held somewhere, so that forces have a reaction.
void check_groups(const Problem& p, std::vector<Issue>& issues) {
  for (const auto& group : groups_in_contact(p)) {
    if (group.size() < 2) continue;
    std::vector<body::HeldBody> bodies;
    std::string names;
    for (int b : group) {
      bodies.push_back({&p.shapes[b]->mesh, &p.inputs[b].supports});
      names += (names.empty() ? "" : b == group.back() ? " and " : ", ") + p.inputs[b].name;
    }
    for (const auto& motion : body::unheld_together(bodies, p.scene.analysis == base::Analysis::axisymmetric))
      issues.push_back(
          {"body." + p.inputs[group.front()].name, "",
           motion + " of " + names +
               " together is free: no support of any of them holds it, so that no force along it has "
               "anything to push against; give one of them a support that is fixed or moved there, or a spring"});
  }
}

}  // namespace

std::vector<Issue> unheld_issues(const Problem& problem) {
  std::vector<Issue> issues;
  check_rigid_motions(problem, issues);
  check_groups(problem, issues);
  return issues;
}

}  // namespace reye::sim
