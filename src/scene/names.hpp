#pragma once
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "scene/check.hpp"
#include "scene/entry.hpp"

/// Names that one table of a scene gives and others refer to.
namespace reye::scene {

using NameList = std::vector<std::string>;

template <class Items>
NameList names_of(const Items& items) {
  NameList names;
  for (const auto& item : items) names.push_back(item.name);
  return names;
}

template <class Value>
NameList keys_of(const std::map<std::string, Value>& items) {
  NameList names;
  for (const auto& [name, value] : items) names.push_back(name);
  return names;
}

inline bool holds(const NameList& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The name written under `key`, if any, must be one of `names`.
void refer(const Entry& entry, std::string_view key, const std::string& what, const NameList& names, Issues& issues);

/// Histories that steps play exist, none is played twice at a time, no two steps share a name, and there is a step.
void check_plays(const Entry& root, const NameList& histories, Issues& issues);

/// The rule against a history that ends a cycle elsewhere than it began it; empty where it does not.
std::string open_cycle_rule(const std::string& name, const std::vector<std::array<double, 2>>& corners, bool measured);

}  // namespace reye::scene
