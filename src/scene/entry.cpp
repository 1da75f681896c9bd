#include "scene/entry.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>

namespace reye::scene {

const Node* Entry::value(std::string_view name, NodeKind kind) const {
  assert(spec_->find(name) && "only keys of the table are read");
  const auto* found = node_ ? node_->find(name) : nullptr;
  if (!found) return nullptr;
  const bool fits = kind == NodeKind::number ? found->is_number() : found->kind == kind;
  return fits ? found : nullptr;
}

std::string_view Entry::fallback(std::string_view name) const {
  const auto* key = spec_->find(name)->key;
  return key && key->fallback != required ? key->fallback : std::string_view{};
}

std::string Entry::written(std::string_view name) const {
  const auto* found = node_ ? node_->find(name) : nullptr;
  return found ? found->written : "";
}

Entry Entry::at(std::string_view name) const { return {node_ ? node_->find(name) : nullptr, spec_->find(name)}; }

std::vector<Entry> Entry::all(std::string_view name) const {
  const auto* place = spec_->find(name);
  const auto* found = node_ ? node_->find(name) : nullptr;
  std::vector<Entry> entries;
  if (!found) return entries;
  for (const auto& child : found->children)
    if (child.kind == NodeKind::table) entries.emplace_back(&child, place->list ? place : place->any.get());
  return entries;
}

std::vector<Entry> Entry::parts(std::string_view name) const {
  const auto* spec = spec_->find(name);
  const auto* found = node_ ? node_->find(name) : nullptr;
  if (!found) return {};
  if (found->kind == NodeKind::table) return {{found, spec}};
  std::vector<Entry> entries;
  for (const auto& child : found->children)
    if (child.kind == NodeKind::table) entries.emplace_back(&child, spec);
  return entries;
}

bool Entry::empty_list(std::string_view name) const {
  const auto* found = value(name, NodeKind::list);
  return found && found->children.empty();
}

std::string Entry::text(std::string_view name) const {
  const auto* found = value(name, NodeKind::text);
  return found ? found->text : std::string(fallback(name));
}

std::vector<std::string> Entry::texts(std::string_view name) const {
  std::vector<std::string> list;
  if (const auto* found = value(name, NodeKind::list))
    for (const auto& child : found->children)
      if (child.kind == NodeKind::text) list.push_back(child.text);
  return list;
}

double Entry::number(std::string_view name) const {
  const auto* found = value(name, NodeKind::number);
  if (found && std::isfinite(found->number)) return found->number;
  return std::strtod(std::string(fallback(name)).c_str(), nullptr);
}

wear::Formula Entry::formula(std::string_view name) const {
  const auto* found = value(name, NodeKind::text);
  return found && wear::broken_formula(found->text).empty() ? wear::Formula(found->text) : wear::Formula();
}

int Entry::whole(std::string_view name) const {
  const auto* key = spec_->find(name)->key;  // a value outside its range has been reported and must not be used
  const double low = key ? std::max(key->range.low, -whole_limit) : -whole_limit;
  const double high = key ? std::min(key->range.high, whole_limit) : whole_limit;
  return static_cast<int>(std::clamp(number(name), low, high));
}

bool Entry::flag(std::string_view name) const {
  const auto* found = value(name, NodeKind::flag);
  return found ? found->flag : fallback(name) == "true";
}

std::optional<bool> Entry::maybe_flag(std::string_view name) const {
  const auto* found = value(name, NodeKind::flag);
  return found ? std::optional(found->flag) : std::nullopt;
}

std::optional<double> Entry::maybe_number(std::string_view name) const {
  const auto* found = value(name, NodeKind::number);
  return found && std::isfinite(found->number) ? std::optional(found->number) : std::nullopt;
}

std::vector<double> Entry::numbers(std::string_view name) const {
  std::vector<double> list;
  if (const auto* found = value(name, NodeKind::list))
    for (const auto& child : found->children) list.push_back(child.number);
  return list;
}

namespace {

std::vector<std::array<double, 2>> pairs_of(const Node& list) {
  std::vector<std::array<double, 2>> points;
  for (const auto& point : list.children)
    if (point.children.size() == 2) points.push_back({point.children[0].number, point.children[1].number});
  return points;
}

}  // namespace

std::vector<std::array<double, 2>> Entry::curve(std::string_view name) const {
  const auto* found = value(name, NodeKind::list);
  return found ? pairs_of(*found) : std::vector<std::array<double, 2>>{};
}

std::map<std::string, std::vector<std::array<double, 2>>> Entry::histories() const {
  std::map<std::string, std::vector<std::array<double, 2>>> tables;
  if (!node_) return tables;
  for (const auto& child : node_->children) tables[child.name] = pairs_of(child);
  return tables;
}

std::optional<base::Vec3> Entry::triple(std::string_view name) const {
  const auto list = numbers(name);
  return list.size() == 3 ? std::optional(base::Vec3(list[0], list[1], list[2])) : std::nullopt;
}

std::optional<base::Vec2> Entry::pair(std::string_view name) const {
  const auto list = numbers(name);
  return list.size() == 2 ? std::optional(base::Vec2(list[0], list[1])) : std::nullopt;
}

}  // namespace reye::scene
