#include "runs/solid_resume.hpp"

#include "output/solid/drawn_meshes.hpp"
#include "output/solid/solid_archive.hpp"
#include "scene/solid/solid_extension.hpp"
#include "scene/solid/solid_located.hpp"
#include "sim/solid/solid_intact.hpp"

namespace reye::apps {

SolidCheckpoints::SolidCheckpoints(const sim::SolidProblem& of)
    : problem(of),
      meshes(output::mesh_checksums(of)),
      drawn(sim::drawn_meshes(of)),
      origin(output::own_origin(output::solid_state_layout(), of.scene.sha256, of.scene.fixed_sha256)) {
  origin.file_sha256 = of.scene.file_sha256;
}

Snapshot snapshot_of(const SolidCheckpoints& run, sim::SolidRunState state, output::Counters counters) {
  return [&run, state = std::move(state), counters = std::move(counters)] {
    return output::Checkpoint{run.origin, counters, output::solid_state_to_bytes(state, run.meshes, run.drawn),
                              sim::at_end(run.problem, state)};
  };
}

Standing standing_of(const sim::SolidProblem& problem, const sim::SolidRunState& state) {
  if (sim::at_end(problem, state)) return Standing::at_end;
  return state.increment > 0 ? Standing::within_block : Standing::between_blocks;
}

Resumption resumption_of(const std::string& dir, const SolidCheckpoints& run,
                         const std::optional<scene::Extension>& extension, SolidStart& start) {
  const auto read = [&](const output::Checkpoint& checkpoint) {
    start.state = output::solid_state_from_bytes(checkpoint.payload, run.meshes, run.drawn);
    start.assembly.reset();  // before the next one is made: they are large
  };
  const auto resume = [&](const output::Checkpoint& checkpoint) {
    read(checkpoint);
    start.assembly = sim::check_state(run.problem, start.state);
  };
  const auto extend = [&](const output::Checkpoint& checkpoint) {
    read(checkpoint);
    auto issues = sim::extend(run.problem, extension->cycles_key, start.state);
    if (issues.empty()) start.assembly = sim::check_state(run.problem, start.state);
    return issues;
  };
  return resumption_of(dir,
                       {run.origin, resume, extend, [&] { return standing_of(run.problem, start.state); },
                        [&](const std::vector<base::Issue>& issues) { return located(run.problem.scene, issues); }},
                       extension);
}

std::optional<scene::Extension> solid_extension_in(const std::string& dir, const scene::SolidScene& scene) {
  const auto holder = extensible_run(dir, scene.name, scene.sha256, scene.fixed_sha256);
  if (!holder || !holder->solid) return {};
  const auto changed = scene::changed_files(scene, output::files_of_run(dir, output::solid_state_layout()));
  if (!changed.empty()) throw located(scene, changed);
  return extension_in(dir, scene);
}

}  // namespace reye::apps
