#include "base/errors.hpp"
#include "output/folder/files.hpp"
#include "output/folder/folder_lock.hpp"
#include "output/picture/scene_picture.hpp"
#include "output/run/run_writer.hpp"
#include "runs/checkpoints.hpp"
#include "runs/plane_resume.hpp"
#include "runs/run.hpp"
#include "runs/words.hpp"
#include "sim/problem/warnings.hpp"
#include "sim/study/prepare.hpp"
#include "sim/study/run.hpp"

namespace reye::apps {

namespace {

/// The folder made ready for a new run. Its start is kept as the first checkpoint: a run interrupted before its first
/// block can resume, too.
void begin_folder(const sim::Problem& problem, const sim::State& state, output::RunWriter& writer,
                  Checkpoints& checkpoints) {
  writer.begin();
  // Before the checkpoint: a run that resumes from it finds the picture.
  output::atomic_write(writer.dir() + "/scene.svg", output::scene_picture(problem));
  checkpoints.start(snapshot_of(problem, state, writer.counters()));
}

/// `checkpoints`: none for a run in memory.
sim::Observer observer_of(const sim::Problem& problem, output::RunWriter& writer, Checkpoints* checkpoints,
                          const RunWatch& watch) {
  sim::Observer o;
  o.progress = watch.progress;
  o.increment = [&](const sim::IncrementRecord& r) { writer.increment(r); };
  o.frame = [&](const sim::Frame& f) { writer.frame(f); };
  o.remesh = [&](const sim::RemeshRecord& r) { writer.remesh(r); };
  o.log = [&](const std::string& text) { writer.log(text); };
  o.interrupted = watch.interrupted;
  o.block = [&problem, &writer, &watch, checkpoints](const sim::State& state) {
    if (checkpoints) checkpoints->reach(snapshot_of(problem, state, writer.counters()), standing_of(problem, state));
    if (watch.block) watch.block(state.cycle);
  };
  return o;
}

void log_start(const sim::Problem& problem, const std::optional<scene::Extension>& extension,
               output::RunWriter& writer) {
  for (const auto& text : problem.plan.lines) writer.log(text);
  for (const auto& warning : problem.warnings) writer.log("warning: " + sim::in_words(warning));
  if (extension)
    for (const auto& change : extension->changes) writer.log("extended: " + change);
}

RunResult<sim::Summary> run_in_memory(const sim::Problem& problem, sim::Cache& cache, output::RunWriter& writer,
                                      const RunWatch& watch) {
  sim::State state = sim::initial_state(problem);
  writer.begin();
  auto summary = sim::run(problem, state, observer_of(problem, writer, nullptr, watch), cache);
  writer.finish(summary);
  return {std::move(summary), writer.tables()};
}

}  // namespace

RunResult<sim::Summary> run(const scene::Scene& scene, const RunPlace& place, const RunWatch& watch) {
  const auto extension = place.restart ? extension_in(place.dir, scene) : std::nullopt;
  if (!place.dir.empty()) open_or_refuse(place.dir, scene.name, scene.sha256, extension.has_value(), place.force);
  sim::Cache cache;
  const sim::Problem problem = sim::prepare(scene, &cache);
  output::RunWriter writer(place.dir, scene);
  log_start(problem, extension, writer);
  if (watch.begins) watch.begins(problem.plan.lines, in_words(problem.scene, problem.warnings));
  if (place.dir.empty()) return run_in_memory(problem, cache, writer, watch);
  Checkpoints checkpoints(place.dir, scene.output.checkpoint_s);
  sim::State state = sim::initial_state(problem);
  std::optional<Resumption> resumption;  // refused before anything is made
  if (place.restart) resumption = resumption_of(place.dir, problem, extension, state, cache);
  const output::FolderLock lock(place.dir);
  if (resumption)
    resume_folder(*resumption, snapshot_of(problem, state, resumption->counters), standing_of(problem, state), writer,
                  checkpoints, watch);
  else
    begin_folder(problem, state, writer, checkpoints);
  RunResult<sim::Summary> result;
  play_guarded(place.dir, origin_of(problem), [&] {
    result.summary = sim::run(problem, state, observer_of(problem, writer, &checkpoints, watch), cache);
    checkpoints.finish();
    writer.finish(result.summary);
  });
  return result;
}

}  // namespace reye::apps
