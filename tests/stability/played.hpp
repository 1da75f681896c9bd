#pragma once
#include <string>
#include <vector>

#include "sim/problem/records.hpp"
#include "stability/members.hpp"

/// A member played through the library, and the checks that every one must pass.
namespace reye::test {

struct Played {
  std::string status, reason;
  long increments = 0, newton = 0, factorisations = 0, cutbacks = 0, remeshes = 0;
  int newton_most = 0;   ///< solves of one accepted increment
  double ledger = 0.0;   ///< |removed volume - coefficient x work| over it
  double balance = 0.0;  ///< forces on all bodies and on each one, left over; over the largest support force of the run
  double multiplier =
      0.0;  ///< smallest nodal normal multiplier over the largest, of any state seen; 0: none is negative
  double cpu_s = 0.0;
  std::vector<double>
      figures;  ///< of the end: forces, pressure, energy, depths and areas of the contact, in plain units
};

Played play(const Member& member);

/// Largest difference of two runs' figures, relative.
double difference(const Played& a, const Played& b);

}  // namespace reye::test
