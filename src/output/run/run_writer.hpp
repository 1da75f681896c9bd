#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "output/folder/folder.hpp"
#include "output/folder/tables.hpp"
#include "scene/scene.hpp"
#include "sim/problem/records.hpp"

namespace reye::output {

/// Size of the log from which on it takes no more lines.
inline constexpr std::uintmax_t most_log_bytes = 2000000;

/// The rows and frames of the folder that belong to a state: kept in its checkpoint, so that a restart drops later
/// output of the killed run.
struct Counters {
  long history_rows = 0;
  long remesh_rows = 0;
  std::map<std::string, long> surface_rows;  ///< by file name
  std::vector<double> frame_cycles;          ///< one per frame written

  bool operator==(const Counters&) const = default;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(history_rows, remesh_rows, surface_rows, frame_cycles);
  }
};

/// Writes the output folder of one run. Every member throws std::runtime_error when a write fails.
/// Call begin() for a new run or resume() for a restarted one before anything is written; hold the FolderLock
/// meanwhile.
class RunWriter {
 public:
  RunWriter(std::string dir, const scene::Scene& scene);

  void begin();                           ///< removes the former results and starts the new ones
  void resume(const Counters& counters);  ///< cuts tables and series back to the checkpoint
  void extend() const;  ///< marks the folder as that of this scene, which extends the one that was run
  void increment(const sim::IncrementRecord& record);
  void remesh(const sim::RemeshRecord& record);
  void frame(const sim::Frame& frame);
  void finish(const sim::Summary& summary);  ///< summary and report
  void log(const std::string& line);         ///< may be called before begin(): kept until then

  const Counters& counters() const { return counters_; }
  const std::string& dir() const { return dir_; }

 private:
  std::string path(const std::string& file) const;
  void write_collections() const;
  void remove_frames_from(std::size_t index) const;
  void flush_log();

  std::string dir_;
  Identity identity_;
  bool paraview_ = true;
  HistoryColumns columns_;
  Counters counters_;
  bool started_ = false;
  std::string early_log_;
};

}  // namespace reye::output
