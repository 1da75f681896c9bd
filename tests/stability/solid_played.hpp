#pragma once
#include "stability/solid_members.hpp"

namespace reye::test {

/// How a member ended.
struct SolidOutcome {
  std::string status, reason;
  int increments = 0, newton = 0, newton_most = 0, cutbacks = 0;
  double balance = 0.0;
  double least_pressure = 0.0;                   ///< at any node, over the largest
  double force = 0.0, peak = 0.0, energy = 0.0;  ///< at the end, in N, MPa, mJ whatever the units
  double ledger = 0.0, depth_mm = 0.0;           ///< of a member that wears
  int remeshes = 0;
  double cpu_s = 0.0;
};

SolidOutcome play(const SolidMember& member);

}  // namespace reye::test
