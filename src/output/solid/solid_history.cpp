#include "output/solid/solid_history.hpp"

#include <algorithm>
#include <cmath>

#include "output/folder/text.hpp"

namespace reye::output {

namespace {

/// The axis of a history: cycles where plays stand for many of them, else each play of a step is one unit long.
struct PlayAxis {
  std::vector<double> x;
  std::string label;
};

PlayAxis play_axis(const Table& history) {
  constexpr std::size_t most_named = 6;
  const auto &progress = history.column("progress"), &step = history.column("step");
  PlayAxis axis;
  std::vector<std::string> played;
  double plays = 0.0;
  for (std::size_t i = 0; i < progress.size(); ++i) {
    const bool fresh = i == 0 || step[i] != step[i - 1] || progress[i] <= progress[i - 1];
    if (fresh) {
      if (i > 0) plays += 1.0;
      played.push_back(history.word(step[i]));
    }
    axis.x.push_back(plays + progress[i]);
  }
  std::string names;
  for (const auto& name : played) names += (names.empty() ? "" : ", ") + name;
  const auto& cycle = history.column("cycle");
  if (cycle.back() > plays + 1.5) return {cycle, "cycles"};
  const bool named = played.size() <= most_named && names.size() <= 60;
  axis.label = "plays of the steps, one after the other" + (named && !names.empty() ? ": " + names : "");
  return axis;
}

/// A quantity of the history and how it is drawn.
struct HistoryColumn {
  std::string ending, words;
  bool dashed = false;
};

struct HistoryFigure {
  std::string id, title, unit;
  std::vector<HistoryColumn> columns;
};

const std::vector<HistoryFigure> contact_figures{
    {"pressure", "Largest pressure", "MPa", {{"_pressure_max_MPa", ""}}},
    {"force",
     "Force of the contact",
     "N",
     {{"_normal_force_N", "normal"}, {"_tangential_force_N", "tangential", true}}},
    {"area", "Area in contact", "mm²", {{"_area_mm2", "contact"}, {"_stick_area_mm2", "sticks", true}}},
    {"energy", "Energy dissipated since the start", "mJ", {{"_energy_mJ", ""}}},
    {"depth",
     "Largest worn depth",
     "mm",
     {{"_depth_max_secondary_mm", "secondary side"}, {"_depth_max_primary_mm", "primary side", true}}},
    {"volume",
     "Worn volume",
     "mm³",
     {{"_volume_secondary_mm3", "secondary side"}, {"_volume_primary_mm3", "primary side", true}}}};

std::string label_of(const std::string& contact, const std::string& words, bool several) {
  if (!several) return words;
  return contact + (words.empty() ? "" : ", " + words);
}

Figure contact_figure(const SolidRunData& data, const HistoryFigure& wanted, const PlayAxis& axis) {
  const auto& names = data.inputs.contacts;
  Figure figure{.id = "history-" + wanted.id, .title = wanted.title, .x_label = axis.label, .y_label = wanted.unit};
  figure.y_from_zero = true;
  figure.x_range = Range{0.0, std::ceil(axis.x.back())};
  for (std::size_t c = 0; c < names.size(); ++c)
    for (const auto& column : wanted.columns)
      figure.lines.push_back({.label = label_of(names[c], column.words, names.size() > 1),
                              .x = axis.x,
                              .y = data.run.history.column(names[c] + column.ending),
                              .colour = line_colour(names.size() > 1 ? c
                                                    : column.dashed  ? 1
                                                                     : 0),
                              .dashed = column.dashed && names.size() > 1,
                              .dots = axis.x.size() < 25});
  return figure;
}

double largest_of(const std::vector<double>& values) {
  double most = 0.0;
  for (const double v : values) most = std::max(most, std::isfinite(v) ? std::abs(v) : 0.0);
  return most;
}

bool wears(const SolidRunData& data) {
  for (const auto& contact : data.inputs.contacts)
    for (const char* column : {"_depth_max_secondary_mm", "_depth_max_primary_mm"})
      if (largest_of(data.run.history.column(contact + column)) > 0.0) return true;
  return false;
}

/// The forces on the supports, without those that are nothing beside the largest.
void add_support_forces(const SolidRunData& data, const PlayAxis& axis, std::vector<Figure>& all) {
  Figure figure{
      .id = "supports", .title = "Forces of the supports on their bodies", .x_label = axis.label, .y_label = "N"};
  figure.x_range = Range{0.0, std::ceil(axis.x.back())};
  double most = 0.0;
  const auto column = [&](const std::string& name, char way) -> const std::vector<double>& {
    return data.run.history.column(name + "_force_" + way + "_N");
  };
  for (const auto& name : data.inputs.supports)
    for (const char way : {'x', 'y', 'z'}) most = std::max(most, largest_of(column(name, way)));
  std::size_t colour = 0;
  for (const auto& name : data.inputs.supports)
    for (const char way : {'x', 'y', 'z'}) {
      if (!(largest_of(column(name, way)) > 1e-3 * most)) continue;
      figure.lines.push_back({.label = name + ", " + way,
                              .x = axis.x,
                              .y = column(name, way),
                              .colour = line_colour(colour),
                              .dashed = colour >= 6});
      ++colour;
    }
  if (!figure.lines.empty()) all.push_back(std::move(figure));
}

/// The motion at a progress of a step; NaN where the step is none of the scene's, or several have its name.
double motion_at(const DrivenMotion& motion, const std::string& step, double progress) {
  const auto named = [&](const auto& played) { return played.step == step; };
  const auto found = std::find_if(motion.steps.begin(), motion.steps.end(), named);
  if (found == motion.steps.end() || std::find_if(found + 1, motion.steps.end(), named) != motion.steps.end())
    return NAN;
  const auto& values = found->values;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const auto &a = values[i - 1], &b = values[i];
    if (progress <= b[0]) return a[1] + (b[1] - a[1]) * (progress - a[0]) / std::max(b[0] - a[0], 1e-300);
  }
  return values.empty() ? NAN : values.back()[1];
}

/// The force along a motion over the motion.
void add_loop(const SolidRunData& data, const DrivenMotion& motion, std::size_t number_of_it,
              std::vector<Figure>& all) {
  const Table& history = data.run.history;
  const auto &progress = history.column("progress"), &step = history.column("step");
  Line line{.label = "", .dots = progress.size() < 60};
  for (std::size_t i = 0; i < progress.size(); ++i) {
    double force = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      const auto& column = history.column(motion.columns + "xyz"[axis] + '_' + motion.force_unit);
      force += column.size() == progress.size() ? motion.direction[axis] * column[i] : NAN;
    }
    line.x.push_back(motion_at(motion, history.word(step[i]), progress[i]));
    line.y.push_back(force);
  }
  if (std::none_of(line.x.begin(), line.x.end(), [](double x) { return std::isfinite(x); })) return;
  const double size = largest_of(line.x);
  const bool small = motion.unit == "mm" && size < 0.1;
  if (small)
    for (double& x : line.x) x *= 1e3;
  const bool moment = motion.unit == "rad";
  Figure figure{.id = "loop-" + std::to_string(number_of_it),
                .title = (moment ? "Moment over the " : "Force over the ") + motion.label,
                .x_label = motion.label + ", " + (small ? "µm" : motion.unit),
                .y_label = moment ? "moment about it, N mm" : "force along it, N"};
  figure.lines = {std::move(line)};
  all.push_back(std::move(figure));
}

}  // namespace

std::vector<Figure> solid_history_figures(const SolidRunData& data) {
  std::vector<Figure> all;
  if (data.run.history.rows() < 2) return all;
  const PlayAxis axis = play_axis(data.run.history);
  if (!data.inputs.contacts.empty())
    for (const auto& wanted : contact_figures)
      if (wanted.id != "depth" || wears(data)) all.push_back(contact_figure(data, wanted, axis));
  add_support_forces(data, axis, all);
  for (std::size_t k = 0; k < data.inputs.motions.size(); ++k) add_loop(data, data.inputs.motions[k], k + 1, all);
  return all;
}

}  // namespace reye::output
