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

namespace {

/// The motion of a support that a conflict concerns, as the scene has it; empty where none of its words does.
std::string motion_in_scene(const body::Support& support, const std::string& motion) {
  if (!support.edge_axes || motion == "rotation") return motion;
  return motion == "x" ? "tangent" : motion == "y" ? "normal" : "";
}

}  // namespace

std::vector<base::Issue> support_conflicts(Problem& problem) {
  std::vector<base::Issue> issues;
  for (int b = 0; b < problem.body_count(); ++b) {
    const auto& [mesh, input] = std::tie(problem.shapes[b]->mesh, problem.inputs[b]);
    const auto found =
        problem.rigid[b] ? body::rigid_support_conflicts(mesh, input) : body::support_conflicts(mesh, input);
    for (const auto& conflict : found) {
      const auto& support = input.supports[conflict.support];
      const std::string motion = motion_in_scene(support, conflict.motion);
      if (conflict.refused)
        issues.push_back({"support." + support.name + (motion.empty() ? "" : "." + motion), "", conflict.text});
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

bool counts_cycles(const scene::Step& step) { return step.cycles > 0.0; }

/// Warns of a step that wears without cycles, where cycles are asked for.
void warn_of_no_cycles(const scene::Scene& scene, std::size_t number, std::vector<Warning>& warnings) {
  const auto& step = scene.steps[number];
  const bool jumps = scene.lines.contains("step[" + std::to_string(number) + "].jump");
  const bool counted = std::any_of(scene.steps.begin(), scene.steps.end(), counts_cycles);
  if (step.wear && step.cycles == 0.0 && !counted && (!scene.limits.empty() || jumps))
    warn(warnings, {"no_cycles", "step " + step.name,
                    "The step wears but has no cycles: it is played once and counts as none, so that no limit "
                    "can be reached at a cycle; write cycles = ..., or wear = false if it only loads."});
}

void warn_of_no_motion(const scene::Step& step, std::vector<Warning>& warnings) {
  warn(warnings, {"plays_nothing", "step " + step.name,
                  "Its cycles play no history that a support, a load or an imposed sliding names: nothing moves in "
                  "them; write "
                  "play = [...]."});
}

/// Warns of a step that wears in cycles of no more increments than strokes.
void warn_of_increments(const scene::Scene& scene, const scene::Step& step, std::vector<Warning>& warnings) {
  int most = 0;
  for (const auto& name : step.play) most = std::max(most, strokes(scene.histories.at(name)));
  const auto ends = static_cast<int>(increment_ends(scene, step).size());
  if (!step.wear || most == 0 || ends > most) return;
  const std::string text = base::formatted(
      "A cycle of %d stroke%s has %d increment%s: slip and wear are counted at the ends of strokes alone; "
      "write increments = %d or more.",
      most, most == 1 ? "" : "s", ends, ends == 1 ? "" : "s", 8 * most);
  warn(warnings, {"increments", "step " + step.name, text});
}

}  // namespace

void warn_of_steps(const scene::Scene& scene, std::vector<Warning>& warnings) {
  const bool wear = std::any_of(scene.contacts.begin(), scene.contacts.end(), any_wear);
  const bool evenly = std::any_of(scene.contacts.begin(), scene.contacts.end(), slides_evenly);
  const auto acting = scene::acting_histories(scene);
  const auto acts = [&](const std::string& name) { return acting.contains(name); };
  for (std::size_t i = 0; i < scene.steps.size(); ++i) {
    const auto& step = scene.steps[i];
    if (wear) warn_of_no_cycles(scene, i, warnings);
    if (!counts_cycles(step)) continue;
    if (!evenly && std::none_of(step.play.begin(), step.play.end(), acts))
      warn_of_no_motion(step, warnings);
    else if (wear)
      warn_of_increments(scene, step, warnings);
  }
}

}  // namespace reye::sim
