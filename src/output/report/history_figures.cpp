#include <algorithm>
#include <cmath>
#include <optional>

#include "output/folder/text.hpp"
#include "output/report/figures.hpp"
#include "output/report/profiles.hpp"

namespace reye::output {

namespace {

bool any_nonzero(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double v) { return std::isfinite(v) && v != 0.0; });
}

void add_energy(const RunData& run, std::vector<Figure>& all) {
  const std::string energy = suffixes(run.identity.analysis).energy;
  const auto& y = run.history.column("energy_" + energy);
  const auto& cycle = run.history.column("cycle");
  if (!any_nonzero(y)) return;
  const bool ring = run.identity.analysis == base::Analysis::axisymmetric;
  Figure figure{.id = "energy",
                .title = "Energy dissipated by friction",
                .x_label = "cycles",
                .y_label = ring ? "energy, mJ" : "energy, mJ per mm"};
  const bool cycles = any_nonzero(cycle);
  Line line{.x = cycle, .y = y};
  if (!cycles) {
    figure.x_label = "increment";
    for (std::size_t i = 0; i < line.x.size(); ++i) line.x[i] = static_cast<double>(i + 1);
  }
  figure.y_from_zero = true;
  figure.lines.push_back(std::move(line));
  all.push_back(std::move(figure));
}

/// The largest pressure of a contact at the ends of blocks, and between which values it goes inside their cycles.
void add_pressure(const RunData& run, const ContactData& contact, std::vector<Figure>& all) {
  const auto& cycle = run.history.column("cycle");
  const auto& pressure = run.history.column(contact.name + "_pressure_max_MPa");
  const auto plays = plays_of(run.history);
  if (plays.size() < 2 || pressure.empty()) return;
  Figure figure{.id = "peak-" + file_part(contact.name),
                .title = title_of(run, contact, "Largest pressure over cycles"),
                .x_label = "cycles",
                .y_label = "pressure, MPa",
                .y_from_zero = true};
  Line most{.label = "most and least inside a cycle", .colour = "#9fb6d2", .width = 1.2},
      least{.colour = "#9fb6d2", .width = 1.2}, end{.label = "at its end", .dots = plays.size() <= 40};
  for (const auto& [first, past] : plays) {
    const auto from = pressure.begin() + static_cast<std::ptrdiff_t>(first),
               to = pressure.begin() + static_cast<std::ptrdiff_t>(past);
    const double at = cycle[past - 1];
    for (auto* line : {&most, &least, &end}) line->x.push_back(at);
    most.y.push_back(*std::max_element(from, to));
    least.y.push_back(*std::min_element(from, to));
    end.y.push_back(pressure[past - 1]);
  }
  figure.lines = {std::move(most), std::move(least), std::move(end)};
  all.push_back(std::move(figure));
}

/// Rows of the last play of the last step: back to where the progress starts again.
std::size_t last_play(const Table& history) {
  const auto& progress = history.column("progress");
  const auto& step = history.column("step");
  std::size_t first = history.rows() - 1;
  while (first > 0 && step[first - 1] == step[first] && progress[first - 1] < progress[first]) --first;
  return first;
}

/// A column of the history that is a support force: "pad, x", and whether it is that along y.
struct ForceColumn {
  std::string label;
  bool along_y = false;
};

std::optional<ForceColumn> force_column(const std::string& column) {
  const auto x = column.rfind("_force_x_"), y = column.rfind("_force_y_");
  const bool along_y = y != std::string::npos && (x == std::string::npos || y > x);
  const auto end = along_y ? y : x;
  if (end == std::string::npos) return std::nullopt;
  return ForceColumn{column.substr(0, end) + (along_y ? ", y" : ", x"), along_y};
}

/// The support forces from a row of the history on.
std::vector<Line> force_lines(const Table& history, std::size_t first) {
  const auto& progress = history.column("progress");
  const auto from = static_cast<std::ptrdiff_t>(first);
  std::vector<Line> lines;
  std::size_t supports = 0;
  for (std::size_t c = 8; c < history.columns.size(); ++c) {
    const auto force = force_column(history.columns[c]);
    if (!force) continue;
    Line line{.label = force->label,
              .x = {progress.begin() + from, progress.end()},
              .y = {history.values[c].begin() + from, history.values[c].end()},
              .colour = line_colour(supports),
              .dashed = force->along_y};
    if (any_nonzero(line.y)) lines.push_back(std::move(line));
    if (force->along_y) ++supports;
  }
  return lines;
}

void add_forces(const RunData& run, std::vector<Figure>& all) {
  const Table& history = run.history;
  if (history.rows() < 2) return;
  const std::size_t first = last_play(history);
  if (history.rows() - first < 3) return;
  const std::string unit = suffixes(run.identity.analysis).force;
  Figure figure{.id = "forces",
                .title = "Support forces through the last '" + history.word(history.column("step").back()) + "'",
                .x_label = "progress of the step",
                .y_label = unit == "N" ? "force on the body, N" : "force on the body, N per mm"};
  figure.lines = force_lines(history, first);
  if (!figure.lines.empty()) all.push_back(std::move(figure));
}

}  // namespace

std::vector<Play> plays_of(const Table& history) {
  const auto &progress = history.column("progress"), &step = history.column("step"), &cycle = history.column("cycle");
  std::vector<Play> plays;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const bool last = i + 1 == cycle.size() || step[i + 1] != step[i] || progress[i + 1] <= progress[i];
    if (!last) continue;
    if (cycle[i] > cycle[begin] || (begin == i && cycle[i] > 0.0)) plays.push_back({begin, i + 1});
    begin = i + 1;
  }
  return plays;
}

std::vector<Figure> history_figures(const RunData& run) {
  std::vector<Figure> all;
  for (const auto& contact : run.contacts) add_pressure(run, contact, all);
  add_energy(run, all);
  add_forces(run, all);
  return all;
}

}  // namespace reye::output
