#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "adapt/shape/relocation.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"
#include "solver/newton.hpp"

namespace reye::sim {

/// A system of equations, immutable and shared: who holds one keeps it, whatever the cache makes next.
using SystemPtr = std::shared_ptr<const solver::System>;

/// What a system is made of: the shape of each body, and its kinematics, which decide its law.
struct SystemKey {
  std::vector<body::ShapePtr> shapes;
  std::vector<base::Kinematics> kinematics;
};

/// Derived data, keyed by what they are made of; discarding them changes no result.
struct Cache {
  // Compiled once: every file that holds one would else compile them. A cache is not copied.
  Cache();
  ~Cache();

  SystemKey key;
  SystemPtr system;
  solver::Newton newton;
  adapt::RelocationCache relocation;
  std::map<std::string, double> seconds;  ///< wall time by room
  double cpu_s = 0.0;                     ///< processor time that went into it before the run
};

/// The system of equations on the state's shapes; unchanged bodies keep their operators. A factor is released before
/// the next one of its body is made unless the system that it belongs to is still held.
SystemPtr system_of(const Problem& problem, const State& state, Cache& cache);

}  // namespace reye::sim
