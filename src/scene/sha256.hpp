#pragma once
#include <string>

namespace reye::scene {

/// SHA-256 of bytes as 64 hexadecimal digits (FIPS 180-4).
std::string sha256(const std::string& bytes);

}  // namespace reye::scene
