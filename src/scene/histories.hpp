#pragma once
#include <array>
#include <set>

#include "scene/scene.hpp"

/// The values that histories drive, and their extent.
namespace reye::scene {

/// What steps play, of a scene of either kind.
struct Played {
  const std::map<std::string, History>& histories;
  const std::vector<Step>& steps;
};

/// The largest factor of a history in size; 1 without a history.
double largest_factor(const Played& played, const std::string& history);
double largest_factor(const Scene& scene, const std::string& history);

/// The largest possible sum of parts in size, if all of them peak at once.
double largest_value(const Played& played, const base::Parts& parts);
double largest_value(const Scene& scene, const base::Parts& parts);

/// Least and largest possible sum of parts whose histories begin at zero, if all of them peak at once.
std::array<double, 2> range_of(const Scene& scene, const base::Parts& parts);

/// The path of parts in one play of a step, each back and forth by itself.
double path_of(const Scene& scene, const Step& step, const base::Parts& parts);

/// Histories that a motion, a load or an imposed sliding names.
std::set<std::string> acting_histories(const Scene& scene);

}  // namespace reye::scene
