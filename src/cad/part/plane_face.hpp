#pragma once
#include <string>
#include <vector>

#include "base/linalg.hpp"

namespace reye::cad {

using base::Vec2;

/// A face in the plane z = 0 bounded by closed loops, the outer one first.
struct PlaneFace {
  std::string name;
  std::vector<std::vector<Vec2>> loops;  ///< corner after corner [mm], in second order corner, mid point, corner ...
  int order = 1;                         ///< 2: edges are parabolas through their mid points
};

}  // namespace reye::cad
