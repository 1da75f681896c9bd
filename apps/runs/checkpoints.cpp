#include "runs/checkpoints.hpp"

namespace reye::apps {

void Checkpoints::keep(const Snapshot& state, bool within_block) {
  output::save_checkpoint(dir_, state(), newest_within_block_ ? output::Former::replaced : output::Former::kept);
  newest_within_block_ = within_block;
  kept_at_ = clock::now();
}

void Checkpoints::keep_block_start() {
  if (!block_start_) return;
  const Snapshot start = std::move(*block_start_);
  block_start_.reset();
  keep(start, false);
}

void Checkpoints::start(const Snapshot& state) { keep(state, false); }

void Checkpoints::resume(Standing newest) { newest_within_block_ = newest == Standing::within_block; }

void Checkpoints::reach(Snapshot state, Standing standing) {
  const bool due = std::chrono::duration<double>(clock::now() - kept_at_).count() >= apart_s_;
  waiting_.reset();
  if (standing == Standing::between_blocks) {
    block_start_ = std::move(state);
    if (due) keep_block_start();
  } else if (due || standing == Standing::at_end) {
    keep_block_start();
    keep(state, standing == Standing::within_block);
  } else {
    waiting_ = std::move(state);
  }
}

void Checkpoints::finish() {
  keep_block_start();
  if (!waiting_) return;
  const Snapshot last = std::move(*waiting_);
  waiting_.reset();
  keep(last, true);
}

}  // namespace reye::apps
