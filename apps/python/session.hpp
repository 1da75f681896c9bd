#pragma once
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "runs/calibrate_request.hpp"
#include "runs/place.hpp"

/// What the Python module asks of the program, in plain values of any kind of scene: the file that names pybind11
/// includes nothing of the rooms. Every function throws base::InputError for bad input, std::runtime_error otherwise.
namespace reye::apps {

/// A scene as text.
struct Text {
  std::string text, path;       ///< the path from which its geometry files count; the file need not hold the text
  bool trust_geometry = false;  ///< geometry scripts may use all of gmsh's language
};

using Lines = std::vector<std::string>;

/// A run at the end of a block.
struct BlockEnd {
  std::string step;
  double cycle = 0.0, cycles = 0.0;  ///< done, and of all steps
  double fraction = 0.0;             ///< of the step
  double depth_max_mm = 0.0;
  double increments = 0.0, increments_left = 0.0;  ///< solved, and an estimate of those to be solved
};

struct SessionWatch {
  std::function<void()> begins;                ///< once the scene is known to be possible; nothing is written yet
  std::function<void(const BlockEnd&)> block;  ///< at the ends of blocks
  std::function<bool()> interrupted;           ///< asked after each increment; true ends the run there
};

struct SessionRun {
  std::map<std::string, std::string> tables;  ///< by file name, where no folder holds them
  Lines notes;                                ///< about the checkpoint from which the run resumed
};

struct SessionPlan {
  Lines lines, skipped, warnings;
  Lines in_words;                          ///< of the forecast
  std::map<std::string, double> forecast;  ///< its numbers, by names with units
};

struct SessionCheck {
  Lines lines, warnings;
};

/// A column of a table: numbers, or texts where `texts` is not empty.
struct Column {
  std::string name;
  std::vector<double> numbers;
  Lines texts;
};

/// Reads the scene and drops it: for its errors.
void read(const Text& scene);

/// `threads`: cores to compute on; 0: all physical ones.
SessionRun run(const Text& scene, const RunPlace& place, int threads, const SessionWatch& watch);

/// `trial_s`: seconds of the run that are played to judge its time; 0: none.
SessionPlan plan(const Text& scene, double trial_s, int threads);

SessionCheck check(const Text& scene);

/// A calibration whose results lie in its folder.
struct SessionCalibration {
  std::string dir, failure;
  Lines warnings;
};

/// `free`: KEY=LOW:HIGH. `interrupted`: asked after each increment; true ends it without a result.
SessionCalibration calibrate(const Text& scene, const CalibrateRequest& request, int threads,
                             const std::function<bool()>& interrupted);

/// The scene's text with `value`, as written in TOML, at `key`.
std::string text_with(const Text& scene, const std::string& key, const std::string& value);

/// The rule that the key breaks in this scene; empty where it is fine.
std::string rule_of_key(const Text& scene, const std::string& key);

/// The columns of a table of an output folder.
std::vector<Column> columns_of(const std::string& csv);

}  // namespace reye::apps
