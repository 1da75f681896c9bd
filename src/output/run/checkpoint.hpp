#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "output/run/run_writer.hpp"

/// Checkpoints: bytes of a state in a container with their origin and a checksum.
/// checkpoint/current.bin and, as a fallback, checkpoint/previous.bin.
namespace reye::output {

/// Origin of a checkpoint: the program that wrote it and the scene it ran.
struct Origin {
  std::string version;       ///< of the program
  std::string commit;        ///< that it was built from
  std::uint64_t layout = 0;  ///< of info and payload: a program with another one cannot read them
  std::string scene_sha256;
  std::string fixed_sha256{};                        ///< of the part of the scene that an extension of the run keeps
  std::map<std::string, std::string> file_sha256{};  ///< of the files of the scene, by their paths, where it names them
};

/// The origin of a run of this scene by this program, whose states have this layout.
Origin own_origin(std::uint64_t layout, const std::string& scene_sha256, const std::string& fixed_sha256 = {});

struct Checkpoint {
  Origin origin;
  Counters counters;  ///< rows and frames of the output folder that belong to the state
  std::string payload;
  bool ended = false;  ///< the run ended with this state: an extension of it resumes from the one before
};

/// What becomes of the newest checkpoint so far when another one is saved.
enum class Former {
  kept,     ///< it becomes the previous one
  replaced  ///< the previous one stays
};

/// Syncs the tables that the counters name, writes the new checkpoint beside the old, then renames: at any moment one
/// intact checkpoint exists with its tables, even after a power cut.
void save_checkpoint(const std::string& dir, const Checkpoint& checkpoint, Former former = Former::kept);

struct CheckpointSearch {
  std::optional<Checkpoint> found;  ///< the newest that may be used
  bool previous = false;            ///< it is the one before the last
  std::vector<std::string>
      refusals;  ///< why a newer one was not usable, or none was: missing, truncated, altered, other scene,
                 ///< other version or layout, tables shorter than it says, or what `examine` threw
};

/// Throws for a checkpoint that no run can resume from, with the reason.
using Examine = std::function<void(const Checkpoint&)>;

/// The checkpoint to restart from: the current one, else the previous. It must be of the scene of `own`, or, where that
/// is empty (""), of one with its `fixed_sha256`.
CheckpointSearch load_checkpoint(const std::string& dir, const Origin& own, const Examine& examine = {});

/// Hashes of the files of the scene whose run the folder holds, from its newest checkpoint of this layout; none where
/// there is no such checkpoint.
std::map<std::string, std::string> files_of_run(const std::string& dir, std::uint64_t layout);

/// Replaces a current checkpoint that was refused by the previous one, so that the next save keeps it.
void restore_previous(const std::string& dir);

/// The container alone: 8 bytes of magic, length and checksum of the body, then the body.
std::string packed(const Checkpoint& checkpoint);

/// The checkpoint in a container of any origin; throws std::runtime_error with the reason where it is damaged or of a
/// layout other than `layout`.
Checkpoint unpacked(const std::string& bytes, std::uint64_t layout);

}  // namespace reye::output
