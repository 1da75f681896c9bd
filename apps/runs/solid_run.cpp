#include "base/errors.hpp"
#include "output/folder/files.hpp"
#include "output/folder/folder_lock.hpp"
#include "output/solid/drawn_meshes.hpp"
#include "output/solid/solid_picture.hpp"
#include "output/solid/solid_run_writer.hpp"
#include "runs/checkpoints.hpp"
#include "runs/run.hpp"
#include "runs/solid_resume.hpp"
#include "runs/words.hpp"
#include "sim/solid/solid_plan.hpp"
#include "sim/study/run.hpp"
#include "sim/study/solid_accuracy.hpp"

namespace reye::apps {

namespace {

/// A run that resumes takes the meshes that it had: the mesher might not make them again.
sim::SolidProblem solid_problem(const scene::SolidScene& scene, const RunPlace& place) {
  if (place.restart)
    if (auto geometry = output::load_meshes(place.dir, scene.fixed_sha256))
      return sim::prepare(scene, std::move(*geometry));
  return sim::prepare(scene);
}

/// The folder made ready for a new run, whose start is its first checkpoint.
void begin_solid_folder(const SolidCheckpoints& run, const sim::SolidRunState& state, output::SolidRunWriter& writer,
                        Checkpoints& checkpoints) {
  writer.begin();
  output::save_meshes(writer.dir(), run.problem);
  output::atomic_write(writer.dir() + "/scene.svg", output::solid_picture(run.problem.scene, run.problem.inputs));
  checkpoints.start(snapshot_of(run, state, writer.counters()));
}

sim::SolidObserver solid_observer(output::SolidRunWriter& writer, const RunWatch& watch) {
  sim::SolidObserver o;
  o.progress = watch.progress;
  o.increment = [&](const sim::SolidIncrement& row) { writer.increment(row); };
  o.frame = [&](const sim::SolidFrame& frame) { writer.frame(frame); };
  o.remesh = [&](const sim::SolidRemeshRecord& r) { writer.remesh(r); };
  o.state = [&watch](const sim::SolidRunState& state) {
    if (watch.block) watch.block(state.cycle);
  };
  o.log = [&](const std::string& text) { writer.log(text); };
  o.interrupted = watch.interrupted;
  return o;
}

sim::SolidObserver solid_observer(const SolidCheckpoints& run, output::SolidRunWriter& writer, Checkpoints& checkpoints,
                                  const RunWatch& watch) {
  sim::SolidObserver o = solid_observer(writer, watch);
  o.state = [&, outside = std::move(o.state)](const sim::SolidRunState& state) {
    checkpoints.reach(snapshot_of(run, state, writer.counters()), standing_of(run.problem, state));
    outside(state);
  };
  return o;
}

RunResult<sim::SolidSummary> run_in_memory(const sim::SolidProblem& problem, output::SolidRunWriter& writer,
                                           const RunWatch& watch) {
  writer.begin();
  auto summary = sim::run(problem, sim::initial_solid_state(problem), solid_observer(writer, watch));
  writer.finish(summary);
  return {std::move(summary), writer.tables()};
}

}  // namespace

RunResult<sim::SolidSummary> run(const scene::SolidScene& scene, const RunPlace& place, const RunWatch& watch) {
  const auto extension = place.restart ? solid_extension_in(place.dir, scene) : std::nullopt;
  if (!place.dir.empty()) open_or_refuse(place.dir, scene.name, scene.sha256, extension.has_value(), place.force);
  const sim::SolidProblem problem = solid_problem(scene, place);
  const sim::SolidPlan plan = sim::solid_plan(problem);
  refuse_what_does_not_fit(plan);
  output::SolidRunWriter writer(place.dir, problem.scene);
  if (extension)
    for (const auto& change : extension->changes) writer.log("extended: " + change);
  if (watch.begins) watch.begins(plan.lines, in_words(problem.warnings));
  if (place.dir.empty()) return run_in_memory(problem, writer, watch);
  const SolidCheckpoints run(problem);
  Checkpoints checkpoints(place.dir, problem.scene.checkpoint_s);
  SolidStart start{sim::initial_solid_state(problem), {}};
  std::optional<Resumption> resumption;  // refused before anything is made
  if (place.restart) resumption = resumption_of(place.dir, run, extension, start);
  const output::FolderLock lock(place.dir);
  if (resumption)
    resume_folder(*resumption, snapshot_of(run, start.state, resumption->counters), standing_of(problem, start.state),
                  writer, checkpoints, watch);
  else
    begin_solid_folder(run, start.state, writer, checkpoints);
  RunResult<sim::SolidSummary> result;
  play_guarded(place.dir, run.origin, [&] {
    result.summary = sim::run(problem, std::move(start.state), solid_observer(run, writer, checkpoints, watch),
                              std::move(start.assembly));
    checkpoints.finish();
    writer.finish(result.summary);
  });
  return result;
}

}  // namespace reye::apps
