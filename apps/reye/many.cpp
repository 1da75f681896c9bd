#include "many.hpp"

#include <cstdio>
#include <optional>

#include "base/printable.hpp"
#include "signals.hpp"

namespace reye::apps {

namespace {

/// Prints what the sweep found; of one that was asked for a single member, nothing but what went amiss.
void tell_sweep(const SweepRequest& request, const SweepResult& result, bool quiet) {
  for (const auto& line : result.undone) std::fprintf(stderr, "%s\n", base::printable(line).c_str());
  if (quiet || request.member >= 0) return;
  for (const auto& sentence : result.life_bands) std::printf("%s\n", sentence.c_str());
  const auto dir = base::printable(result.dir);
  std::printf("%zu members, %zu done; table %s/sweep.csv, page %s/sweep.html\n", result.members,
              result.members - result.undone.size(), dir.c_str(), dir.c_str());
}

}  // namespace

int sweep(const SweepRequest& request, bool quiet) {
  ignore_lost_output();
  std::optional<StopSignals> stop;  // from when members run: before, a signal acts as always
  SweepWatch watch;
  if (!quiet) watch.ended = [](const std::string& line) { std::fprintf(stderr, "%s\n", line.c_str()); };
  watch.stops = [&] {
    if (!stop) stop.emplace(false);
    return StopSignals::count();
  };
  const auto result = sweep(request, watch);
  tell_sweep(request, result, quiet);
  return result.interrupted ? 130 : result.undone.empty() ? 0 : 1;
}

}  // namespace reye::apps
