#include "scene/solid/validate_solid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/formatted.hpp"
#include "scene/histories.hpp"
#include "scene/names.hpp"
#include "scene/solid/build_solid.hpp"
#include "scene/validate.hpp"
#include "scene/wear_rules.hpp"

namespace reye::scene {

namespace {

constexpr std::string_view solid_motions[] = {"x", "y", "z", "normal", "rotation_x", "rotation_y", "rotation_z"};
constexpr std::string_view slidings[] = {"imposed_sliding_mm", "imposed_turn_rad"};

Played played_in(const SolidScene& scene) { return {scene.histories, scene.steps}; }

void check_solid_bodies(const Entry& root, const SolidScene& scene, Issues& issues) {
  const auto bodies = names_of(scene.geometry.bodies);
  if (!root.given("body")) issues.push_back({"body", "", "missing; a scene has at least one [body.NAME]"});
  for (const auto& body : root.all("body"))
    if (!body.flag("rigid")) refer(body, "material", "material", keys_of(scene.materials), issues);
  for (const auto& face : root.all("face")) refer(face, "body", "body", bodies, issues);
  for (const auto& support : root.all("support")) refer(support, "body", "body", bodies, issues);
  for (const auto& load : root.all("load")) refer(load, "body", "body", bodies, issues);
  for (const auto& probe : root.at("output").all("probes")) refer(probe, "body", "body", bodies, issues);
}

/// Tetrahedra of first order lock where the material is nearly incompressible.
void check_locking(const Entry& root, const SolidScene& scene, Issues& issues) {
  constexpr double most_nu = 0.45, incompressible = 0.5;
  for (const auto& body : root.all("body")) {
    const auto found = scene.materials.find(body.text("material"));
    if (found == scene.materials.end() || body.whole("order") != 1) continue;
    const double nu = std::visit([](const auto& material) { return material.nu; }, found->second);
    if (nu > most_nu && nu < incompressible)
      issues.push_back(
          {body.key("order"), body.written("order"),
           base::formatted("tetrahedra of first order lock at nu = %g, as above 0.45; take order = 2", nu)});
  }
}

void check_symmetry(const Entry& root, const SolidScene& scene, Issues& issues) {
  std::set<std::string> seen;
  for (const auto& face : scene.symmetry)
    if (!seen.insert(face).second)
      issues.push_back({"symmetry", root.written("symmetry"), "names \"" + face + "\" twice"});
  for (const auto& support : root.all("support"))
    if (support.given("normal") && seen.contains(support.text("face")))
      issues.push_back({support.key("normal"), support.written("normal"), "the face is held there by symmetry"});
}

/// Supports of a body that deforms act on its faces.
void check_supported_bodies(const Entry& root, const SolidScene& scene, Issues& issues) {
  for (const auto& support : root.all("support"))
    for (const auto& body : scene.geometry.bodies)
      if (body.name == support.text("body") && !body.rigid)
        issues.push_back({support.key("body"), support.written("body"), "deforms: it is held at a face"});
}

void check_solid_histories(const Entry& root, const NameList& histories, Issues& issues) {
  const auto refer_parts = [&](const Entry& entry, std::string_view key) {
    for (const auto& part : entry.parts(key)) refer(part, "history", "history", histories, issues);
  };
  for (const auto& support : root.all("support"))
    for (const auto motion : solid_motions) refer_parts(support, motion);
  for (const auto& contact : root.all("contact"))
    for (const auto sliding : slidings) refer_parts(contact, sliding);
  for (const auto& load : root.all("load")) {
    refer(load, "history", "history", histories, issues);
    for (const auto& part : load.all("parts")) refer(part, "history", "history", histories, issues);
  }
}

/// Histories that support motions and loads follow.
std::set<std::string> moving_histories(const SolidScene& scene) {
  std::set<std::string> names;
  const auto note = [&](const body::Motion& motion) {
    for (const auto& part : motion.parts) names.insert(part.history);
  };
  for (const auto& support : scene.supports) {
    for (const auto& motion : support.along) note(motion);
    for (const auto& motion : support.about) note(motion);
    note(support.normal);
  }
  for (const auto& load : scene.loads) names.insert(load.history);
  return names;
}

/// True when a history that rises by this much in a cycle turns bodies about one axis by whole turns, and moves nothing
/// else.
bool turns_wholly(const SolidScene& scene, const std::string& history, double rise) {
  const auto follows = [&](const body::Motion& motion) {
    return std::any_of(motion.parts.begin(), motion.parts.end(),
                       [&](const base::Part& part) { return part.history == history; });
  };
  const auto whole = [&](const body::Motion& motion) {
    double turn_rad = 0.0;
    for (const auto& part : motion.parts) turn_rad += part.history == history ? part.value * rise : 0.0;
    const double count = turn_rad / (2.0 * std::numbers::pi);
    return motion.drive == body::Drive::moved && std::abs(count - std::round(count)) <= 1e-6;
  };
  for (const auto& support : scene.supports) {
    if (std::any_of(support.along.begin(), support.along.end(), follows) || follows(support.normal)) return false;
    const auto turns = std::count_if(support.about.begin(), support.about.end(),
                                     [](const body::Motion& motion) { return body::nonzero(motion); });
    for (const auto& motion : support.about)
      if (follows(motion) && (turns > 1 || !whole(motion))) return false;
  }
  return std::none_of(scene.loads.begin(), scene.loads.end(),
                      [&](const auto& load) { return load.history == history; });
}

/// What moves or loads a body ends a cycle where it began it, but for whole turns; imposed sliding needs no way back.
void check_solid_cycles(const Entry& root, const SolidScene& scene, Issues& issues) {
  const auto moving = moving_histories(scene);
  for (const auto& step : root.all("step")) {
    if (step.number("cycles") <= 1.0) continue;
    for (const auto& name : step.texts("play")) {
      const auto found = scene.histories.find(name);
      if (found == scene.histories.end() || found->second.empty() || !moving.contains(name)) continue;
      const auto rule = open_cycle_rule(name, found->second, scene.measured.contains(name));
      const double rise = found->second.back()[1] - found->second.front()[1];
      if (!rule.empty() && !turns_wholly(scene, name, rise))
        issues.push_back({step.key("play"), step.written("play"), rule});
    }
  }
}

/// Wear that depends on speed needs the duration of steps; limits watch contacts.
void check_solid_wear(const Entry& root, const SolidScene& scene, Issues& issues) {
  for (const auto& contact : scene.contacts) {
    const auto speed = needs_speed(contact.wear);
    for (const auto& step : root.all("step"))
      if (!speed.empty() && step.flag("wear") && !step.given("period_s"))
        issues.push_back({step.key("period_s"), "", "missing; contact \"" + contact.name + "\" " + speed});
  }
  for (const auto& limit : root.all("limit")) refer(limit, "contact", "contact", names_of(scene.contacts), issues);
  check_bands(root, no_band_rule(scene), issues);
}

}  // namespace

std::string no_band_rule(const SolidScene& scene) {
  for (const auto& contact : scene.contacts)
    if (auto why = no_band_by_law(contact.name, contact.wear); !why.empty()) return why;
  return no_band_by_steps(scene.steps);
}

void validate_solid(const Entry& root, const SolidScene& scene, Issues& issues) {
  check_solid_bodies(root, scene, issues);
  check_locking(root, scene, issues);
  check_symmetry(root, scene, issues);
  check_supported_bodies(root, scene, issues);
  check_solid_histories(root, keys_of(scene.histories), issues);
  check_plays(root, keys_of(scene.histories), issues);
  check_solid_cycles(root, scene, issues);
  check_solid_wear(root, scene, issues);
  validate_skin_contacts(root, scene, issues);
}

Issues suspicious_solid(const Entry& root, const SolidScene& scene) {
  constexpr std::array lengths = {"x", "y", "z", "normal"};
  Issues found;
  for (const auto& material : root.all("material")) look_at_modulus(material, found);
  const auto contacts = root.all("contact");
  for (std::size_t i = 0; i < contacts.size(); ++i) look_at_friction(contacts[i], scene.contacts[i].friction, found);
  for (const auto& support : root.all("support")) look_at_motions(support, lengths, played_in(scene), found);
  auto acting = moving_histories(scene);
  for (const auto& contact : scene.contacts)
    for (const auto& sliding : contact.sliding)
      for (const auto& part : sliding.parts) acting.insert(part.history);
  warn_of_idle(root, played_in(scene), acting, found);
  warn_of_measured(root, scene.measured, found);
  return found;
}

}  // namespace reye::scene
