#include <algorithm>

#include "scene/names.hpp"
#include "scene/solid/build_solid.hpp"
#include "scene/solid/validate_solid.hpp"

namespace reye::scene {

namespace {

using contact::SkinContactOptions;

void check_secondary_face(const Entry& entry, const SolidScene& scene, const std::string& face, Issues& issues) {
  const auto flag = [&](const std::string& rule) {
    issues.push_back({entry.key("secondary"), entry.written("secondary"), rule});
  };
  if (const auto* body = body_of_face(scene.geometry, face); body && body->rigid)
    flag("lies on the rigid body \"" + body->name + "\"; the secondary side must deform");
  for (const auto& support : scene.supports)
    if (!face.empty() && support.face == face && support.rigid)
      flag("is the rigid face of support \"" + support.name + "\"; the secondary side must deform");
}

void check_sides_apart(const Entry& entry, const SolidScene& scene, const SkinContactOptions& contact, Issues& issues) {
  const auto* secondary = body_of_face(scene.geometry, contact.secondary);
  for (const auto& face : contact.primary)
    if (secondary && face != contact.secondary && body_of_face(scene.geometry, face) == secondary)
      issues.push_back({entry.key("primary"), entry.written("primary"),
                        "\"" + face + "\" lies on the body of the secondary side, \"" + secondary->name + "\""});
}

/// A face of a plane of symmetry meets its mirror image: no other body can touch it.
void check_not_symmetric(const Entry& entry, const SolidScene& scene, const SkinContactOptions& contact,
                         Issues& issues) {
  if (holds(scene.symmetry, contact.secondary))
    issues.push_back({entry.key("secondary"), entry.written("secondary"), "is a face of symmetry"});
  for (const auto& face : contact.primary)
    if (holds(scene.symmetry, face))
      issues.push_back({entry.key("primary"), entry.written("primary"), "\"" + face + "\" is a face of symmetry"});
}

/// Multipliers of a face belong to one contact, and a pair of faces meets in one.
void check_against_earlier(const Entry& entry, const SkinContactOptions& mine, const SkinContactOptions& other,
                           Issues& issues) {
  if (mine.secondary.empty()) return;
  if (mine.secondary == other.secondary)
    issues.push_back(
        {entry.key("secondary"), entry.written("secondary"),
         "is already the secondary side of contact \"" + other.name + "\"; give one contact all its primary faces"});
  if (holds(mine.primary, other.secondary) && holds(other.primary, mine.secondary))
    issues.push_back(
        {entry.key("primary"), entry.written("primary"),
         "\"" + other.secondary + "\" meets \"" + mine.secondary + "\" in contact \"" + other.name + "\" already"});
}

}  // namespace

void validate_skin_contacts(const Entry& root, const SolidScene& scene, Issues& issues) {
  const auto entries = root.all("contact");
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto& contact = scene.contacts[i];
    check_secondary_face(entries[i], scene, contact.secondary, issues);
    check_sides_apart(entries[i], scene, contact, issues);
    check_not_symmetric(entries[i], scene, contact, issues);
    for (std::size_t j = 0; j < i; ++j) check_against_earlier(entries[i], contact, scene.contacts[j], issues);
  }
}

}  // namespace reye::scene
