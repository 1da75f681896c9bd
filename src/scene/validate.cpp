#include "scene/validate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/formatted.hpp"
#include "scene/histories.hpp"
#include "scene/names.hpp"
#include "scene/wear_rules.hpp"

namespace reye::scene {

namespace {

constexpr std::string_view motions[] = {"x", "y", "tangent", "normal", "rotation"};

void check_histories(const Entry& root, const NameList& histories, Issues& issues) {
  for (const auto& support : root.all("support"))
    for (const auto motion : motions)
      for (const auto& part : support.parts(motion)) refer(part, "history", "history", histories, issues);
  for (const auto& contact : root.all("contact"))
    for (const auto sliding : {"imposed_sliding_mm", "imposed_out_of_plane_mm", "imposed_turn_rad"})
      for (const auto& part : contact.parts(sliding)) refer(part, "history", "history", histories, issues);
  for (const auto& load : root.all("load")) {
    refer(load, "history", "history", histories, issues);
    for (const auto& part : load.all("parts")) refer(part, "history", "history", histories, issues);
  }
}

/// What a contact needs the speed of slip for in a step that wears, or does not; empty: it does not need it.
std::string why_speed(const contact::ContactOptions& contact, bool wears) {
  if (contact.friction_formula.uses(wear::Variable::speed)) return "rubs by a formula of speed_mm_per_s";
  return wears ? needs_speed(contact.wear) : "";
}

/// A law that depends on speed asks each step in which it acts for its duration.
void check_period(const Entry& step, const Scene& scene, Issues& issues) {
  if (step.given("period_s")) return;
  for (const auto& contact : scene.contacts)
    if (const auto why = why_speed(contact, step.flag("wear")); !why.empty()) {
      issues.push_back({step.key("period_s"), "", "missing; contact \"" + contact.name + "\" " + why});
      return;
    }
}

/// True when a history that rises by this much in a cycle turns bodies by whole turns or is a way to slide, and moves
/// nothing else.
bool may_go_on(const Scene& scene, const std::string& history, double rise) {
  bool goes_on = false;
  const auto driven = [&](const base::Part& part) { return part.history == history; };
  const auto any_driven = [&](const base::Parts& parts) { return std::any_of(parts.begin(), parts.end(), driven); };
  for (const auto& contact : scene.contacts)
    goes_on = goes_on || any_driven(contact.imposed_sliding) || any_driven(contact.imposed_turn);
  const auto whole = [&](double angle_rad) {
    constexpr double small = 1e-6;
    const double count = angle_rad * rise / (2.0 * std::numbers::pi);
    return std::abs(count - std::round(count)) <= small;
  };
  for (const auto& support : scene.supports) {
    if (any_driven(support.x.parts) || any_driven(support.y.parts)) return false;
    for (const auto& part : support.rotation.parts) {
      if (!driven(part)) continue;
      if (support.rotation.drive != body::Drive::moved || !whole(part.value)) return false;
      goes_on = true;
    }
  }
  const auto loads = [&](const auto& list) {
    return std::any_of(list.begin(), list.end(), [&](const auto& load) { return load.history == history; });
  };
  return goes_on && !loads(scene.boundary_loads) && !loads(scene.point_loads) && !loads(scene.body_forces);
}

/// A cycle ends where it began, but for whole turns: the jump back to its start would be played inside the next one's
/// first increment, once in a block of many cycles.
void check_cycle(const Entry& step, const Scene& scene, Issues& issues) {
  double cycles = step.number("cycles");
  for (const auto& played : scene.steps)  // levels of a spectrum give others
    if (played.name == step.text("name")) cycles = std::max(cycles, played.cycles);
  if (cycles <= 1.0 || !step.flag("wear")) return;
  for (const auto& name : step.texts("play")) {
    const auto found = scene.histories.find(name);
    if (found == scene.histories.end() || found->second.empty()) continue;
    const auto& corners = found->second;
    const auto rule = open_cycle_rule(name, corners, scene.measured.contains(name));
    if (!rule.empty() && !may_go_on(scene, name, corners.back()[1] - corners.front()[1]))
      issues.push_back({step.key("play"), step.written("play"), rule});
  }
}

void check_steps(const Entry& root, const Scene& scene, Issues& issues) {
  check_plays(root, keys_of(scene.histories), issues);
  for (const auto& step : root.all("step")) {
    check_period(step, scene, issues);
    check_cycle(step, scene, issues);
  }
}

/// A finite-strain body needs a law of finite strain.
void check_kinematics(const Entry& root, const Scene& scene, Issues& issues) {
  for (const auto& body : root.all("body")) {
    const auto found = scene.materials.find(body.text("material"));
    if (found == scene.materials.end() || body.text("kinematics") != "finite") continue;
    if (std::holds_alternative<material::LinearElastic>(found->second))
      issues.push_back({body.key("kinematics"), body.written("kinematics"),
                        "material \"" + found->first +
                            "\" is linear_elastic, a law of small strain; the same E_MPa and nu "
                            "serve hencky, neo_hookean and st_venant_kirchhoff"});
  }
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

}  // namespace

std::string no_band_rule(const Scene& scene) {
  for (const auto& contact : scene.contacts) {
    if (contact.friction_formula) return "contact \"" + contact.name + "\" has a formula";
    if (auto why = no_band_by_law(contact.name, contact.wear); !why.empty()) return why;
    if (!contact.friction_over_cycles.empty())
      return "the friction of contact \"" + contact.name + "\" changes over the cycles";
  }
  for (const auto& [name, material] : scene.materials)
    if (std::holds_alternative<material::HenckyJ2>(material)) return "material \"" + name + "\" flows, cycle by cycle";
  return no_band_by_steps(scene.steps);
}

void validate(const Entry& root, const Scene& scene, Issues& issues) {
  check_bodies(root, scene, issues);
  check_kinematics(root, scene, issues);
  check_histories(root, keys_of(scene.histories), issues);
  check_steps(root, scene, issues);
  validate_contacts(root, scene, issues);
  for (const auto& limit : root.all("limit")) refer(limit, "contact", "contact", names_of(scene.contacts), issues);
  check_bands(root, no_band_rule(scene), issues);
}

namespace {

int order_of(const Scene& scene, const std::string& name) {
  for (const auto& body : scene.geometry.bodies)
    if (body.name == name) return body.mesh.order;
  return 1;
}

/// Warns of elements that lock: triangles of order 1, and quads without B-bar, where the material is (nearly)
/// incompressible.
void warn_of_locking(const Entry& root, const Scene& scene, Issues& found) {
  if (scene.analysis == base::Analysis::plane_stress) return;
  for (const auto& body : root.all("body")) {
    const auto material = scene.materials.find(body.text("material"));
    if (material == scene.materials.end() || order_of(scene, body.name()) == 2) continue;
    const bool plastic = std::holds_alternative<material::HenckyJ2>(material->second);
    const double nu = std::visit([](const auto& m) { return m.nu; }, material->second);
    const bool triangles = body.at("mesh").text("element") == "tri";
    if (!plastic && nu <= 0.45) continue;
    if (!triangles && body.maybe_flag("b_bar").value_or(true)) continue;
    found.push_back({body.key("material"), body.written("material"),
                     std::string(triangles ? "triangles of order 1" : "quads of order 1 without b_bar") +
                         " lock where the material is (nearly) incompressible, " +
                         (plastic ? "as plastic flow does" : "as nu > 0.45 does") + "; take " +
                         (triangles ? "quads or order = 2" : "b_bar = true or order = 2")});
  }
}

}  // namespace

Issues suspicious(const Entry& root, const Scene& scene) {
  Issues found;
  warn_of_locking(root, scene, found);
  suspicious_values(root, scene, found);
  warn_of_idle(root, {scene.histories, scene.steps}, acting_histories(scene), found);
  warn_of_measured(root, scene.measured, found);
  return found;
}

}  // namespace reye::scene
