#pragma once
#include <optional>
#include <string>
#include <vector>

/// The frames of a run on disk, from whatever kind of scene, finished or not.
namespace reye::output {

/// Cycles of the frames whose bodies and surfaces are there, from the first on. Throws base::InputError where the run
/// has none, or where a file is damaged.
std::vector<double> frame_cycles(const std::string& dir);

/// Which frame was asked for: by its number, or the last one at a cycle; with neither the last of all. Throws
/// base::InputError that names the frames there are.
std::size_t chosen_frame(const std::vector<double>& cycles, const std::optional<double>& cycle,
                         const std::optional<long>& frame);

}  // namespace reye::output
