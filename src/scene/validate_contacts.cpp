#include <algorithm>

#include "scene/validate.hpp"

namespace reye::scene {

namespace {

/// The body of an edge that a [boundary] names.
const cad::BodyOptions* body_of(const Scene& scene, const std::string& edge) {
  const auto& boundaries = scene.geometry.boundaries;
  const auto boundary = std::find_if(boundaries.begin(), boundaries.end(), [&](auto& b) { return b.name == edge; });
  if (boundary == boundaries.end()) return nullptr;
  const auto& bodies = scene.geometry.bodies;
  const auto body = std::find_if(bodies.begin(), bodies.end(), [&](auto& b) { return b.name == boundary->body; });
  return body == bodies.end() ? nullptr : &*body;
}

void check_secondary(const Entry& entry, const Scene& scene, const std::string& edge, Issues& issues) {
  const auto flag = [&](const std::string& rule) {
    issues.push_back({entry.key("secondary"), entry.written("secondary"), rule});
  };
  if (const auto* body = body_of(scene, edge); body && body->rigid)
    flag("lies on the rigid body \"" + body->name + "\"; the secondary side must deform");
  for (const auto& support : scene.supports)
    if (!edge.empty() && support.edge == edge && support.rigid)
      flag("is the rigid edge of support \"" + support.name + "\"; the secondary side must deform");
}

void check_bodies(const Entry& entry, const Scene& scene, const contact::ContactOptions& contact, Issues& issues) {
  const auto* secondary = body_of(scene, contact.secondary);
  if (!secondary) return;
  for (const auto& edge : contact.primary)
    if (edge != contact.secondary && body_of(scene, edge) == secondary)
      issues.push_back({entry.key("primary"), entry.written("primary"),
                        "\"" + edge + "\" lies on the body of the secondary side, \"" + secondary->name + "\""});
}

/// A bonded edge carries traction everywhere, so it is secondary once. Contacts may share a secondary edge, each
/// against other edges.
void check_shared_secondary(const std::vector<Entry>& entries, const std::vector<contact::ContactOptions>& joints,
                            Issues& issues) {
  const auto kind = [&](std::size_t i) { return std::string(joints[i].bonded ? "bond" : "contact"); };
  const auto named = [&](std::size_t i) { return kind(i) + " \"" + joints[i].name + '"'; };
  for (std::size_t i = 0; i < entries.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (joints[i].secondary.empty() || joints[i].secondary != joints[j].secondary) continue;
      const auto& mine = joints[i].primary;
      const auto both =
          std::find_first_of(mine.begin(), mine.end(), joints[j].primary.begin(), joints[j].primary.end());
      if (joints[i].bonded && joints[j].bonded)
        issues.push_back(
            {entries[i].key("secondary"), entries[i].written("secondary"),
             "is already the secondary side of " + named(j) + "; give one bond all its primary boundaries"});
      else if (joints[i].bonded || joints[j].bonded)
        issues.push_back(
            {entries[i].key("secondary"), entries[i].written("secondary"),
             "is already the secondary side of " + named(j) + ", and a bonded boundary can have no other contact"});
      else if (both != mine.end())
        issues.push_back({entries[i].key("primary"), entries[i].written("primary"),
                          '"' + *both + "\" meets \"" + joints[i].secondary + "\" in " + named(j) + " already"});
      else
        continue;
      break;
    }
}

/// Contacts, then bonds.
std::vector<contact::ContactOptions> joints_of(const Scene& scene) {
  auto joints = scene.contacts;
  joints.insert(joints.end(), scene.bonds.begin(), scene.bonds.end());
  return joints;
}

/// Multipliers are eliminated contact by contact, a primary side after the contact in which it is secondary.
void check_ring(const std::vector<Entry>& entries, const Scene& scene, Issues& issues) {
  auto left = joints_of(scene);
  const auto waits = [&](const contact::ContactOptions& contact) {
    return std::any_of(left.begin(), left.end(), [&](const auto& other) {
      return other.name != contact.name &&
             std::find(contact.primary.begin(), contact.primary.end(), other.secondary) != contact.primary.end();
    });
  };
  for (auto free = std::find_if_not(left.begin(), left.end(), waits); free != left.end();
       free = std::find_if_not(left.begin(), left.end(), waits))
    left.erase(free);
  if (left.empty()) return;
  std::string names;
  for (const auto& contact : left) names += (names.empty() ? "" : ", ") + contact.name;
  const auto first = std::find_if(entries.begin(), entries.end(), [&](auto& e) { return e.name() == left[0].name; });
  issues.push_back({first->key(), "", "secondary and primary sides form a ring: " + names});
}

}  // namespace

void validate_contacts(const Entry& root, const Scene& scene, Issues& issues) {
  auto entries = root.all("contact");
  for (auto& bond : root.all("bond")) entries.push_back(bond);
  const auto joints = joints_of(scene);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    check_secondary(entries[i], scene, joints[i].secondary, issues);
    check_bodies(entries[i], scene, joints[i], issues);
  }
  const auto before = issues.size();
  check_shared_secondary(entries, joints, issues);
  if (issues.size() == before) check_ring(entries, scene, issues);
}

}  // namespace reye::scene
