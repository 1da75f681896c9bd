#pragma once
#include <map>
#include <string>
#include <vector>

#include "adapt/shape/relocation.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"
#include "solver/newton.hpp"

namespace reye::sim {

/// Derived data, keyed by the shapes they came from; discarding them changes no result.
struct Cache {
  // Compiled once: every file that holds one would else compile them.
  Cache();
  Cache(const Cache&);
  Cache(Cache&&) noexcept;
  Cache& operator=(const Cache&);
  Cache& operator=(Cache&&) noexcept;
  ~Cache();

  std::vector<body::ShapePtr> shapes;
  solver::System system;
  solver::Newton newton;
  adapt::RelocationCache relocation;
  std::map<std::string, double> seconds;  ///< wall time by room
  double cpu_s = 0.0;                     ///< processor time that went into it before the run
};

/// The system of equations on the state's shapes; unchanged bodies keep their operators. The system returned before is
/// invalid where a shape has changed.
const solver::System& system_of(const Problem& problem, const State& state, Cache& cache);

}  // namespace reye::sim
