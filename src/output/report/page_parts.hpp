#pragma once
#include <filesystem>
#include <string>

#include "output/report/run_data.hpp"

/// Parts of the page of every run, of the plane and of solids.
namespace reye::output {

/// Title, status and its reason, sides of the contacts; `kind`: what was computed, in words.
std::string page_heading(const RunData& run, const std::string& kind);

std::string warning_list(const RunData& run);

/// The picture of the scene that the run drew before it began; none in folders that lack it.
std::string scene_section(const std::string& dir);

/// All that went in, as the user wrote it.
std::string scene_file(const RunData& run);

/// The folder for separate figures, without those of a former report.
std::filesystem::path emptied_figures(const std::string& dir);

}  // namespace reye::output
