#include <algorithm>
#include <array>
#include <functional>
#include <set>

#include "base/formatted.hpp"
#include "scene/build.hpp"

namespace reye::scene {

namespace {

/// A law and the keys of its coefficients.
struct LawKeys {
  wear::LawKind kind;
  const char* name;
  const char* unit;  ///< as the keys end
  double factor;     ///< from that unit to consistent ones: 1 mm^3/J = 1e-3 mm^2/N

  std::string key(const char* side) const { return std::string(side) + '_' + unit; }
};

constexpr LawKeys laws[] = {{wear::LawKind::energy, "energy", "mm3_per_J", 1e-3},
                            {wear::LawKind::archard, "archard", "per_MPa", 1.0},
                            {wear::LawKind::rate, "rate", "mm_per_mm", 1.0}};

/// Exponent and reference of one factor of the rate; a reference needs its exponent, and an exponent its reference.
void add_factor(const Entry& wear, std::string_view exponent_key, std::string_view ref_key, double& exponent,
                double& ref, Issues& issues) {
  exponent = wear.number(exponent_key);
  ref = wear.maybe_number(ref_key).value_or(1.0);
  if (exponent != 0.0 && !wear.given(ref_key))
    issues.push_back({wear.key(exponent_key), wear.written(exponent_key), "needs " + std::string(ref_key)});
  if (!wear.given(exponent_key)) refuse(wear, {ref_key}, "has no use without " + std::string(exponent_key), issues);
}

/// A coefficient as a number, or as a formula and its unit.
void add_coefficient(const Entry& wear, const std::string& key, double unit, double& coefficient,
                     wear::Formula& formula) {
  formula = wear.formula(key);
  coefficient = formula ? unit : unit * wear.number(key);
}

/// Friction as a number, as a formula, or as a table over the cycles.
void add_friction(const Entry& entry, contact::ContactOptions& contact, Issues& issues) {
  const auto table = entry.at("friction");
  if (!table.is_table()) {
    contact.friction = entry.number("friction");
    contact.friction_formula = entry.formula("friction");
    if (!contact.friction_formula) return;
    contact.friction = wear::at_start(contact.friction_formula);
    if (contact.friction == 0.0)  // it would count as frictionless for good
      issues.push_back({entry.key("friction"), entry.written("friction"),
                        "is zero where path, depth and cycle are; a formula must be above zero there"});
    return;
  }
  const auto cycles = table.numbers("cycles"), value = table.numbers("value");
  if (std::adjacent_find(cycles.begin(), cycles.end(), std::greater_equal<>()) != cycles.end())
    issues.push_back({table.key("cycles"), table.written("cycles"), "must increase strictly"});
  if (!cycles.empty() && !value.empty() && cycles.size() != value.size())
    issues.push_back({table.key("value"), table.written("value"),
                      "must hold as many numbers as cycles, " + std::to_string(cycles.size())});
  for (std::size_t i = 0; i < std::min(cycles.size(), value.size()); ++i) {
    contact.friction_over_cycles.push_back({cycles[i], value[i]});
    contact.friction = std::max(contact.friction, value[i]);
  }
}

/// Whether a contact has no friction at all. A friction that is not a number, or below zero, has its own issue.
bool is_frictionless(const Entry& entry, const contact::ContactOptions& contact) {
  const auto& table = contact.friction_over_cycles;
  const bool zeros = !table.empty() && std::all_of(table.begin(), table.end(), [](auto& row) { return row[1] == 0.0; });
  return !entry.given("friction") || entry.maybe_number("friction") == 0.0 || zeros;
}

/// Imposed sliding: a number that each play of a step shares evenly, or parts that may follow histories.
base::Parts sliding_of(const Entry& entry, std::string_view key) {
  base::Parts parts;
  for (const auto& part : entry.parts(key)) parts.push_back({part.number("value"), part.text("history")});
  if (const auto number = entry.maybe_number(key)) parts.push_back({*number, ""});
  return parts;
}

/// Sliding in one of three directions.
void add_sliding(const Entry& entry, bool axisymmetric, contact::ContactOptions& contact, Issues& issues) {
  const std::array<const char*, 3> keys{"imposed_sliding_mm", "imposed_out_of_plane_mm", "imposed_turn_rad"};
  const char* first = nullptr;
  for (const char* key : keys) {
    if (!entry.given(key)) continue;
    if (first) issues.push_back({entry.key(key), entry.written(key), "cannot stand beside " + std::string(first)});
    if (!first) first = key;
  }
  contact.imposed = first != nullptr;
  contact.out_of_plane = entry.given(keys[1]) || entry.given(keys[2]);
  contact.imposed_sliding = sliding_of(entry, entry.given(keys[1]) ? keys[1] : keys[0]);
  contact.imposed_turn = sliding_of(entry, keys[2]);
  if (entry.given(keys[2]) && !axisymmetric)
    issues.push_back(
        {entry.key(keys[2]), entry.written(keys[2]), "needs analysis = \"axisymmetric\": it turns about the axis"});
}

contact::ContactOptions contact_of(const Entry& entry, bool axisymmetric, Issues& issues) {
  contact::ContactOptions contact;
  contact.name = entry.name();
  contact.secondary = entry.text("secondary");
  contact.primary = entry.texts("primary");
  add_friction(entry, contact, issues);
  contact.wear = wear_of(entry.at("wear"), issues);
  add_sliding(entry, axisymmetric, contact, issues);
  contact.implicit_wear = entry.flag("implicit");
  contact.dual = entry.text("dual") == "linear" ? contact::DualOrder::linear : contact::DualOrder::quadratic;
  contact.search_mm = entry.number("search_mm");
  contact.c_normal = entry.number("c_normal");
  contact.c_tangential = entry.number("c_tangential");
  return contact;
}

/// The bodies that a contact's or a bond's edges lie on. An edge named only in the geometry file may belong to any
/// body: none are named then, and its zones refine all.
std::vector<std::string> touching_bodies(const Entry& joint, const std::vector<cad::BoundaryOptions>& boundaries) {
  auto edges = joint.texts("primary");
  edges.insert(edges.begin(), joint.text("secondary"));
  std::vector<std::string> bodies;
  for (const auto& edge : edges) {
    const auto found = std::find_if(boundaries.begin(), boundaries.end(), [&](auto& b) { return b.name == edge; });
    if (found == boundaries.end()) return {};
    if (std::find(bodies.begin(), bodies.end(), found->body) == bodies.end()) bodies.push_back(found->body);
  }
  return bodies;
}

cad::FineZone zone_of(const Entry& place, const std::string& joint, const std::vector<std::string>& bodies) {
  cad::FineZone zone;
  zone.bodies = bodies;
  zone.contact = joint;
  zone.key = place.key();
  zone.centre_mm = place.pair("centre_mm").value_or(base::Vec2(0.0, 0.0));
  zone.half_width_mm = place.number("half_width_mm");
  zone.depth_mm = place.number("depth_mm");
  zone.size_mm = place.number("size_mm");
  zone.angle_deg = place.number("angle_deg");
  return zone;
}

}  // namespace

wear::Law wear_of(const Entry& wear, Issues& issues) {
  wear::Law law;
  if (!wear.is_table()) return law;
  const auto named = std::find_if(std::begin(laws), std::end(laws),
                                  [name = wear.text("law")](const auto& one) { return name == one.name; });
  if (named == std::end(laws)) return law;
  law.kind = named->kind;
  const auto secondary = named->key("secondary"), primary = named->key("primary");
  add_coefficient(wear, secondary, named->factor, law.secondary, law.secondary_formula);
  add_coefficient(wear, primary, named->factor, law.primary, law.primary_formula);
  for (const auto& other : laws)
    if (other.kind != named->kind)
      refuse(wear, {other.key("secondary"), other.key("primary")},
             base::formatted("belongs to law = \"%s\"; \"%s\" takes %s", other.name, named->name, named->unit), issues);
  if (!wear.given(secondary) && !wear.given(primary))
    issues.push_back({wear.key(), "", "needs " + secondary + ", " + primary + " or both"});
  if (law.kind == wear::LawKind::energy)
    law.threshold = wear.number("threshold_mJ_per_mm2");
  else
    refuse(wear, {"threshold_mJ_per_mm2"}, "belongs to the energy law", issues);
  add_factor(wear, "pressure_exponent", "pressure_ref_MPa", law.pressure_exponent, law.pressure_ref, issues);
  add_factor(wear, "speed_exponent", "speed_ref_mm_per_s", law.speed_exponent, law.speed_ref, issues);
  return law;
}

void check_friction(const Entry& contact, const wear::Law& law, bool frictionless, bool imposed, Issues& issues) {
  if (!law.wears() || !frictionless) return;
  const auto wear = contact.at("wear");
  if (law.kind == wear::LawKind::energy)
    issues.push_back({wear.key("law"), wear.written("law"),
                      "without friction no energy is dissipated; use friction > 0 or archard"});
  else if (!imposed)
    issues.push_back({wear.key("law"), wear.written("law"), "without friction needs imposed_sliding_mm"});
}

void check_sides(const Entry& entry, const std::string& place, Issues& issues) {
  const auto flag = [&](const std::string& rule) {
    issues.push_back({entry.key("primary"), entry.written("primary"), rule});
  };
  if (entry.empty_list("primary")) flag("must name at least one " + place);
  std::set<std::string> seen;
  for (const auto& name : entry.texts("primary")) {
    if (name == entry.text("secondary")) flag("\"" + name + "\" is also the secondary side");
    if (!seen.insert(name).second) flag("names \"" + name + "\" twice");
  }
}

std::vector<contact::ContactOptions> contacts_of(const Entry& root, Issues& issues) {
  std::vector<contact::ContactOptions> contacts;
  const bool axisymmetric = root.text("analysis") == "axisymmetric";
  for (const auto& entry : root.all("contact")) {
    contacts.push_back(contact_of(entry, axisymmetric, issues));
    check_sides(entry, "boundary", issues);
    const auto& contact = contacts.back();
    check_friction(entry, contact.wear, is_frictionless(entry, contact), contact.imposed, issues);
  }
  return contacts;
}

std::vector<contact::ContactOptions> bonds_of(const Entry& root, Issues& issues) {
  std::vector<contact::ContactOptions> bonds;
  const auto contacts = root.all("contact");
  for (const auto& entry : root.all("bond")) {
    contact::ContactOptions bond;
    bond.name = entry.name();
    bond.secondary = entry.text("secondary");
    bond.primary = entry.texts("primary");
    bond.bonded = true;
    check_sides(entry, "boundary", issues);
    if (std::any_of(contacts.begin(), contacts.end(), [&](const auto& contact) { return contact.name() == bond.name; }))
      issues.push_back({entry.key(), "", "a contact has this name, too"});
    bonds.push_back(std::move(bond));
  }
  return bonds;
}

void require_size(const Entry& root, const Entry& zone, Issues& issues) {
  if (!zone.given("size_mm") && !root.given("accuracy"))
    issues.push_back({zone.key("size_mm"), "", "missing; only a scene with accuracy may leave it out"});
}

std::vector<cad::FineZone> fine_zones_of(const Entry& root, const std::vector<cad::BoundaryOptions>& boundaries,
                                         Issues& issues) {
  std::vector<cad::FineZone> zones;
  auto joints = root.all("contact");
  for (auto& bond : root.all("bond")) joints.push_back(bond);
  for (const auto& joint : joints) {
    const auto bodies = touching_bodies(joint, boundaries);
    for (const auto& place : joint.parts("fine_zone")) {
      require_size(root, place, issues);
      zones.push_back(zone_of(place, joint.name(), bodies));
    }
  }
  return zones;
}

}  // namespace reye::scene
