#include "output/export/run_frames.hpp"

#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/errors.hpp"
#include "output/folder/text.hpp"
#include "output/report/run_data.hpp"
#include "output/report/vtk_reading.hpp"

namespace reye::output {

namespace fs = std::filesystem;

namespace {

/// The cycle of a frame, of its file of surfaces, which is the smaller one.
double cycle_of_frame(const std::string& path) {
  const auto reader = opened<vtkXMLPolyDataReader>(path, WantedArrays{});
  return array_of(*reader->GetOutput()->GetFieldData(), "TimeValue", 1, path).GetComponent(0, 0);
}

bool is_same_cycle(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max({1.0, std::abs(a), std::abs(b)}); }

/// The distinct cycles in words, of many those about the one that was asked for.
std::string cycles_in_words(std::vector<double> cycles, double near) {
  constexpr std::size_t most = 12;
  cycles.erase(std::unique(cycles.begin(), cycles.end()), cycles.end());
  std::size_t first = 0;
  if (cycles.size() > most) {
    const auto at = static_cast<std::size_t>(std::lower_bound(cycles.begin(), cycles.end(), near) - cycles.begin());
    first = std::min(at - std::min(at, most / 2), cycles.size() - most);
  }
  const std::size_t last = std::min(first + most, cycles.size());
  std::string text = first > 0 ? "..., " : "";
  for (std::size_t k = first; k < last; ++k) text += (k > first ? ", " : "") + number(cycles[k]);
  return text + (last < cycles.size() ? ", ..." : "");
}

}  // namespace

std::vector<double> frame_cycles(const std::string& dir) {
  std::vector<double> cycles;
  const auto is_there = [&](const char* stem, const char* ext) {
    return fs::is_regular_file(frame_path(dir, stem, ext, cycles.size()));
  };
  while (is_there("bodies", "vtu") && is_there("surface", "vtp"))
    cycles.push_back(cycle_of_frame(frame_path(dir, "surface", "vtp", cycles.size())));
  if (cycles.empty())
    throw base::InputError(
        {{"dir", dir,
          "its run has no frames of bodies: it has not reached one, or its scene has output.frames.paraview = false"}});
  return cycles;
}

std::size_t chosen_frame(const std::vector<double>& cycles, const std::optional<double>& cycle,
                         const std::optional<long>& frame) {
  if (frame) {
    if (*frame >= 0 && static_cast<std::size_t>(*frame) < cycles.size()) return static_cast<std::size_t>(*frame);
    throw base::InputError(
        {{"--frame", std::to_string(*frame), "the run has frames 0 to " + std::to_string(cycles.size() - 1)}});
  }
  if (!cycle) return cycles.size() - 1;
  for (std::size_t k = cycles.size(); k-- > 0;)
    if (is_same_cycle(cycles[k], *cycle)) return k;
  throw base::InputError(
      {{"--cycle", number(*cycle), "the run has no frame there, but at " + cycles_in_words(cycles, *cycle)}});
}

}  // namespace reye::output
