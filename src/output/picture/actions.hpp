#pragma once
#include <string>
#include <utility>
#include <vector>

#include "sim/problem/problem.hpp"

/// What acts on the bodies of a scene, for its picture.
namespace reye::output {

using base::Vec2;

inline constexpr const char *support_colour = "#7a4fa3", *load_colour = "#8a6d00";

/// A support or a load: its letter, where it acts, and what it does, in words.
struct Action {
  std::string letter, words;
  const char* colour = support_colour;
  int body = 0;
  std::string edge;                           ///< empty: at a point
  Vec2 at{0.0, 0.0};                          ///< a place of it
  Vec2 out{0.0, 0.0};                         ///< outward normal there
  std::vector<std::pair<Vec2, bool>> arrows;  ///< unit directions; true: to and fro
};

/// "fixed", "0.1 mm × slide", "a spring of 5 N per mm"; `length` and `force` are the units of motion and of what acts.
std::string motion_in_words(const body::Motion& motion, const std::string& length, const std::string& force);

/// Supports, then loads, with letters from A on.
std::vector<Action> actions_of(const sim::Problem& problem);

}  // namespace reye::output
