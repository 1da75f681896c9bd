#pragma once
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The one table of keys of a scene: reading, errors and the reference text all come from it.
namespace reye::scene {

/// The type of a key's value. `pair`, `triple` and `box` are lists of two, three and four numbers, `numbers` one of at
/// least one, `curve` a list of pairs of numbers whose first ones increase. `refused` is a key that the grammar knows
/// and this version does not build; its doc is the rule shown.
enum class Type { text, texts, number, whole, flag, pair, triple, box, numbers, curve, history, refused };

/// The values a key may take; numbers always finite. Choices are separated by '|'.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;
  bool high_open = false;
  std::string_view choices = {};

  bool holds(double value) const;
};

/// One key. Pattern: names joined by '.', where `*` is a name the user gives, `{a,b}` is one of several
/// names, `step[]` is an element of a list of tables, and `fine_zone[?]` one of those or a single table.
struct Key {
  std::string_view pattern;
  Type type;
  std::string_view unit;
  std::string_view fallback;  ///< default as written in a scene; `required`; empty: optional without default
  Range range;
  std::string_view doc;
};

inline constexpr std::string_view required = "required";

std::span<const Key> keys();

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

/// The tree of `keys()`, built once.
const Spec& spec();

/// Parts of a text between separators.
std::vector<std::string> split(std::string_view text, char separator);

}  // namespace reye::scene
