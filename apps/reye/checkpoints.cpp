#include "checkpoints.hpp"

#include "base/errors.hpp"
#include "base/printable.hpp"
#include "output/run/commit.hpp"
#include "output/run/state_archive.hpp"
#include "scene/read.hpp"
#include "sim/march/extend.hpp"
#include "sim/measure/intact.hpp"
#include "sim/problem/ending.hpp"

namespace reye::apps {

void Checkpoints::keep(const sim::State& state, const output::Counters& counters) {
  const auto& scene = problem_.scene;
  output::save_checkpoint(writer_.dir(), {output::own_origin(scene.sha256, scene.fixed_sha256), counters,
                                          output::state_to_bytes(state), sim::at_end(problem_, state)});
  kept_at_ = clock::now();
  waiting_.reset();
}

void Checkpoints::block_end(const sim::State& state) {
  const bool end = sim::at_end(problem_, state);
  if (end) finish();  // the start of the last block
  const double since = std::chrono::duration<double>(clock::now() - kept_at_).count();
  if (end || since >= problem_.scene.output.checkpoint_s)
    keep(state, writer_.counters());
  else
    waiting_ = {state, writer_.counters()};
}

void Checkpoints::finish() {
  if (!waiting_) return;
  const BlockEnd last = std::move(*waiting_);
  keep(last.state, last.counters);
}

std::optional<scene::Extension> extension_in(const std::string& dir, const scene::Scene& scene) {
  const auto holder = output::read_identity(dir);
  if (!holder || holder->sha256 == scene.sha256 || holder->scene_text.empty()) return {};
  if (holder->fixed_sha256 != scene.fixed_sha256 && holder->name != scene.name) return {};
  return scene::extension_of(holder->scene_text, holder->fixed_sha256, scene);
}

namespace {

[[noreturn]] void refuse(const std::string& dir, const std::vector<std::string>& refusals) {
  std::string reasons;
  for (const auto& refusal : refusals) reasons += (reasons.empty() ? "" : "; ") + refusal;
  throw base::InputError({{"--restart", dir, "no checkpoint to resume from: " + reasons}});
}

/// The newest state is asked first whether it may resume so; where it has ended, the run resumes from the one before.
output::CheckpointSearch search_extended(const std::string& dir, const sim::Problem& problem,
                                         const scene::Extension& extension, sim::Cache& cache, Resumption& resumption) {
  const auto origin = output::own_origin("", problem.scene.fixed_sha256);
  std::vector<base::Issue> issues;
  const auto extended = [&](const output::Checkpoint& checkpoint) {
    resumption.state = output::state_from_bytes(checkpoint.payload);
    issues = sim::extend(problem, extension.limits, extension.cycles_key, resumption.state, cache);
  };
  auto newest = output::load_checkpoint(dir, origin, extended);
  if (!issues.empty()) throw scene::located(problem.scene, issues);
  if (!newest.found || !(newest.found->ended || sim::at_end(problem, resumption.state))) return newest;
  auto before = output::load_checkpoint(dir, origin, [&](const output::Checkpoint& checkpoint) {
    extended(checkpoint);
    if (checkpoint.ended || sim::at_end(problem, resumption.state)) throw std::runtime_error("the run ended with it");
  });
  if (before.found) before.refusals = newest.refusals;
  return before;
}

}  // namespace

Resumption resumption_of(const std::string& dir, const sim::Problem& problem,
                         const std::optional<scene::Extension>& extension, sim::Cache& cache) {
  Resumption resumption;
  const auto search = extension
                          ? search_extended(dir, problem, *extension, cache, resumption)
                          : output::load_checkpoint(dir, output::own_origin(problem.scene.sha256),
                                                    [&](const output::Checkpoint& checkpoint) {
                                                      resumption.state = output::state_from_bytes(checkpoint.payload);
                                                      sim::check_state(problem, resumption.state, cache);
                                                    });
  if (!search.found) refuse(dir, search.refusals);
  resumption.notes = search.refusals;
  resumption.counters = search.found->counters;
  resumption.previous = search.previous;
  resumption.extends = extension.has_value();
  if (const auto& commit = search.found->origin.commit; commit != output::commit())
    resumption.notes.push_back("written by the build of commit " + base::printable(commit) +
                               ", resumed by that of commit " + output::commit() +
                               ": results may differ in their last digits from an unbroken run");
  return resumption;
}

bool can_go_on(const std::string& dir, const sim::Problem& problem) {
  return output::load_checkpoint(dir, output::own_origin(problem.scene.sha256)).found.has_value();
}

}  // namespace reye::apps
