#pragma once
#include <chrono>
#include <optional>

#include "output/run/checkpoint.hpp"
#include "output/run/run_writer.hpp"
#include "scene/extension.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"
#include "sim/problem/system.hpp"

namespace reye::apps {

/// Checkpoints of a run at its block ends, `output.checkpoint_s` of wall time apart or more. Where the run ends the
/// last two are the end and the start of its last block, which an extension of the run plays differently, since it is
/// no longer the last. All members throw std::runtime_error when the disk refuses.
class Checkpoints {
 public:
  Checkpoints(const sim::Problem& problem, const output::RunWriter& writer) : problem_(problem), writer_(writer) {}

  void start(const sim::State& state) { keep(state, writer_.counters()); }
  void block_end(const sim::State& state);
  void finish();  ///< the last block end is kept, too

 private:
  using clock = std::chrono::steady_clock;
  struct BlockEnd {
    sim::State state;
    output::Counters counters;  ///< the rows and frames of the folder that belong to it
  };
  void keep(const sim::State& state, const output::Counters& counters);

  const sim::Problem& problem_;
  const output::RunWriter& writer_;
  clock::time_point kept_at_ = clock::now();
  std::optional<BlockEnd> waiting_;
};

/// The state from which a run resumes.
struct Resumption {
  sim::State state;
  output::Counters counters;
  bool previous = false;           ///< whether it is the checkpoint before the last
  bool extends = false;            ///< the run of a scene that this one extends
  std::vector<std::string> notes;  ///< notes to report: checkpoints that were refused, another build
};

/// How the scene extends the one whose run the folder holds, for --restart: empty where it is that scene, has another
/// name, or the former text is not known. Throws base::InputError with every value that may not differ.
std::optional<scene::Extension> extension_in(const std::string& dir, const scene::Scene& scene);

/// The newest checkpoint of this problem in the folder that is whole and whose tables are there; changes nothing.
/// Throws base::InputError with every reason when there is none. An extension that the run allows resumes from there,
/// too, but from before its last block where that ended the run.
Resumption resumption_of(const std::string& dir, const sim::Problem& problem,
                         const std::optional<scene::Extension>& extension, sim::Cache& cache);

/// Whether there is a checkpoint to resume from.
bool can_go_on(const std::string& dir, const sim::Problem& problem);

}  // namespace reye::apps
