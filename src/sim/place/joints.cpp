#include "sim/place/joints.hpp"

#include <algorithm>

#include "base/formatted.hpp"

namespace reye::sim {

namespace {

using base::Issue;

double modulus(const Problem& p, int body) {
  if (p.rigid[body]) return 0.0;
  return std::visit([](const auto& m) { return m.E_MPa; }, p.inputs[body].material);
}

/// Stiffness scale of a pair: the smallest modulus of its deformable sides.
double pair_modulus(const Problem& p, const contact::BoundaryRef& secondary,
                    const std::vector<contact::BoundaryRef>& primary) {
  double softest = modulus(p, secondary.body);
  for (const auto& ref : primary)
    if (!p.rigid[ref.body]) softest = std::min(softest, modulus(p, ref.body));
  return softest;
}

/// The sides of a contact or a bond, whose key in the scene is given.
void check_sides(const Problem& p, const PlacedContact& contact, const std::string& key, std::vector<Issue>& issues) {
  const auto name = [&](int b) { return base::quoted(p.scene.geometry.bodies[b].name); };
  if (p.rigid[contact.secondary.body])
    issues.push_back({key + ".secondary", base::quoted(contact.options.secondary),
                      "lies on the rigid body " + name(contact.secondary.body) +
                          "; the secondary side must belong to a deformable body"});
  for (const auto& ref : contact.primary) {
    if (ref.body == contact.secondary.body)
      issues.push_back({key + ".primary", base::quoted(ref.boundary),
                        "lies on the same body as the secondary side (" + name(ref.body) + ")"});
    if (p.rigid[ref.body] && contact.options.wear.primary > 0.0)
      issues.push_back(
          {key + ".wear", "", "the primary side lies on the rigid body " + name(ref.body) + ", which cannot wear"});
  }
}

/// Retains the nodes of both sides when bodies are condensed.
void retain_sides(Problem& p, const PlacedContact& joint) {
  const auto retain = [&](const contact::BoundaryRef& ref) {
    auto& list = p.inputs[ref.body].contact_boundaries;
    if (std::find(list.begin(), list.end(), ref.boundary) == list.end()) list.push_back(ref.boundary);
  };
  retain(joint.secondary);
  for (const auto& ref : joint.primary) retain(ref);
}

}  // namespace

void place_joints(Problem& p, const std::string& kind, const std::vector<contact::ContactOptions>& named,
                  Resolver& resolve, std::vector<PlacedContact>& joints) {
  for (const auto& options : named) {
    const std::string key = kind + "." + options.name;
    PlacedContact placed;
    placed.options = options;
    placed.secondary = resolve.boundary(options.secondary, key + ".secondary");
    for (const auto& name : options.primary) placed.primary.push_back(resolve.boundary(name, key + ".primary"));
    const bool found = placed.secondary.body >= 0 && std::all_of(placed.primary.begin(), placed.primary.end(),
                                                                 [](const auto& r) { return r.body >= 0; });
    if (!found) continue;
    check_sides(p, placed, key, resolve.issues);
    placed.modulus_MPa = pair_modulus(p, placed.secondary, placed.primary);
    retain_sides(p, placed);
    joints.push_back(std::move(placed));
  }
}

}  // namespace reye::sim
