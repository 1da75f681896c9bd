#include "scene/validate.hpp"

#include <algorithm>
#include <set>

#include "scene/nearest.hpp"

namespace reye::scene {

namespace {

using Names = std::vector<std::string>;

template <class Items>
Names names_of(const Items& items) {
  Names names;
  for (const auto& item : items) names.push_back(item.name);
  return names;
}

template <class Value>
Names keys_of(const std::map<std::string, Value>& items) {
  Names names;
  for (const auto& [name, value] : items) names.push_back(name);
  return names;
}

bool holds(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The name written under `key`, if any, must be one of `names`.
void refer(const Entry& entry, std::string_view key, const std::string& what, const Names& names, Issues& issues) {
  const auto name = entry.text(key);
  if (name.empty() || holds(names, name)) return;
  issues.push_back({entry.key(key), entry.written(key), unknown_name_rule(what, name, names)});
}

constexpr std::string_view motions[] = {"x", "y", "tangent", "normal", "rotation"};

void check_histories(const Entry& root, const Names& histories, Issues& issues) {
  for (const auto& support : root.all("support"))
    for (const auto motion : motions)
      if (const auto place = support.at(motion); place.is_table())
        refer(place, "history", "history", histories, issues);
  for (const auto& load : root.all("load")) refer(load, "history", "history", histories, issues);
}

void check_step(const Entry& step, const Names& histories, Issues& issues) {
  std::set<std::string> seen;
  for (const auto& name : step.texts("play")) {
    if (!holds(histories, name))
      issues.push_back({step.key("play"), step.written("play"), unknown_name_rule("history", name, histories)});
    if (!seen.insert(name).second)
      issues.push_back({step.key("play"), step.written("play"), "names \"" + name + "\" twice"});
  }
}

void check_steps(const Entry& root, const Scene& scene, Issues& issues) {
  const auto histories = keys_of(scene.histories);
  std::set<std::string> seen;
  for (const auto& step : root.all("step")) {
    check_step(step, histories, issues);
    if (step.given("name") && !seen.insert(step.text("name")).second)
      issues.push_back({step.key("name"), step.written("name"), "another step has this name"});
  }
  if (!root.given("step")) issues.push_back({"step", "", "missing; a scene has at least one [[step]]"});
}

void check_bodies(const Entry& root, const Scene& scene, Issues& issues) {
  const auto bodies = names_of(scene.geometry.bodies);
  for (const auto& body : root.all("body"))
    if (!body.flag("rigid")) refer(body, "material", "material", keys_of(scene.materials), issues);
  if (!root.given("body")) issues.push_back({"body", "", "missing; a scene has at least one body"});
  for (const auto& boundary : root.all("boundary")) refer(boundary, "body", "body", bodies, issues);
  for (const auto& support : root.all("support")) refer(support, "body", "body", bodies, issues);
  for (const auto& load : root.all("load")) refer(load, "body", "body", bodies, issues);
  for (const auto& probe : root.at("output").all("probes")) refer(probe, "body", "body", bodies, issues);
}

/// Histories that a motion or load names.
std::set<std::string> used(const Scene& scene) {
  std::set<std::string> names;
  for (const auto& support : scene.supports)
    for (const auto& motion : {support.x, support.y, support.rotation}) names.insert(motion.history);
  for (const auto& load : scene.boundary_loads) names.insert(load.history);
  for (const auto& load : scene.point_loads) names.insert(load.history);
  for (const auto& load : scene.body_forces) names.insert(load.history);
  return names;
}

}  // namespace

void validate(const Entry& root, const Scene& scene, Issues& issues) {
  check_bodies(root, scene, issues);
  check_histories(root, keys_of(scene.histories), issues);
  check_steps(root, scene, issues);
  validate_contacts(root, scene, issues);
  for (const auto& limit : root.all("limit")) refer(limit, "contact", "contact", names_of(scene.contacts), issues);
}

Issues suspicious(const Entry& root, const Scene& scene) {
  Issues found;
  std::set<std::string> played;
  for (const auto& step : scene.steps) played.insert(step.play.begin(), step.play.end());
  const auto named = used(scene);
  for (const auto& [name, history] : scene.histories) {
    const auto key = root.at("history").key(name);
    if (!played.count(name)) found.push_back({key, "", "no step plays it; its factor stays 0"});
    if (!named.count(name)) found.push_back({key, "", "no support or load names it"});
  }
  return found;
}

}  // namespace reye::scene
