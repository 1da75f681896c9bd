#pragma once
#include <string>
#include <vector>

namespace reye::base {

/// One part of a driven quantity: its value times the factor of its history.
struct Part {
  double value = 0.0;
  std::string history;  ///< empty: factor 1 from the start
};

/// A driven quantity: the sum of its parts.
using Parts = std::vector<Part>;

}  // namespace reye::base
