#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/formatted.hpp"

/// The limits of a run, as the command reports them at its end: a summary of the plane or of solids.
namespace reye::apps {

template <class Summary>
std::string life_words(const Summary& s, const std::string& name, const std::optional<double>& cycles) {
  using base::formatted;
  if (!cycles) return formatted("not reached in %.6g cycles: %.3g %% of it", s.cycles, 100.0 * s.limit_share.at(name));
  const auto error = s.life_error.find(name);
  return formatted("reached at cycle %.6g", *cycles) +
         (error == s.life_error.end() ? "" : formatted(", +- %.2g by the cycle jump", error->second));
}

template <class Summary>
void add_lives(const Summary& s, std::vector<std::string>& lines) {
  for (const auto& [name, cycles] : s.life_cycles)
    lines.push_back("limit " + name + ": " + life_words(s, name, cycles));
  for (const auto& [name, band] : s.life_band)
    if (band.shortest_cycles)
      lines.push_back(base::formatted("  with the scatter of wear at cycle %.6g to %.6g", *band.shortest_cycles,
                                      *band.longest_cycles));
}

}  // namespace reye::apps
