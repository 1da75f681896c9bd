#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/keys.hpp"

namespace reye::scene {

/// The table of keys as a tree: the values that a place of the scene may hold.
struct Spec {
  const Key* key = nullptr;    ///< set when a plain value may stand here
  bool list = false;           ///< a list of tables: each element takes the names below
  bool list_or_table = false;  ///< a list of tables, where a single table counts as a list of one
  std::vector<std::pair<std::string, std::unique_ptr<Spec>>> named;
  std::unique_ptr<Spec> any;  ///< under a name the user gives

  const Spec* find(std::string_view name) const;
  bool is_table() const { return any || !named.empty(); }
};

/// The tree of a table, which must outlive it.
Spec tree_of(std::span<const Key> table);

/// The tree of `keys()`, built once.
const Spec& spec();

/// Parts of a text between separators.
std::vector<std::string> split(std::string_view text, char separator);

}  // namespace reye::scene
