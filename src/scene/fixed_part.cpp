#include "scene/fixed_part.hpp"

#include <algorithm>

namespace reye::scene {

std::string cycles_key_of(const Node& root) {
  const auto* steps = root.find("step");
  if (!steps || steps->children.empty()) return {};
  const auto& last = steps->children.back();
  const auto* given = last.find("name");
  const auto name = given ? given->text : "step " + std::to_string(steps->children.size());
  const auto* spectrum = root.find("spectrum");
  const auto* repeated = spectrum ? spectrum->find("steps") : nullptr;
  if (repeated &&
      std::any_of(repeated->children.begin(), repeated->children.end(), [&](const Node& n) { return n.text == name; }))
    return {};
  return last.key + ".cycles";
}

bool is_branch(const Node& node) {
  return node.kind == NodeKind::table ||
         (node.kind == NodeKind::list && !node.children.empty() && node.children.front().kind == NodeKind::table);
}

std::string value_of(const Node& leaf, const std::string& text) {
  return text.substr(leaf.begin, leaf.end - leaf.begin);
}

namespace {

void add_fixed(const Node& node, const std::string& text, const std::string& cycles_key, std::string& fixed) {
  for (const auto& child : node.children) {
    if (child.key == "limit") continue;
    fixed += child.key;
    if (is_branch(child)) {
      fixed += '\n';
      add_fixed(child, text, cycles_key, fixed);
    } else {
      const bool counts = child.key == cycles_key && child.is_number() && child.number > 0.0;
      fixed += " = " + (counts ? "so many" : value_of(child, text)) + '\n';
    }
  }
}

}  // namespace

std::string fixed_part(const Node& document, const std::string& text) {
  std::string fixed;
  add_fixed(document, text, cycles_key_of(document), fixed);
  return fixed;
}

}  // namespace reye::scene
