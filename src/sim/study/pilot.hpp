#pragma once
#include <functional>
#include <string>
#include <vector>

#include "sim/study/mesh_difference.hpp"

/// How a pilot run, and its error on few elements, chooses the number of elements for an accuracy.   [README (11)]
namespace reye::sim {

/// Elements per extent of a fine zone: of the first and the last pilot, and the most that are chosen.
struct PilotRule {
  double first, last, most;
  const char* extent;  ///< in words
};

struct Pilot {
  double elements = 0.0;
  DiscretisationError error;
  double suited = 0.0;  ///< elements that the accuracy asks for by this error
};

/// The coarsest pilot whose extrapolation reaches the elements it asks for, or the finest that gives an error;
/// `played(n)`: the error on n elements. Throws base::InputError at `accuracy` where none gives an error.
Pilot piloted(const PilotRule& rule, double accuracy, const std::function<DiscretisationError(double)>& played);

/// What a pilot has decided, a sentence each; `sizes`: as a scene would give them, `seconds` of processor time. Throws
/// base::InputError at `accuracy` where more elements than the most are asked for.
std::vector<std::string> decided(const PilotRule& rule, double accuracy, const Pilot& pilot, const std::string& sizes,
                                 double seconds);

}  // namespace reye::sim
