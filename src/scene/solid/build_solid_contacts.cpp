#include <algorithm>
#include <cmath>

#include "scene/solid/build_solid.hpp"

namespace reye::scene {

namespace {

/// Sliding along directions and turns about axes, one entry per table.
void add_imposed(const Entry& entry, contact::SkinContactOptions& contact, Issues& issues) {
  const auto part_of = [](const Entry& part) { return base::Part{part.number("value"), part.text("history")}; };
  for (const auto& part : entry.parts("imposed_sliding_mm"))
    contact.sliding.push_back({.direction = direction_of(part, "direction", issues), .parts = {part_of(part)}});
  for (const auto& part : entry.parts("imposed_turn_rad"))
    contact.sliding.push_back({.point_mm = part.triple("point_mm").value_or(base::Vec3::Zero()),
                               .axis = direction_of(part, "axis", issues),
                               .parts = {part_of(part)}});
}

contact::SkinContactOptions skin_contact_of(const Entry& entry, Issues& issues) {
  contact::SkinContactOptions contact;
  contact.name = entry.name();
  contact.secondary = entry.text("secondary");
  contact.primary = entry.texts("primary");
  contact.friction = entry.number("friction");
  contact.dual = entry.text("dual") == "linear" ? mortar::SkinDual::linear : mortar::SkinDual::quadratic;
  contact.search_mm = entry.number("search_mm");
  add_imposed(entry, contact, issues);
  contact.wear = wear_of(entry.at("wear"), issues);
  contact.implicit_wear = entry.flag("implicit");
  check_friction(entry, contact.wear, contact.friction == 0.0, !contact.sliding.empty(), issues);
  return contact;
}

/// The bodies that a contact's faces lie on; none, which means all, where one of them is named in a geometry file only.
std::vector<std::string> bodies_in_touch(const Entry& contact, const std::vector<cad::FaceOptions>& faces) {
  auto names = contact.texts("primary");
  names.insert(names.begin(), contact.text("secondary"));
  std::vector<std::string> bodies;
  for (const auto& name : names) {
    const auto found = std::find_if(faces.begin(), faces.end(), [&](const auto& face) { return face.name == name; });
    if (found == faces.end()) return {};
    if (std::find(bodies.begin(), bodies.end(), found->body) == bodies.end()) bodies.push_back(found->body);
  }
  return bodies;
}

}  // namespace

std::vector<contact::SkinContactOptions> skin_contacts_of(const Entry& root, Issues& issues) {
  std::vector<contact::SkinContactOptions> contacts;
  for (const auto& entry : root.all("contact")) {
    contacts.push_back(skin_contact_of(entry, issues));
    check_sides(entry, "face", issues);
  }
  return contacts;
}

std::vector<cad::SolidFineZone> solid_zones_of(const Entry& root, const std::vector<cad::FaceOptions>& faces,
                                               Issues& issues) {
  std::vector<cad::SolidFineZone> zones;
  for (const auto& contact : root.all("contact"))
    for (const auto& place : contact.parts("fine_zone")) {
      exactly_one_of_solids(place, {"radius_mm", "half_widths_mm"}, {"half_width_mm", "depth_mm"}, issues);
      require_size(root, place, issues);
      zones.push_back({.bodies = bodies_in_touch(contact, faces),
                       .centre_mm = place.triple("centre_mm").value_or(base::Vec3::Zero()),
                       .radius_mm = place.number("radius_mm"),
                       .half_widths_mm = place.triple("half_widths_mm").value_or(base::Vec3::Zero()),
                       .size_mm = place.number("size_mm"),
                       .contact = contact.name(),
                       .key = place.key()});
    }
  return zones;
}

}  // namespace reye::scene
