#pragma once
#include <optional>
#include <string>
#include <vector>

#include "output/run_writer.hpp"

/// Checkpoints: bytes of a state in a container that knows whose they are and whether they are whole.
/// checkpoint/current.bin and, as a fallback, checkpoint/previous.bin.
namespace reye::output {

struct CheckpointInfo {
  std::string version;       ///< of the program that wrote it
  std::string scene_sha256;
  Counters counters;         ///< what of the output folder belongs to the state

  template <class Archive>
  void serialize(Archive& archive) {
    archive(version, scene_sha256, counters);
  }
};

struct Checkpoint {
  CheckpointInfo info;
  std::string payload;
};

/// Writes the new checkpoint beside the old, then renames: at any moment one whole checkpoint is there.
void save_checkpoint(const std::string& dir, const Checkpoint& checkpoint);

struct CheckpointSearch {
  std::optional<Checkpoint> found;    ///< the newest that may be used
  std::vector<std::string> refusals;  ///< why a newer one was not, or why none: missing, truncated, altered,
                                      ///< other scene, other version
};

/// The checkpoint to restart from: the current one, else the previous.
CheckpointSearch load_checkpoint(const std::string& dir, const std::string& version, const std::string& scene_sha256);

/// The container alone: 8 bytes of magic, length and FNV-1a checksum of the body, then the body.
std::string packed(const Checkpoint& checkpoint);

}  // namespace reye::output
