#pragma once
#include <optional>

#include "sim/problem/observer.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/records.hpp"
#include "sim/problem/state.hpp"
#include "sim/reshape/shape.hpp"

namespace reye::sim {

/// Holds back the newest row of the history, so that the row at the end of a block is that of the state which the block
/// leaves: on the worn shape, in equilibrium again. The last row of a run and its summary then agree.
class HeldRow {
 public:
  explicit HeldRow(const Observer& outside);
  HeldRow(const HeldRow&) = delete;
  HeldRow& operator=(const HeldRow&) = delete;

  const Observer& observer() const {
    return inside_;
  }  ///< the observer to which a block reports; all but its newest row is passed on
  void settle(const Problem& problem, const State& state, const solver::System& system, const scene::Step& step);
  void release();

 private:
  const Observer& outside_;
  Observer inside_;
  std::optional<IncrementRecord> row_;
};

}  // namespace reye::sim
