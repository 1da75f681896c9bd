#include "scene/check.hpp"
#include "scene/read.hpp"

namespace reye::scene {

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
