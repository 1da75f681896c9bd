#pragma once
#include <map>
#include <string>

#include "output/folder/tables.hpp"
#include "output/run/run_files.hpp"
#include "scene/scene.hpp"
#include "sim/problem/records.hpp"

namespace reye::output {

/// Writes the output folder of one run, or keeps its tables in memory where the folder has no name. Every member throws
/// std::runtime_error when a write fails. Call begin() for a new run or resume() for a restarted one before anything is
/// written; hold the FolderLock meanwhile.
class RunWriter {
 public:
  RunWriter(std::string dir, const scene::Scene& scene);

  void begin();  ///< see RunFiles
  void resume(const Counters& counters) { folder_.resume(counters); }
  void extend() const { folder_.extend(); }
  void increment(const sim::IncrementRecord& record);
  void remesh(const sim::RemeshRecord& record);
  void frame(const sim::Frame& frame);
  void finish(const sim::Summary& summary);  ///< summary and report
  void log(const std::string& line) { folder_.log(line); }

  const Counters& counters() const { return folder_.counters(); }
  const std::string& dir() const { return folder_.dir(); }
  const std::map<std::string, std::string>& tables() const { return folder_.kept(); }  ///< in memory: by file name

 private:
  RunFiles folder_;
  HistoryColumns columns_;
};

}  // namespace reye::output
