#include "sim/march/held_row.hpp"

#include "sim/measure/figures.hpp"
#include "sim/problem/drive.hpp"

namespace reye::sim {

HeldRow::HeldRow(const Observer& outside) : outside_(outside), inside_(outside) {
  if (!outside.increment) return;
  inside_.increment = [this](const IncrementRecord& row) {
    release();
    row_ = row;
  };
}

void HeldRow::settle(const Problem& problem, const State& state, const solver::System& system,
                     const scene::Step& step) {
  if (!row_) return;
  auto controls = controls_at(problem, system, state.factors, step, 1.0, 1.0, 1.0);
  count_from_renewal(controls, problem, system, state);
  IncrementRecord now = figures_of(problem, state, system, controls);
  now.step = row_->step;
  now.cycle = state.cycle;
  now.progress = row_->progress;
  now.newton = row_->newton;
  row_ = std::move(now);
  release();
}

void HeldRow::release() {
  if (row_) outside_.increment(*row_);
  row_.reset();
}

}  // namespace reye::sim
