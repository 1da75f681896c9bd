#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "output/run_writer.hpp"

/// Checkpoints: bytes of a state in a container that knows whose they are and whether they are whole.
/// checkpoint/current.bin and, as a fallback, checkpoint/previous.bin.
namespace reye::output {

/// Whose a checkpoint is: the program that wrote it and the scene it ran.
struct Origin {
  std::string version;       ///< of the program
  std::string commit;        ///< that it was built from
  std::uint64_t layout = 0;  ///< of info and payload: a program with another one cannot read them
  std::string scene_sha256;
  std::string fixed_sha256{};  ///< of what of the scene an extension of the run keeps
};

/// That of a run of this scene by this program.
Origin own_origin(const std::string& scene_sha256, const std::string& fixed_sha256 = {});

struct Checkpoint {
  Origin origin;
  Counters counters;  ///< what of the output folder belongs to the state
  std::string payload;
  bool ended = false;  ///< the run ended with this state: an extension of it resumes from the one before
};

/// Syncs the tables that the counters name, writes the new checkpoint beside the old, then renames: at any moment one
/// whole checkpoint is there with its tables, after a power cut, too.
void save_checkpoint(const std::string& dir, const Checkpoint& checkpoint);

struct CheckpointSearch {
  std::optional<Checkpoint> found;  ///< the newest that may be used
  bool previous = false;            ///< it is the one before the last
  std::vector<std::string>
      refusals;  ///< why a newer one was not, or why none: missing, truncated, altered, other scene,
                 ///< other version or layout, tables shorter than it says, or what `examine` threw
};

/// Throws for a checkpoint that no run can resume from, with the reason.
using Examine = std::function<void(const Checkpoint&)>;

/// The checkpoint to restart from: the current one, else the previous. Of the scene that `own` names; where it names
/// none
/// (""), of one with its `fixed_sha256`.
CheckpointSearch load_checkpoint(const std::string& dir, const Origin& own, const Examine& examine = {});

/// Puts the previous checkpoint into the place of a current one that was refused, so that the next save keeps it.
void restore_previous(const std::string& dir);

/// The container alone: 8 bytes of magic, length and FNV-1a checksum of the body, then the body.
std::string packed(const Checkpoint& checkpoint);

/// The checkpoint in a whole container, whose ever it is; throws std::runtime_error with the reason where it is not
/// whole or, but for its origin, of another layout than `layout`.
Checkpoint unpacked(const std::string& bytes, std::uint64_t layout);

}  // namespace reye::output
