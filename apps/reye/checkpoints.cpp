#include "checkpoints.hpp"

#include "base/errors.hpp"
#include "base/printable.hpp"
#include "output/checkpoint.hpp"
#include "output/state_archive.hpp"
#include "sim/intact.hpp"

namespace reye::apps {

void Checkpoints::keep(const sim::State& state, const output::Counters& counters) {
  output::save_checkpoint(writer_.dir(), {output::own_origin(problem_.scene.sha256), counters, output::state_to_bytes(state)});
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

Resumption resumption_of(const std::string& dir, const sim::Problem& problem, sim::Cache& cache) {
  const auto own = output::own_origin(problem.scene.sha256);
  Resumption resumption;
  const auto search = output::load_checkpoint(dir, own, [&](const output::Checkpoint& checkpoint) {
    resumption.state = output::state_from_bytes(checkpoint.payload);
    sim::check_state(problem, resumption.state, cache);
  });
  resumption.notes = search.refusals;
  if (!search.found) {
    std::string reasons;
    for (const auto& refusal : search.refusals) reasons += (reasons.empty() ? "" : "; ") + refusal;
    throw base::InputError({{"--restart", dir, "no checkpoint to go on from: " + reasons}});
  }
  resumption.counters = search.found->counters;
  resumption.previous = search.previous;
  if (const auto& commit = search.found->origin.commit; commit != own.commit)
    resumption.notes.push_back("written by the build of commit " + base::printable(commit) + ", gone on from by that of commit " + own.commit +
                               ": results may differ in their last digits from an unbroken run");
  return resumption;
}

bool can_go_on(const std::string& dir, const sim::Problem& problem) {
  return output::load_checkpoint(dir, output::own_origin(problem.scene.sha256)).found.has_value();
}

}  // namespace reye::apps
