#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runs/resumption.hpp"
#include "sim/solid/solid_problem.hpp"
#include "sim/solid/solid_state.hpp"

/// States of runs of solids as checkpoints.
namespace reye::apps {

/// What the checkpoints of one run of solids have in common; `problem` must outlive it and its snapshots.
struct SolidCheckpoints {
  explicit SolidCheckpoints(const sim::SolidProblem& of);
  const sim::SolidProblem& problem;
  std::vector<std::uint64_t> meshes;  ///< checksums of those that are drawn
  sim::SolidMeshes drawn;
  output::Origin origin;
};

Snapshot snapshot_of(const SolidCheckpoints& run, sim::SolidRunState state, output::Counters counters);

Standing standing_of(const sim::SolidProblem& problem, const sim::SolidRunState& state);

/// A state and the equations on which it resumes, where its first increments are solved.
struct SolidStart {
  sim::SolidRunState state;
  std::optional<sim::SolidAssembly> assembly;
};

/// Where a run resumes: see the other `resumption_of`. `start` becomes what the checkpoint holds.
Resumption resumption_of(const std::string& dir, const SolidCheckpoints& run,
                         const std::optional<scene::Extension>& extension, SolidStart& start);

/// How a scene of solids extends the run in the folder: see `extension_in`. A file of the scene that has changed is
/// named.
std::optional<scene::Extension> solid_extension_in(const std::string& dir, const scene::SolidScene& scene);

}  // namespace reye::apps
