#pragma once
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace reye::output {

/// A checksum in the way of FNV-1a, of the size and of words of eight bytes, the last one filled up with zeros: it
/// changes with any single altered word, and almost certainly with several.
inline std::uint64_t checksum(std::string_view bytes) {
  constexpr std::uint64_t prime = 1099511628211ull;
  std::uint64_t hash = (14695981039346656037ull ^ bytes.size()) * prime;
  for (std::size_t at = 0; at < bytes.size(); at += sizeof(std::uint64_t)) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, std::min(sizeof word, bytes.size() - at));
    hash = (hash ^ word) * prime;
    hash ^= hash >> 32;  // else the highest bits of two words, the signs of numbers, would cancel
  }
  return hash;
}

}  // namespace reye::output
