#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "output/folder/folder.hpp"
#include "output/run/checkpoint.hpp"
#include "runs/checkpoints.hpp"
#include "runs/run.hpp"
#include "scene/extension.hpp"

/// From which checkpoint of its folder a run resumes, whatever is computed.
namespace reye::apps {

/// The checkpoint that was chosen; its state is where `Reading` has put it.
struct Resumption {
  output::Counters counters;
  bool previous = false;           ///< whether it is the checkpoint before the last
  bool extends = false;            ///< the run of a scene that this one extends
  std::vector<std::string> notes;  ///< notes to report: checkpoints that were refused, another build
};

/// How checkpoints are read that hold one kind of state. Each call of the first two puts the state in place of the one
/// before, and throws for a checkpoint that no run can resume from.
struct Reading {
  output::Origin own;
  std::function<void(const output::Checkpoint&)> resume;
  /// Into a state of the scene that extends the run; the issues where that is not possible.
  std::function<std::vector<base::Issue>(const output::Checkpoint&)> extend;
  std::function<Standing()> standing;  ///< of the state that was read last
  std::function<base::InputError(const std::vector<base::Issue>&)> located;
};

/// The newest checkpoint in the folder that is whole and whose tables are there; changes nothing. Throws
/// base::InputError with every reason when there is none. An extension that the run allows resumes from there, too, but
/// from before its last block where that ended the run or was under way.
Resumption resumption_of(const std::string& dir, const Reading& reading,
                         const std::optional<scene::Extension>& extension);

/// The run of a folder that a scene of this name may extend: of another scene, whose text is known; empty otherwise.
std::optional<output::Identity> extensible_run(const std::string& dir, const std::string& name,
                                               const std::string& sha256, const std::string& fixed_sha256);

/// How the scene extends the one whose run the folder holds, for --restart: empty where it is that scene, has another
/// name, or the former text is not known. Throws base::InputError with every value that may not differ.
template <class Scene>
std::optional<scene::Extension> extension_in(const std::string& dir, const Scene& scene) {
  const auto holder = extensible_run(dir, scene.name, scene.sha256, scene.fixed_sha256);
  if (!holder) return {};
  return extension_of(holder->scene_text, holder->fixed_sha256, scene);
}

/// Throws base::InputError where a run of this scene may not use the folder; one that extends the run there may.
void open_or_refuse(const std::string& dir, const std::string& name, const std::string& sha256, bool extends,
                    bool force);

/// Reports the notes of a resumption and makes the checkpoint it chose the newest one.
void accept(const std::string& dir, const Resumption& resumption, const RunWatch& watch);

/// The folder cut back to the checkpoint that was chosen; `state` and `standing` are those it holds.
template <class Writer>
void resume_folder(const Resumption& resumption, const Snapshot& state, Standing standing, Writer& writer,
                   Checkpoints& checkpoints, const RunWatch& watch) {
  accept(writer.dir(), resumption, watch);
  writer.resume(resumption.counters);
  if (!resumption.extends) return checkpoints.resume(standing);
  checkpoints.start(state);  // in this order: either scene finds a checkpoint to resume from, whenever a kill comes
  writer.extend();
}

/// Plays a run. A failed write ends it; the error says whether it can resume.
void play_guarded(const std::string& dir, const output::Origin& own, const std::function<void()>& play);

}  // namespace reye::apps
