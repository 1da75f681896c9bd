#pragma once
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "scene/document.hpp"
#include "scene/keys.hpp"
#include "scene/spec.hpp"

/// Each key by itself against the table: known, of its type, in its range, not missing.
namespace reye::scene {

using Issues = std::vector<base::Issue>;

inline constexpr std::size_t most_pairs = 10'000;  ///< of a history, where each corner ends an increment, or a curve

void check(const Node& root, const Spec& spec, Issues& issues);

/// "list of numbers", as the reference calls a type.
std::string type_name(Type type);

/// The rule of a range in words, e.g. `must lie in (-1, 0.5)`; empty when every number is allowed.
std::string rule_of(const Key& key);

/// `"a", "b" or "c"` from `a|b|c`; without quotes for numbers.
std::string choices_of(const Key& key);

/// The values of a key, as the reference calls them: its choices, or its type and range.
std::string takes(const Key& key);

/// Shortest number that reads back the same.
std::string shown(double number);

}  // namespace reye::scene
