#pragma once
#include <array>
#include <set>

#include "scene/scene.hpp"

/// What histories drive, and how far.
namespace reye::scene {

/// The largest factor of a history in size; of none, 1.
double largest_factor(const Scene& scene, const std::string& history);

/// The most that parts add up to in size, should all of them be at their largest at once.
double largest_value(const Scene& scene, const base::Parts& parts);

/// Least and largest value of parts whose histories begin at nothing, should all of them be there at once.
std::array<double, 2> range_of(const Scene& scene, const base::Parts& parts);

/// The way that parts take in one play of a step, each there and back by itself.
double path_of(const Scene& scene, const Step& step, const base::Parts& parts);

/// Histories that a motion, a load or an imposed sliding names.
std::set<std::string> acting_histories(const Scene& scene);

}  // namespace reye::scene
