#pragma once
#include <string>
#include <vector>

#include "commands.hpp"
#include "runs/run.hpp"

/// Runs and texts as a terminal shows them.
namespace reye::apps {

/// Prints texts on the output.
void tell_lines(const std::vector<std::string>& lines);

/// Prints warnings on the error stream, so that they are seen even where the output goes into a file.
void tell_warnings(const std::vector<std::string>& warnings);

/// What a run says at its end, quiet or not: its warnings and, unless it is done, why it is not.
void tell_end(const std::vector<std::string>& warnings, const std::string& reason);

/// The exit code of a run that ended so.
int code_of(sim::RunStatus status);

/// Runs the scene into the folder with plan, warnings and progress shown, unless the request is to be quiet; Ctrl-C and
/// its like stop it once it has begun.
sim::Summary shown_run(const Request& request, const scene::Scene& scene, const std::string& dir);
sim::SolidSummary shown_run(const Request& request, const scene::SolidScene& scene, const std::string& dir);

}  // namespace reye::apps
