#pragma once
#include <string>

/// What tests ask of a text.
namespace reye::support {

inline bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// How often a text has a part.
inline std::size_t times(const std::string& part, const std::string& text) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// A log without the line that says how long the report took, the only one that differs from run to run.
inline std::string without_report_time(std::string log) {
  const auto from = log.find("report made in ");
  if (from != std::string::npos) log.erase(from, log.find('\n', from) + 1 - from);
  return log;
}

}  // namespace reye::support
