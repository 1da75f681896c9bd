#include "scene/check.hpp"
#include "scene/read.hpp"

namespace reye::scene {

namespace {

std::string type_name(Type type) {
  switch (type) {
    case Type::text:
      return "text";
    case Type::texts:
      return "list of texts";
    case Type::number:
      return "number";
    case Type::whole:
      return "whole number";
    case Type::flag:
      return "true, false";
    case Type::pair:
      return "two numbers";
    case Type::triple:
      return "three numbers";
    case Type::box:
      return "four numbers";
    case Type::numbers:
      return "list of numbers";
    case Type::curve:
    case Type::history:
      return "list of pairs";
    case Type::refused:
      break;
  }
  return {};
}

/// The values of a key: its choices, or its type and range.
std::string takes(const Key& key) {
  if (!key.range.choices.empty()) return choices_of(key);
  const auto rule = rule_of(key);
  const std::string_view lie = "must lie ";
  const std::string_view be = "must be ";
  if (rule.empty()) return type_name(key.type);
  const auto range = rule.substr(rule.starts_with(be) ? be.size() : lie.size());
  return type_name(key.type) + ' ' + range;
}

}  // namespace

std::string reference() {
  std::string text = "| key | takes | unit | default | meaning |\n|---|---|---|---|---|\n";
  for (const auto& key : keys()) {
    if (key.type == Type::refused) continue;
    const std::string fallback(key.fallback);
    text += "| `" + std::string(key.pattern) + "` | " + takes(key) + " | " + std::string(key.unit) + " | " +
            (fallback.empty() || fallback == required ? fallback : '`' + fallback + '`') + " | " +
            std::string(key.doc) + " |\n";
  }
  return text;
}

}  // namespace reye::scene
