#pragma once
#include <cstdint>
#include <string_view>

namespace reye::output {

/// FNV-1a checksum: it changes with any single altered byte, and almost certainly with several.
inline std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t hash = 14695981039346656037ull;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ull;
  return hash;
}

}  // namespace reye::output
