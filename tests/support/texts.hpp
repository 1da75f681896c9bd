#pragma once
#include <string>

/// What tests ask of a text.
namespace reye::support {

inline bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A log without the line that says how long the report took, the only one that differs from run to run.
inline std::string without_report_time(std::string log) {
  const auto from = log.find("report made in ");
  if (from != std::string::npos) log.erase(from, log.find('\n', from) + 1 - from);
  return log;
}

}  // namespace reye::support
