#include "scene/check.hpp"
#include "scene/read.hpp"

namespace reye::scene {

namespace {

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

std::string reference() { return reference(keys()); }

std::string reference(std::span<const Key> table) {
  std::string text = "| key | takes | unit | default | meaning |\n|---|---|---|---|---|\n";
  for (const auto& key : table) {
    if (key.type == Type::refused) continue;
    const std::string fallback(key.fallback);
    text += "| `" + std::string(key.pattern) + "` | " + takes(key) + " | " + std::string(key.unit) + " | " +
            (fallback.empty() || fallback == required ? fallback : '`' + fallback + '`') + " | " +
            std::string(key.doc) + " |\n";
  }
  return text;
}

}  // namespace reye::scene
