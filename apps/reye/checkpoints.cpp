#include "checkpoints.hpp"

#include "commands.hpp"
#include "output/checkpoint.hpp"
#include "output/state_archive.hpp"

namespace reye::apps {

void Checkpoints::keep(const sim::State& state, const output::Counters& counters) {
  output::save_checkpoint(writer_.dir(), {{version(), problem_.scene.sha256, counters}, output::state_to_bytes(state)});
  kept_at_ = clock::now();
  waiting_.reset();
}

void Checkpoints::block_end(const sim::State& state) {
  const double since = std::chrono::duration<double>(clock::now() - kept_at_).count();
  if (since >= problem_.scene.output.checkpoint_s)
    keep(state, writer_.counters());
  else
    waiting_ = {state, writer_.counters()};
}

void Checkpoints::finish() {
  if (!waiting_) return;
  const BlockEnd last = std::move(*waiting_);
  keep(last.state, last.counters);
}

}  // namespace reye::apps
