#include "sim/problem/warnings.hpp"

#include <algorithm>

namespace reye::sim {

bool warn(std::vector<Warning>& list, Warning warning) {
  const auto found = std::find_if(list.begin(), list.end(),
                                  [&](const Warning& w) { return w.kind == warning.kind && w.about == warning.about; });
  if (found == list.end()) {
    list.push_back(std::move(warning));
    return true;
  }
  if (warning.severity > found->severity) *found = std::move(warning);
  return false;
}

void warn(State& state, const Observer& observer, Warning warning) {
  const std::string text = in_words(warning);
  if (warn(state.warnings, std::move(warning)) && observer.log) observer.log("warning: " + text);
}

std::string in_words(const Warning& warning) {
  if (warning.about.empty() && warning.kind == "scene") return warning.text;  // begins with its line
  return warning.kind + (warning.about.empty() ? "" : ", " + warning.about) + ": " + warning.text;
}

}  // namespace reye::sim
