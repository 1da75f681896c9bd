#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "output/folder/folder.hpp"

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

/// The growing files of one run, whatever their content: tables, frames for ParaView and the log. Every member throws
/// std::runtime_error when a write fails. Call begin() for a new run or resume() for a restarted one before anything is
/// written; hold the FolderLock meanwhile. Without a folder the tables are kept in memory; frames, log and report are
/// left out, and such a run cannot resume.
class RunFiles {
 public:
  RunFiles(std::string dir, Identity identity, bool paraview);  ///< `dir` is empty: in memory

  void begin(const std::string& history_header);  ///< removes the former results and starts the new ones
  void resume(const Counters& counters);          ///< cuts tables and series back to the checkpoint
  void extend() const;  ///< marks the folder as that of this scene, which extends the one that was run
  void add_history(const std::string& row);
  void add_remesh(const std::string& header, const std::string& row);

  /// Counts a frame; its number, from 0. Its rows and files follow.
  std::size_t begin_frame(double cycle);
  /// Rows of a surface of the frame; the table is made where they are its first.
  void add_surface(const std::string& file, const std::string& header, const std::string& rows, std::size_t count);
  /// Replaces a file as a whole.
  void put(const std::string& file, const std::string& text);
  /// Whether frames for ParaView are wanted.
  bool paraview() const { return paraview_; }
  /// The files of the last frame, and the collections with it.
  void write_frame(const std::string& bodies_vtu, const std::string& surfaces_vtp) const;
  void log(const std::string& line);                    ///< may be called before begin(): kept until then
  void make_report(const std::function<void()>& make);  ///< makes it and enters its wall time in the log

  const Identity& identity() const { return identity_; }
  const Counters& counters() const { return counters_; }
  const std::string& dir() const { return dir_; }
  bool in_memory() const { return dir_.empty(); }
  const std::map<std::string, std::string>& kept() const { return kept_; }  ///< in memory: texts by file name
  std::string path(const std::string& file) const;

 private:
  void add(const std::string& file, const std::string& text);
  void write_collections() const;
  void remove_frames_from(std::size_t index) const;
  void flush_log();

  std::string dir_;
  Identity identity_;
  bool paraview_ = true;
  Counters counters_;
  bool started_ = false;
  std::string early_log_;
  std::map<std::string, std::string> kept_;
};

}  // namespace reye::output
