#include "sim/solid/solid_stick_edge.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "scene/force_driven.hpp"
#include "sim/measure/stick_zone.hpp"
#include "sim/problem/warnings.hpp"
#include "sim/solid/whole_patch.hpp"

namespace reye::sim {

namespace {

constexpr double most_lost = 2.0;  ///< elements, one at either side: a ring of points slips or sticks at a time
constexpr double elongated = 3.0;  ///< ratio of the half widths from which a contact is more of a line than of a disc

bool only_forces_drive(const SolidProblem& problem) {
  scene::CycleDrives drives(problem.scene.steps);
  for (const auto& input : problem.inputs) {
    for (const auto& support : input.supports) {
      for (const auto& motion : support.along) drives.add(motion);
      for (const auto& motion : support.about) drives.add(motion);
      drives.add(support.normal);
    }
    for (const auto& load : input.loads) drives.add_load(load.history);
  }
  return drives.forces_alone();
}

/// Secondary points whose path in the block is more than a hundredth of the longest: what creeps by less at an edge
/// wears nothing that counts.
std::vector<char> slid_in_block(const SolidRunState& state, std::size_t c) {
  constexpr double least_share = 0.01;
  const auto &before = state.block_wear[c].slip, &after = state.solution.wear[c].slip;
  std::vector<double> path(after.size());
  std::transform(after.begin(), after.end(), before.begin(), path.begin(), std::minus<>());
  const double longest = path.empty() ? 0.0 : *std::max_element(path.begin(), path.end());
  std::vector<char> slid(path.size());
  std::transform(path.begin(), path.end(), slid.begin(),
                 [&](double way) { return way > 0.0 && way >= least_share * longest; });
  return slid;
}

struct Seen {
  StickZone zone;
  LimitDepth depth;
};

Seen seen(const WholePatch& patch) {
  const auto [larger, smaller] = patch.half_widths();
  const bool line = larger > elongated * smaller;
  const double share = patch.stick_area() / patch.area(), width = 2.0 * smaller;
  return {{width * (line ? share : std::sqrt(share)), width, patch.element()},
          line ? limit_depth_of_cylinders : limit_depth_of_balls};
}

}  // namespace

void warn_of_stick_edge(const SolidProblem& problem, const solver::SolidSystem& system, SolidRunState& state,
                        const SolidObserver& observer) {
  if (!state.solved || !only_forces_drive(problem)) return;
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const auto& o = problem.contacts[c].options;
    if (o.friction == 0.0 || !o.sliding.empty() || !o.wear.wears()) continue;
    const WholePatch patch = whole_patch(problem, system, *state.solved, c, slid_in_block(state, c));
    if (patch.x.empty()) continue;
    const Seen now = seen(patch);
    const std::string about = "contact " + o.name;
    StickZone& widest = state.widest_stick[c];
    for (const auto& warning : {receding_stick(about, now.zone, widest, most_lost, state.cycle, now.depth),
                                unresolved_stick(about, widest, now.depth)})
      if (warning && warn(state.warnings, *warning) && observer.log) observer.log("warning: " + in_words(*warning));
  }
}

}  // namespace reye::sim
