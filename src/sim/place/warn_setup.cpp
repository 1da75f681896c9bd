#include "sim/place/warn_setup.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/formatted.hpp"
#include "body/conflicts.hpp"
#include "scene/histories.hpp"
#include "sim/problem/drive.hpp"
#include "sim/problem/warnings.hpp"

namespace reye::sim {

std::vector<base::Issue> support_conflicts(Problem& problem) {
  std::vector<base::Issue> issues;
  for (int b = 0; b < problem.body_count(); ++b) {
    const auto& [mesh, input] = std::tie(problem.shapes[b]->mesh, problem.inputs[b]);
    const auto found =
        problem.rigid[b] ? body::rigid_support_conflicts(mesh, input) : body::support_conflicts(mesh, input);
    for (const auto& conflict : found) {
      const auto& support = input.supports[conflict.support];
      const bool along_edge = support.edge_axes && conflict.motion != "rotation";
      const std::string motion = !along_edge              ? conflict.motion
                                 : conflict.motion == "x" ? "tangent"
                                 : conflict.motion == "y" ? "normal"
                                                          : "";
      const std::string key = "support." + support.name + (motion.empty() ? "" : "." + motion);
      if (conflict.refused)
        issues.push_back({key, "", conflict.text});
      else
        warn(problem.warnings, {"support", "support " + support.name, conflict.text + "."});
    }
  }
  return issues;
}

namespace {

/// Number of strokes, runs of one direction, in a history; one increment each does not resolve them in time.
int strokes(const scene::History& history) {
  int count = 0;
  double last = 0.0;
  for (std::size_t i = 1; i < history.size(); ++i) {
    const double way = history[i][1] - history[i - 1][1];
    if (way == 0.0) continue;
    if (count == 0 || way * last < 0.0) ++count;
    last = way;
  }
  return count;
}

/// Whether a contact slides evenly in every play of a step that wears, whatever it plays.
bool slides_evenly(const contact::ContactOptions& contact) {
  const auto even = [](const base::Part& part) { return part.history.empty(); };
  return std::any_of(contact.imposed_sliding.begin(), contact.imposed_sliding.end(), even) ||
         std::any_of(contact.imposed_turn.begin(), contact.imposed_turn.end(), even);
}

bool any_wear(const contact::ContactOptions& contact) { return contact.wear.wears(); }

}  // namespace

void warn_of_steps(const scene::Scene& scene, std::vector<Warning>& warnings) {
  const bool wear = std::any_of(scene.contacts.begin(), scene.contacts.end(), any_wear);
  const bool evenly = std::any_of(scene.contacts.begin(), scene.contacts.end(), slides_evenly);
  const bool counted =
      std::any_of(scene.steps.begin(), scene.steps.end(), [](const auto& s) { return s.cycles > 0.0; });
  const auto acting = scene::acting_histories(scene);
  const auto acts = [&](const std::string& name) { return acting.contains(name); };
  for (std::size_t i = 0; i < scene.steps.size(); ++i) {
    const auto& step = scene.steps[i];
    const std::string about = "step " + step.name;
    const bool jumps = scene.lines.contains("step[" + std::to_string(i) + "].jump");
    if (wear && step.wear && step.cycles == 0.0 && !counted && (!scene.limits.empty() || jumps))
      warn(warnings, {"no_cycles", about,
                      "The step wears but has no cycles: it is played once and counts as none, so that no limit "
                      "can be reached at a cycle; write cycles = ..., or wear = false if it only loads."});
    if (step.cycles == 0.0) continue;
    if (!evenly && std::none_of(step.play.begin(), step.play.end(), acts)) {
      warn(warnings, {"plays_nothing", about,
                      "Its cycles play no history that a support, a load or an imposed sliding names: nothing moves in "
                      "them; write "
                      "play = [...]."});
      continue;
    }
    int most = 0;
    for (const auto& name : step.play) most = std::max(most, strokes(scene.histories.at(name)));
    if (const auto ends = static_cast<int>(increment_ends(scene, step).size());
        wear && step.wear && most > 0 && ends <= most) {
      const std::string text = base::formatted(
          "A cycle of %d stroke%s has %d increment%s: slip and wear are counted at the ends of strokes alone; "
          "write increments = %d or more.",
          most, most == 1 ? "" : "s", ends, ends == 1 ? "" : "s", 8 * most);
      warn(warnings, {"increments", about, text});
    }
  }
}

}  // namespace reye::sim
