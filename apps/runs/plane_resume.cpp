#include "runs/plane_resume.hpp"

#include "output/run/state_archive.hpp"
#include "scene/read.hpp"
#include "sim/march/extend.hpp"
#include "sim/measure/intact.hpp"
#include "sim/problem/ending.hpp"

namespace reye::apps {

output::Origin origin_of(const sim::Problem& problem) {
  return output::own_origin(output::state_layout(), problem.scene.sha256, problem.scene.fixed_sha256);
}

Snapshot snapshot_of(const sim::Problem& problem, sim::State state, output::Counters counters) {
  return [&problem, state = std::move(state), counters = std::move(counters)] {
    return output::Checkpoint{origin_of(problem), counters, output::state_to_bytes(state), sim::at_end(problem, state)};
  };
}

Standing standing_of(const sim::Problem& problem, const sim::State& state) {
  return sim::at_end(problem, state) ? Standing::at_end : Standing::between_blocks;
}

Resumption resumption_of(const std::string& dir, const sim::Problem& problem,
                         const std::optional<scene::Extension>& extension, sim::State& state, sim::Cache& cache) {
  const Reading reading{origin_of(problem),
                        [&](const output::Checkpoint& checkpoint) {
                          state = output::state_from_bytes(checkpoint.payload);
                          sim::check_state(problem, state, cache);
                        },
                        [&](const output::Checkpoint& checkpoint) {
                          state = output::state_from_bytes(checkpoint.payload);
                          return sim::extend(problem, extension->limits, extension->cycles_key, state, cache);
                        },
                        [&] { return standing_of(problem, state); },
                        [&](const std::vector<base::Issue>& issues) { return scene::located(problem.scene, issues); }};
  return resumption_of(dir, reading, extension);
}

}  // namespace reye::apps
