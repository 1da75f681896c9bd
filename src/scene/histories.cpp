#include "scene/histories.hpp"

#include <algorithm>
#include <cmath>

namespace reye::scene {

double largest_factor(const Scene& scene, const std::string& history) {
  return largest_factor({scene.histories, scene.steps}, history);
}

double largest_factor(const Played& played, const std::string& history) {
  const auto found = played.histories.find(history);
  if (found == played.histories.end()) return 1.0;
  double most = 0.0;
  for (const auto& corner : found->second) most = std::max(most, std::abs(corner[1]));
  double level = 0.0;
  for (const auto& step : played.steps)
    if (std::find(step.play.begin(), step.play.end(), history) != step.play.end()) level = std::max(level, step.level);
  return level > 0.0 ? level * most : most;
}

double largest_value(const Scene& scene, const base::Parts& parts) {
  return largest_value({scene.histories, scene.steps}, parts);
}

double largest_value(const Played& played, const base::Parts& parts) {
  double most = 0.0;
  for (const auto& part : parts) most += std::abs(part.value) * largest_factor(played, part.history);
  return most;
}

std::array<double, 2> range_of(const Scene& scene, const base::Parts& parts) {
  std::array<double, 2> range{0.0, 0.0};
  for (const auto& part : parts) {
    double least = 0.0, most = part.history.empty() ? 1.0 : 0.0;
    if (!part.history.empty())
      for (const auto& corner : scene.histories.at(part.history)) {
        least = std::min(least, corner[1]);
        most = std::max(most, corner[1]);
      }
    range[0] += std::min(least * part.value, most * part.value);
    range[1] += std::max(least * part.value, most * part.value);
  }
  return range;
}

double path_of(const Scene& scene, const Step& step, const base::Parts& parts) {
  double way = 0.0;
  for (const auto& part : parts) {
    if (std::find(step.play.begin(), step.play.end(), part.history) == step.play.end()) continue;
    const auto& corners = scene.histories.at(part.history);
    for (std::size_t i = 1; i < corners.size(); ++i)
      way += std::abs(part.value * step.level * (corners[i][1] - corners[i - 1][1]));
  }
  return way;
}

std::set<std::string> acting_histories(const Scene& scene) {
  std::set<std::string> names;
  for (const auto& support : scene.supports)
    for (const auto* motion : {&support.x, &support.y, &support.rotation})
      for (const auto& part : motion->parts) names.insert(part.history);
  for (const auto& contact : scene.contacts)
    for (const auto* parts : {&contact.imposed_sliding, &contact.imposed_turn})
      for (const auto& part : *parts)
        if (!part.history.empty()) names.insert(part.history);
  for (const auto& load : scene.boundary_loads) names.insert(load.history);
  for (const auto& load : scene.point_loads) names.insert(load.history);
  for (const auto& load : scene.body_forces) names.insert(load.history);
  return names;
}

}  // namespace reye::scene
