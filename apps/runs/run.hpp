#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "runs/place.hpp"
#include "scene/scene.hpp"
#include "scene/solid/solid_scene.hpp"
#include "sim/problem/records.hpp"
#include "sim/solid/solid_records.hpp"

/// A run of a scene as the command and the Python module share it: from the scene to its results, in a folder or in
/// memory, from the start or from a checkpoint.
namespace reye::apps {

/// Callbacks that observe a run and may stop it; every member may be empty.
struct RunWatch {
  /// Once the scene is known to be possible, before anything is written: sentences of the plan, and warnings with
  /// their lines.
  std::function<void(const std::vector<std::string>& plan, const std::vector<std::string>& warnings)> begins;
  std::function<void(const sim::Progress&)> progress;  ///< after each increment
  std::function<void(double cycle)> block;  ///< at the ends of blocks; of solids also of increments played one by one
  std::function<bool()> interrupted;        ///< asked after each increment; true ends the run there
  std::function<void(const std::string&)> note;  ///< about the checkpoint from which the run resumes
};

/// How a run ended, and its tables by file name where no folder holds them.
template <class Summary>
struct RunResult {
  Summary summary;
  std::map<std::string, std::string> tables;
};

/// Runs the scene. Throws base::InputError, before anything is written, for a scene or a folder that cannot be used;
/// std::runtime_error when a write fails, with whether the run can resume.
RunResult<sim::Summary> run(const scene::Scene& scene, const RunPlace& place, const RunWatch& watch);
RunResult<sim::SolidSummary> run(const scene::SolidScene& scene, const RunPlace& place, const RunWatch& watch);

}  // namespace reye::apps
