#include "scene/check.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "scene/nearest.hpp"
#include "wear/formula.hpp"

namespace reye::scene {

namespace {

/// What the reference calls a type, and what a value must be that is not of it.
struct TypeWords {
  Type type;
  const char* name;
  const char* rule;
};

constexpr TypeWords type_words[] = {
    {Type::text, "text", "must be a text in quotes"},
    {Type::texts, "list of texts", "must be a list of texts in quotes"},
    {Type::number, "number", "must be a number"},
    {Type::formula, "number or formula", "must be a number, or a formula in quotes"},
    {Type::whole, "whole number", "must be a whole number"},
    {Type::flag, "true, false", "must be true or false"},
    {Type::pair, "two numbers", "must be a list of two numbers"},
    {Type::triple, "three numbers", "must be a list of three numbers"},
    {Type::box, "four numbers", "must be a list of four numbers"},
    {Type::solid_box, "six numbers", "must be a list of six numbers, [x_min, y_min, z_min, x_max, y_max, z_max]"},
    {Type::numbers, "list of numbers", "must be a list of numbers"},
    {Type::curve, "list of pairs", "must be a list of at least two pairs of numbers"},
    {Type::history, "list of pairs", "must be a list of at least two pairs [progress, factor]"},
    {Type::refused, "", ""},
};

const TypeWords& words_of(Type type) {
  return *std::find_if(std::begin(type_words), std::end(type_words), [&](const auto& w) { return w.type == type; });
}

bool numbers(const Node& list, std::size_t count) {
  return list.kind == NodeKind::list && list.children.size() == count &&
         std::all_of(list.children.begin(), list.children.end(), [](const Node& n) { return n.is_number(); });
}

bool has_type(const Node& node, Type type) {
  const auto& parts = node.children;
  switch (type) {
    case Type::text:
      return node.kind == NodeKind::text;
    case Type::number:
      return node.is_number();
    case Type::formula:
      return node.is_number() || node.kind == NodeKind::text;
    case Type::whole:
      return node.is_number() && (std::rint(node.number) == node.number || !std::isfinite(node.number));
    case Type::flag:
      return node.kind == NodeKind::flag;
    case Type::pair:
      return numbers(node, 2);
    case Type::triple:
      return numbers(node, 3);
    case Type::box:
      return numbers(node, 4);
    case Type::solid_box:
      return numbers(node, 6);
    case Type::texts:
      return node.kind == NodeKind::list &&
             std::all_of(parts.begin(), parts.end(), [](const Node& n) { return n.kind == NodeKind::text; });
    case Type::numbers:
      return !parts.empty() && numbers(node, parts.size());
    case Type::curve:
    case Type::history:
      return node.kind == NodeKind::list && parts.size() >= 2 &&
             std::all_of(parts.begin(), parts.end(), [](const Node& n) { return numbers(n, 2); });
    case Type::refused:
      break;
  }
  return false;
}

bool all_finite(const Node& node) {
  return (!node.is_number() || std::isfinite(node.number)) &&
         std::all_of(node.children.begin(), node.children.end(), all_finite);
}

bool in_range(const Node& node, const Range& range) {
  return (!node.is_number() || range.holds(node.number)) &&
         std::all_of(node.children.begin(), node.children.end(), [&](const Node& n) { return in_range(n, range); });
}

bool listed(std::string_view choices, const std::string& value) {
  const auto names = split(choices, '|');
  return std::find(names.begin(), names.end(), value) != names.end();
}

std::string names_in(const Spec& place) {
  std::string names;
  for (const auto& [name, child] : place.named)
    if (!child->key || child->key->type != Type::refused) names += (names.empty() ? "" : ", ") + name;
  return names;
}

/// The addition to a message that a motion may also be a table, or a list of them.
std::string or_a_table(const Spec& place) {
  const auto names = names_in(place);
  return names.empty() ? "" : ", or a table of " + names + (place.list_or_table ? ", or a list of such tables" : "");
}

std::string history_rule(const Node& history) {
  double last = -1.0;
  for (const auto& point : history.children) {
    const double progress = point.children[0].number;
    if (progress <= last) return "progress must increase strictly from 0 to 1";
    last = progress;
  }
  const bool whole = history.children.front().children[0].number == 0.0 && last == 1.0;
  return whole ? "" : "progress must increase strictly from 0 to 1";
}

std::string curve_rule(const Node& curve) {
  for (std::size_t i = 1; i < curve.children.size(); ++i)
    if (curve.children[i].children[0].number <= curve.children[i - 1].children[0].number)
      return "the first number of each pair must increase strictly";
  return {};
}

std::string choice_rule(const Node& node, const Spec& place) {
  const auto& key = *place.key;
  const auto value = key.type == Type::whole ? shown(node.number) : node.text;
  if (listed(key.range.choices, value)) return {};
  const std::string why(key.range.why);
  return rule_of(key) + or_a_table(place) + (why.empty() ? "" : ": " + why);
}

/// The rule that a plain value breaks; empty when it is fine.
std::string broken_rule(const Node& node, const Spec& place) {
  const auto& key = *place.key;
  if (key.type == Type::refused) return std::string(key.doc);
  if (!has_type(node, key.type)) return words_of(key.type).rule + or_a_table(place);
  if ((key.type == Type::curve || key.type == Type::history) && node.children.size() > most_pairs)
    return "has " + std::to_string(node.children.size()) + " pairs; 10000 are the most";
  if (!all_finite(node)) return "must be finite";
  if (key.type == Type::text && node.text.empty()) return "must not be empty";
  if (key.type == Type::formula && node.kind == NodeKind::text)
    if (const auto why = wear::broken_formula(node.text); !why.empty()) return "is no usable formula: " + why;
  if (!key.range.choices.empty()) return choice_rule(node, place);
  if (key.type == Type::history) return history_rule(node);
  if (!in_range(node, key.range)) return rule_of(key);
  if (key.type == Type::curve) return curve_rule(node);
  if (key.type == Type::whole && std::abs(node.number) > whole_limit) return "must be at most 1e9";
  return {};
}

bool good_name(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
  });
}

void check_table(const Node& table, const Spec& place, Issues& issues) {
  for (const auto& child : table.children) {
    const auto* known = place.find(child.name);
    if (!known)
      issues.push_back({child.key, child.written, unknown_rule(child.name, place)});
    else if (known == place.any.get() && !good_name(child.name))
      issues.push_back({child.key, "", "a name may hold letters, digits, '-' and '_' only"});
    else
      check(child, *known, issues);
  }
  for (const auto& [name, child] : place.named)
    if (child->key && child->key->fallback == required && !table.find(name))
      issues.push_back({table.key.empty() ? name : table.key + '.' + name, "", "missing"});
}

bool lists_tables(const Node& node) {
  return node.kind == NodeKind::list && !node.children.empty() &&
         std::all_of(node.children.begin(), node.children.end(),
                     [](const Node& n) { return n.kind == NodeKind::table; });
}

void check_list(const Node& list, const Spec& place, Issues& issues) {
  if (!lists_tables(list)) {
    issues.push_back({list.key, list.written, "must be a list of tables, each headed [[" + list.key + "]]"});
    return;
  }
  for (const auto& element : list.children) check_table(element, place, issues);
}

}  // namespace

void check(const Node& node, const Spec& place, Issues& issues) {
  if (place.list) {
    check_list(node, place, issues);
  } else if (place.list_or_table && lists_tables(node)) {
    check_list(node, place, issues);
  } else if (node.kind == NodeKind::table && place.is_table()) {
    check_table(node, place, issues);
  } else if (place.key) {
    const auto rule = broken_rule(node, place);
    if (!rule.empty()) issues.push_back({node.key, node.written, rule});
  } else {
    issues.push_back({node.key, node.written,
                      place.list_or_table ? "must be a table of " + names_in(place) + ", or a list of such tables"
                                          : "must be a table"});
  }
}

std::string choices_of(const Key& key) {
  const auto names = split(key.range.choices, '|');
  const std::string quote = key.type == Type::text ? "\"" : "";
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
    text += quote + names[i] + quote;
  }
  return text;
}

std::string type_name(Type type) { return words_of(type).name; }

std::string rule_of(const Key& key) {
  const auto& range = key.range;
  if (!range.choices.empty()) return "must be " + choices_of(key);
  const bool below = std::isfinite(range.high), above = std::isfinite(range.low);
  if (below && above)
    return std::string("must lie in ") + (range.low_open ? "(" : "[") + shown(range.low) + ", " + shown(range.high) +
           (range.high_open ? ")" : "]");
  if (above) return (range.low_open ? "must be > " : "must be >= ") + shown(range.low);
  return {};
}

std::string takes(const Key& key) {
  if (!key.range.choices.empty()) return choices_of(key);
  const auto rule = rule_of(key);
  const std::string_view lie = "must lie ";
  const std::string_view be = "must be ";
  if (rule.empty()) return type_name(key.type);
  const auto range = rule.substr(rule.starts_with(be) ? be.size() : lie.size());
  return type_name(key.type) + ' ' + range;
}

std::string shown(double number) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, number).ptr;
  return {buffer, end};
}

}  // namespace reye::scene
