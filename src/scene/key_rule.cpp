#include "scene/key_rule.hpp"

#include "scene/nearest.hpp"

namespace reye::scene {

namespace {

/// The table of keys and the file, one level deeper; the rule that the name breaks, if any.
std::string step_down(const std::string& segment, const Spec*& place, const Node*& node) {
  const auto name = segment.substr(0, segment.find('['));
  const auto* below = place->find(name);
  if (!below) return unknown_rule(name, *place);
  const Node* found = node ? node->find(name) : nullptr;
  if (!found && below == place->any.get()) {
    std::vector<std::string> names;
    if (node)
      for (const auto& child : node->children) names.push_back(child.name);
    return unknown_name_rule(node && !node->name.empty() ? node->name : "table", name, names);
  }
  place = below;
  node = found;
  const bool listed = below->list || (below->list_or_table && node && node->kind == NodeKind::list);
  if (segment.size() == name.size()) return listed ? "takes an index, as in " + name + "[0]" : "";
  for (auto close = segment.find(']'); close != std::string::npos; close = segment.find(']', close + 1))
    node = node ? node->find(segment.substr(0, close + 1)) : nullptr;
  return node ? "" : "the scene has no " + segment;
}

}  // namespace

std::string key_rule(const std::string& key, const Node& root, const Spec& keys) {
  const Spec* place = &keys;
  const Node* node = &root;
  for (const auto& segment : split(key, '.'))
    if (const auto rule = step_down(segment, place, node); !rule.empty()) return rule;
  return {};
}

}  // namespace reye::scene
