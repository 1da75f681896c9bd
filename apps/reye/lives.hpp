#pragma once
#include <spdlog/spdlog.h>

#include <optional>
#include <string>

/// The limits of a run, as the command reports them at its end: a summary of the plane or of solids.
namespace reye::apps {

template <class Summary>
std::string told_life(const Summary& s, const std::string& name, const std::optional<double>& cycles) {
  if (!cycles)
    return fmt::format("not reached in {:.6g} cycles: {:.3g} % of it", s.cycles, 100.0 * s.limit_share.at(name));
  const auto error = s.life_error.find(name);
  return fmt::format("reached at cycle {:.6g}", *cycles) +
         (error == s.life_error.end() ? "" : fmt::format(", +- {:.2g} by the cycle jump", error->second));
}

template <class Summary>
void tell_lives(const Summary& s) {
  for (const auto& [name, cycles] : s.life_cycles) spdlog::info("limit {}: {}", name, told_life(s, name, cycles));
  for (const auto& [name, band] : s.life_band)
    if (band.shortest_cycles)
      spdlog::info("  with the scatter of wear at cycle {:.6g} to {:.6g}", *band.shortest_cycles, *band.longest_cycles);
}

}  // namespace reye::apps
