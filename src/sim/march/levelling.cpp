#include "sim/march/levelling.hpp"

#include "base/formatted.hpp"

namespace reye::sim {

std::optional<Warning> uneven(const scene::Step& step, double cycle, double change) {
  if (!(change > alike) || !std::isfinite(change)) return std::nullopt;
  return Warning{
      "pressures", "step " + step.name,
      base::formatted("pressures shown at cycle %g are uncertain by %.2g %% (root mean square): they still changed "
                      "as much from one to the next of the short cycles that level what is shown. The wear is not "
                      "concerned. Let a step end at this cycle",
                      cycle, 100.0 * change),
      change};
}

}  // namespace reye::sim
