#pragma once
#include <string>

/// What tests ask of a text.
namespace reye::support {

inline bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace reye::support
