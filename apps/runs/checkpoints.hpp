#pragma once
#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "output/run/checkpoint.hpp"

namespace reye::apps {

/// Makes the checkpoint of a state that it holds: states become bytes only where they are kept.
using Snapshot = std::function<output::Checkpoint()>;

/// Where a state stands in its run. A run that is extended resumes between blocks: it plays its last block otherwise,
/// since that is no longer the last.
enum class Standing { between_blocks, within_block, at_end };

/// Checkpoints of a run as its states follow each other, `apart_s` of wall time apart or more. Whatever the newest on
/// disk is, the one before it lies between blocks: where the newest is within a block, it is the start of that block,
/// and where the run has ended, the start of its last. All members throw std::runtime_error when the disk refuses.
class Checkpoints {
 public:
  Checkpoints(std::string dir, double apart_s) : dir_(std::move(dir)), apart_s_(apart_s) {}

  void start(const Snapshot& state);              ///< kept at once: the first of a run or of its extension
  void resume(Standing newest);                   ///< the run resumes from the newest on disk
  void reach(Snapshot state, Standing standing);  ///< the run has come to this state
  void finish();                                  ///< the last state is kept, too

 private:
  using clock = std::chrono::steady_clock;
  void keep(const Snapshot& state, bool within_block);
  void keep_block_start();

  std::string dir_;
  double apart_s_;
  clock::time_point kept_at_ = clock::now();
  bool newest_within_block_ = false;               ///< of the one on disk
  std::optional<Snapshot> block_start_, waiting_;  ///< not on disk yet
};

}  // namespace reye::apps
