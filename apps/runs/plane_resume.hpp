#pragma once
#include <string>

#include "runs/resumption.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"
#include "sim/problem/system.hpp"

/// States of plane runs as checkpoints.
namespace reye::apps {

output::Origin origin_of(const sim::Problem& problem);

/// `problem` must outlive the snapshot.
Snapshot snapshot_of(const sim::Problem& problem, sim::State state, output::Counters counters);

Standing standing_of(const sim::Problem& problem, const sim::State& state);

/// Where a run resumes: see the other `resumption_of`. `state` becomes the one of the checkpoint.
Resumption resumption_of(const std::string& dir, const sim::Problem& problem,
                         const std::optional<scene::Extension>& extension, sim::State& state, sim::Cache& cache);

}  // namespace reye::apps
