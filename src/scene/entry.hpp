#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/linalg.hpp"
#include "base/space.hpp"
#include "scene/document.hpp"
#include "scene/spec.hpp"
#include "wear/formula.hpp"

namespace reye::scene {

/// A place in the file together with its place in the table of keys: typed values with the table's defaults.
/// A value of the wrong type reads as its default; `check` has reported it.
class Entry {
 public:
  Entry(const Node* node, const Spec* spec) : node_(node), spec_(spec) {}

  bool given(std::string_view name) const { return node_ && node_->find(name); }
  bool is_table() const { return node_ && node_->kind == NodeKind::table; }
  const std::string& name() const { return node_->name; }
  std::string key(std::string_view name) const { return node_->key + '.' + std::string(name); }
  const std::string& key() const { return node_->key; }
  /// The value as written, for messages.
  std::string written(std::string_view name) const;

  /// A place below; empty when the file does not have it.
  Entry at(std::string_view name) const;
  /// Named tables or elements of a list of tables below, in the order of the file.
  std::vector<Entry> all(std::string_view name) const;

  /// A single table below, or the tables of a list; none where neither is given.
  std::vector<Entry> parts(std::string_view name) const;

  /// True when a list is given and empty.
  bool empty_list(std::string_view name) const;
  std::string text(std::string_view name) const;
  std::vector<std::string> texts(std::string_view name) const;
  double number(std::string_view name) const;
  /// A number written as a formula; empty where it is a number, and where the formula is broken, which `check` has
  /// reported.
  wear::Formula formula(std::string_view name) const;
  int whole(std::string_view name) const;
  bool flag(std::string_view name) const;
  std::optional<bool> maybe_flag(std::string_view name) const;
  std::optional<double> maybe_number(std::string_view name) const;
  std::optional<base::Vec2> pair(std::string_view name) const;
  std::optional<base::Vec3> triple(std::string_view name) const;
  std::vector<double> numbers(std::string_view name) const;
  /// A list of pairs.
  std::vector<std::array<double, 2>> curve(std::string_view name) const;
  /// The lists of pairs directly in this table, by name.
  std::map<std::string, std::vector<std::array<double, 2>>> histories() const;

 private:
  const Node* value(std::string_view name, NodeKind kind) const;
  std::string_view fallback(std::string_view name) const;

  const Node* node_;
  const Spec* spec_;
};

}  // namespace reye::scene
