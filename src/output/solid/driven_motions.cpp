#include "output/solid/driven_motions.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "sim/problem/drive.hpp"

namespace reye::output {

namespace {

using HeldFactors = std::map<std::string, double>;

bool plays(const scene::Step& step, const std::string& history) {
  return std::find(step.play.begin(), step.play.end(), history) != step.play.end();
}

HeldFactors factors_during(const scene::SolidScene& scene, const scene::Step& step, double progress, HeldFactors held) {
  for (const auto& name : step.play) held[name] = step.level * sim::factor_at(scene.histories.at(name), progress);
  return held;
}

double sum_of(const base::Parts& parts, const HeldFactors& factors) {
  double sum = 0.0;
  for (const auto& part : parts) sum += part.value * (part.history.empty() ? 1.0 : factors.at(part.history));
  return sum;
}

/// Where the motion may bend in a step.
std::set<double> bends_of(const scene::SolidScene& scene, const scene::Step& step, const base::Parts& parts) {
  std::set<double> bends{0.0, 1.0};
  for (const auto& part : parts)
    if (!part.history.empty() && plays(step, part.history))
      for (const auto& corner : scene.histories.at(part.history)) bends.insert(corner[0]);
  return bends;
}

/// Fills the steps; whether the motion changes in any of them.
bool play_motion(const scene::SolidScene& scene, const base::Parts& parts, DrivenMotion& motion) {
  HeldFactors held;
  for (const auto& [name, history] : scene.histories) held[name] = history.empty() ? 0.0 : history.front()[1];
  double least = INFINITY, most = -INFINITY;
  for (const auto& step : scene.steps) {
    motion.steps.push_back({step.name, {}});
    for (const double progress : bends_of(scene, step, parts)) {
      const double value = sum_of(parts, factors_during(scene, step, progress, held));
      motion.steps.back().values.push_back({progress, value});
      least = std::min(least, value);
      most = std::max(most, value);
    }
    held = factors_during(scene, step, 1.0, held);
  }
  return most > least;
}

void add_support_motions(const scene::SolidScene& scene, const body::SolidSupport& support,
                         std::vector<DrivenMotion>& all) {
  static constexpr const char* axes[] = {"x", "y", "z"};
  for (int m = 0; m < 6; ++m) {
    const bool turns = m > 2;
    const auto& given = turns ? support.about[m - 3] : support.along[m];
    if (given.drive != body::Drive::moved) continue;
    DrivenMotion motion{
        (turns ? "rotation about " : "motion along ") + std::string(axes[m % 3]) + " of " + support.name,
        turns ? "rad" : "mm", support.name + (turns ? "_moment_" : "_force_"), turns ? "N_mm" : "N",
        support.axes.col(m % 3)};
    if (play_motion(scene, given.parts, motion)) all.push_back(std::move(motion));
  }
}

}  // namespace

std::vector<DrivenMotion> driven_motions(const scene::SolidScene& scene) {
  std::vector<DrivenMotion> all;
  for (const auto& support : scene.supports) add_support_motions(scene, support, all);
  for (const auto& contact : scene.contacts)
    for (const auto& sliding : contact.sliding) {
      if (sliding.direction.isZero()) continue;  // a turn has no one force
      // What resists the sliding acts on the secondary side against it.
      DrivenMotion motion{"sliding of " + contact.name, "mm", contact.name + "_force_", "N", -sliding.direction};
      if (play_motion(scene, sliding.parts, motion)) all.push_back(std::move(motion));
    }
  return all;
}

}  // namespace reye::output
