#include "sim/problem/scene_line.hpp"

#include <algorithm>

#include "base/formatted.hpp"
#include "sim/problem/drive.hpp"

namespace reye::sim {

std::string key_of_step(const std::vector<scene::Step>& steps, const std::string& name) {
  std::vector<std::string> names;
  for (const auto& step : steps)
    if (step.name != overlap_left && std::find(names.begin(), names.end(), step.name) == names.end())
      names.push_back(step.name);
  const auto found = std::find(names.begin(), names.end(), name);
  return "step[" + std::to_string(found - names.begin()) + "]";
}

std::string scene_line(const scene::Scene& scene, const std::string& about) {
  const auto space = about.find(' ');
  if (space == std::string::npos) return {};
  const std::string kind = about.substr(0, space), name = about.substr(space + 1);
  const auto line = scene.lines.find(kind == "step"    ? key_of_step(scene.steps, name)
                                     : kind == "probe" ? "output.probes." + name
                                                       : kind + "." + name);
  return line == scene.lines.end() ? std::string() : scene.path + ":" + std::to_string(line->second) + ": ";
}

std::vector<base::Issue> endless_steps(const std::vector<scene::Step>& steps,
                                       const std::function<double(const scene::Step&)>& increments) {
  constexpr double most = 1e6;
  std::vector<base::Issue> issues;
  for (const auto& step : steps)
    if (const double count = increments(step); count > most)
      issues.push_back(
          {key_of_step(steps, step.name), base::quoted(step.name),
           base::formatted("its rotations take %.4g increments of at most 0.3 rad; at most 1e6 are played. "
                           "Angles are in rad",
                           count)});
  return issues;
}

}  // namespace reye::sim
