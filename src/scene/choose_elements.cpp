#include "scene/choose_elements.hpp"

#include <algorithm>

#include "scene/force_driven.hpp"

namespace reye::scene {

namespace {

/// Whether a body may have an edge: one that no [boundary] names may lie on any.
bool may_have(const Scene& scene, const cad::BodyOptions& body, const std::string& edge) {
  const auto& boundaries = scene.geometry.boundaries;
  const auto found = std::find_if(boundaries.begin(), boundaries.end(), [&](const auto& b) { return b.name == edge; });
  if (found != boundaries.end()) return found->body == body.name;
  return edge.find('.') == std::string::npos || edge.starts_with(body.name + '.');
}

bool is_given(const Scene& scene, const std::string& key) { return scene.lines.contains(key); }

bool order_is_given(const Scene& scene, const std::string& body) { return is_given(scene, "body." + body + ".order"); }

ElementChoice choice_of(const Scene& scene, std::size_t c) {
  const auto& contact = scene.contacts[c];
  ElementChoice choice{c, {}, false};
  bool free = true, second_order = false;
  for (const auto& body : scene.geometry.bodies) {
    const bool secondary = may_have(scene, body, contact.secondary);
    const auto here = [&](const std::string& edge) { return may_have(scene, body, edge); };
    if (!secondary && std::none_of(contact.primary.begin(), contact.primary.end(), here)) continue;
    free = free && !order_is_given(scene, body.name);
    if (!body.rigid) choice.second_order.push_back(body.name);
    second_order = second_order || (secondary && body.mesh.order == 2);
  }
  if (!free) choice.second_order.clear();
  choice.linear = (free || second_order) && !is_given(scene, "contact." + contact.name + ".dual");
  return choice;
}

}  // namespace

std::vector<ElementChoice> element_choices(const Scene& scene) {
  std::vector<ElementChoice> choices;
  if (!only_forces_drive(scene)) return choices;
  for (std::size_t c = 0; c < scene.contacts.size(); ++c) {
    const auto& contact = scene.contacts[c];
    if (contact.friction == 0.0 || contact.imposed || !contact.wear.wears()) continue;
    auto choice = choice_of(scene, c);
    if (choice.linear || !choice.second_order.empty()) choices.push_back(std::move(choice));
  }
  return choices;
}

void choose_elements(Scene& scene) {
  for (const auto& choice : element_choices(scene)) {
    if (choice.linear) scene.contacts[choice.contact].dual = contact::DualOrder::linear;
    for (const auto& name : choice.second_order)
      for (auto& body : scene.geometry.bodies)
        if (body.name == name) body.mesh.order = 2;
  }
}

std::string in_words(const Scene& scene, const ElementChoice& choice) {
  std::string taken;
  for (const auto& name : choice.second_order) taken += (taken.empty() ? "second order for " : ", ") + name;
  if (choice.linear) taken += std::string(taken.empty() ? "" : " and ") + "linear multipliers";
  return "contact " + scene.contacts[choice.contact].name +
         ": only forces drive it, so that it slips in part at most: " + taken +
         ", since elements of first order let the edge of a stick zone recede as it wears";
}

}  // namespace reye::scene
