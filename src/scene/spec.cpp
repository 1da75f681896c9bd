#include "scene/spec.hpp"

#include <algorithm>

namespace reye::scene {

namespace {

/// `{a,b}_c` as a_c, b_c.
std::vector<std::string> alternatives(const std::string& segment) {
  const auto open = segment.find('{'), close = segment.find('}');
  if (open == std::string::npos) return {segment};
  std::vector<std::string> names;
  for (const auto& part : split(std::string_view(segment).substr(open + 1, close - open - 1), ','))
    names.push_back(segment.substr(0, open) + part + segment.substr(close + 1));
  return names;
}

Spec& below(Spec& place, std::string name) {
  if (name == "*") {
    if (!place.any) place.any = std::make_unique<Spec>();
    return *place.any;
  }
  const bool list = name.ends_with("[]"), list_or_table = name.ends_with("[?]");
  name.resize(std::min(name.size(), name.find('[')));
  for (auto& [known, child] : place.named)
    if (known == name) {
      child->list_or_table = child->list_or_table || list_or_table;
      return *child;
    }
  place.named.emplace_back(name, std::make_unique<Spec>());
  place.named.back().second->list = list;
  place.named.back().second->list_or_table = list_or_table;
  return *place.named.back().second;
}

void insert(Spec& place, std::span<const std::string> segments, const Key& key) {
  if (segments.empty()) {
    place.key = &key;
    return;
  }
  for (const auto& name : alternatives(segments.front())) insert(below(place, name), segments.subspan(1), key);
}

}  // namespace

const Spec* Spec::find(std::string_view name) const {
  for (const auto& [known, child] : named)
    if (known == name) return child.get();
  return any.get();
}

Spec tree_of(std::span<const Key> table) {
  Spec tree;
  for (const auto& key : table) insert(tree, split(key.pattern, '.'), key);
  return tree;
}

const Spec& spec() {
  static const Spec root = tree_of(keys());
  return root;
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

}  // namespace reye::scene
