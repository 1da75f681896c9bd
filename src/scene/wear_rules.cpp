#include "scene/wear_rules.hpp"

#include <algorithm>

namespace reye::scene {

std::string needs_speed(const wear::Law& law) {
  const auto reads = [](const wear::Formula& formula) { return formula.uses(wear::Variable::speed); };
  if (!law.wears()) return {};
  if (law.speed_exponent != 0.0) return "wears with a speed_exponent";
  return reads(law.secondary_formula) || reads(law.primary_formula) ? "wears by a formula of speed_mm_per_s" : "";
}

std::string no_band_by_law(const std::string& contact, const wear::Law& law) {
  if (law.secondary_formula || law.primary_formula) return "contact \"" + contact + "\" has a formula";
  return law.threshold > 0.0 ? "contact \"" + contact + "\" has a threshold of wear" : "";
}

std::string no_band_by_steps(const std::vector<Step>& steps) {
  const auto wears = [](const Step& step) { return step.wear; };
  const auto count = std::count_if(steps.begin(), steps.end(), wears);
  if (count != 1) return count == 0 ? "no step wears" : "more than one step wears";
  const auto* one = &*std::find_if(steps.begin(), steps.end(), wears);
  for (const auto* step = steps.data(); step != one; ++step)
    if (step->cycles > 0.0) return "cycles are counted before the step that wears";
  return one->cycles > 0.0 ? "" : "the step that wears has no cycles";
}

void check_bands(const Entry& root, const std::string& why, Issues& issues) {
  for (const auto& limit : root.all("limit")) {
    const auto factor = limit.pair("wear_factor");
    if (!factor) continue;
    if (factor->x() > factor->y())
      issues.push_back({limit.key("wear_factor"), limit.written("wear_factor"), "must be [lowest, highest]"});
    if (!why.empty())
      issues.push_back({limit.key("wear_factor"), limit.written("wear_factor"),
                        why + ", so that lives do not scale as 1 / factor; vary the coefficients in a sweep instead"});
  }
}

}  // namespace reye::scene
