#pragma once
#include <map>
#include <string>

#include "output/run/run_files.hpp"
#include "output/solid/solid_inputs.hpp"
#include "output/solid/solid_tables.hpp"
#include "scene/solid/solid_scene.hpp"
#include "sim/solid/solid_records.hpp"

namespace reye::output {

/// Writes the output folder of one run of solids, or keeps its tables, as RunWriter does for the plane. Every member
/// throws std::runtime_error when a write fails. Call begin() for a new run or resume() for a restarted one before
/// anything is written; hold the FolderLock meanwhile.
class SolidRunWriter {
 public:
  SolidRunWriter(std::string dir, const scene::SolidScene& scene);

  void begin();                           ///< removes the former results and starts the new ones
  void resume(const Counters& counters);  ///< cuts tables and series back to the checkpoint
  void extend() const { folder_.extend(); }
  void increment(const sim::SolidIncrement& record);
  void remesh(const sim::SolidRemeshRecord& record);
  void frame(const sim::SolidFrame& frame);       ///< the first one brings scene.svg where it is missing
  void finish(const sim::SolidSummary& summary);  ///< summary and report
  void log(const std::string& line) { folder_.log(line); }

  const Counters& counters() const { return folder_.counters(); }
  const std::string& dir() const { return folder_.dir(); }
  const std::map<std::string, std::string>& tables() const { return folder_.kept(); }  ///< in memory: by file name

 private:
  void draw_scene(const sim::SolidFrame& frame) const;

  scene::SolidScene scene_;
  RunFiles folder_;
  SolidInputs inputs_;
  SolidColumns columns_;
  std::vector<std::string> bodies_;  ///< names
};

}  // namespace reye::output
