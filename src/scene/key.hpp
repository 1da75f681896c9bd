#pragma once
#include <limits>
#include <string_view>

/// One row of a table of keys: reading, errors and the reference text all come from these tables.
namespace reye::scene {

/// The type of a key's value. `pair`, `triple`, `box` and `solid_box` are lists of two, three, four and six numbers,
/// `numbers` one of at least one, `curve` a list of pairs of numbers whose first ones increase. `refused` is a key that
/// the grammar knows and this version does not build; its doc is the rule shown.
enum class Type {
  text,
  texts,
  number,
  formula,
  whole,
  flag,
  pair,
  triple,
  box,
  solid_box,
  numbers,
  curve,
  history,
  refused
};

/// The values a key may take; numbers always finite. Choices are separated by '|'.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;
  bool high_open = false;
  std::string_view choices = {};
  std::string_view why = {};  ///< of the choices, added to the rule where another one is written

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

inline constexpr double whole_limit = 1e9;  ///< of the size of whole numbers, which are kept as int

}  // namespace reye::scene
