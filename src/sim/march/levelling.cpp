#include "sim/march/levelling.hpp"

#include "base/formatted.hpp"

namespace reye::sim {

std::optional<Warning> uneven(const scene::Step& step, double cycle, double left) {
  if (!(left > alike) || !std::isfinite(left)) return std::nullopt;
  return Warning{
      "pressures", "step " + step.name,
      base::formatted("pressures shown at cycle %g are uncertain by %.2g %% (root mean square): they still change by "
                      "so much as the short cycles that level what is shown become shorter. The wear is not "
                      "concerned. Let a step end at this cycle",
                      cycle, 100.0 * left),
      left};
}

}  // namespace reye::sim
