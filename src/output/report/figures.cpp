#include "output/report/figures.hpp"

#include <algorithm>
#include <cmath>

#include "output/folder/text.hpp"
#include "output/report/profiles.hpp"

namespace reye::output {

namespace {

struct OverCycles {
  std::string id, title, column, y_label;
  double factor = 1.0;
  bool down = false;
};

/// One line per frame, coloured by its cycle, or by its number where no cycles are counted.
Figure over_cycles(const SurfaceTable& surface, const OverCycles& what) {
  Figure figure{
      .id = what.id, .title = what.title, .x_label = "position along the surface, mm", .y_label = what.y_label};
  figure.y_down = what.down;
  figure.y_from_zero = true;
  const double centre = centre_of(surface);
  figure.x_range = active_range(surface, centre);
  Range cycles{surface.frames.front().cycle, surface.frames.back().cycle};
  const bool counted = cycles.width() > 0.0;
  if (!counted) cycles = {0.0, static_cast<double>(surface.frames.size() - 1)};
  for (const std::size_t k : evenly_chosen(surface.frames.size(), 12)) {
    const FrameRows& rows = surface.frames[k];
    Line line = column_line(surface, rows, what.column, what.factor, centre);
    const double at = counted ? rows.cycle : static_cast<double>(k);
    const double t = cycles.width() > 0.0 ? (at - cycles.low) / cycles.width() : 1.0;
    line.colour = scale_colour(t);
    figure.lines.push_back(std::move(line));
  }
  if (cycles.width() > 0.0) figure.scale = ColourScale{counted ? "cycles" : "frame", cycles};
  return figure;
}

/// Friction times pressure, the bound of the shear, with its sign.
Line friction_bound(const SurfaceTable& surface, const FrameRows& rows, double signed_mu, double centre) {
  Line bound = column_line(surface, rows, "pressure_MPa", signed_mu, centre);
  if (signed_mu > 0.0) bound.label = "± friction × pressure";
  bound.colour = "#8b929c";
  bound.width = 1.2;
  bound.dashed = true;
  return bound;
}

Line traction_line(const SurfaceTable& surface, const FrameRows& rows, const std::string& name, double centre,
                   std::size_t colour) {
  Line line = column_line(surface, rows, name + "_MPa", 1.0, centre);
  line.label = name;
  line.colour = line_colour(colour);
  return line;
}

Figure last_tractions(const RunData& run, const ContactData& contact) {
  const SurfaceTable& surface = contact.sides.front();
  const FrameRows& rows = surface.frames.back();
  Figure figure{.id = "tractions-" + file_part(contact.name),
                .title = title_of(run, contact, "Pressure and shear at cycle " + rounded(rows.cycle, 6)),
                .x_label = "position along the surface, mm",
                .y_label = "traction, MPa"};
  figure.y_from_zero = true;
  const double centre = centre_of(surface);
  figure.x_range = active_range(surface, centre);
  const double mu = contact.friction.value_or(0.0);
  if (mu > 0.0) figure.lines = {friction_bound(surface, rows, mu, centre), friction_bound(surface, rows, -mu, centre)};
  figure.lines.push_back(traction_line(surface, rows, "pressure", centre, 0));
  figure.lines.push_back(traction_line(surface, rows, "shear", centre, 1));
  return figure;
}

Line side_line(sim::Side side) {
  return {.label = side_name(side), .colour = line_colour(side == sim::Side::secondary ? 0 : 1)};
}

/// A value of each frame against its cycle, one line per side.
template <class Value>
Figure per_frame(const ContactData& contact, Figure figure, const Value& value) {
  for (const auto& surface : contact.sides) {
    Line line = side_line(surface.side);
    line.dots = surface.frames.size() <= 40;
    for (const auto& rows : surface.frames) {
      line.x.push_back(rows.cycle);
      line.y.push_back(value(surface, rows));
    }
    if (largest(line.y) > 0.0) figure.lines.push_back(std::move(line));
  }
  figure.x_label = "cycles";
  figure.y_from_zero = true;
  return figure;
}

/// The largest depths of a contact at the ends of blocks, as the history has them.
void depth_from_history(const RunData& run, const ContactData& contact, double factor, Figure& figure) {
  const auto plays = plays_of(run.history);
  const auto& cycle = run.history.column("cycle");
  for (const auto side : {sim::Side::secondary, sim::Side::primary}) {
    const auto& depth = run.history.column(contact.name + "_depth_max_" + side_name(side) + "_mm");
    if (depth.empty() || plays.empty()) continue;
    Line line = side_line(side);
    line.dots = plays.size() <= 40;
    line.x = {0.0};
    line.y = {0.0};
    for (const auto& play : plays) {
      line.x.push_back(cycle[play.end - 1]);
      line.y.push_back(factor * depth[play.end - 1]);
    }
    if (largest(line.y) > 0.0) figure.lines.push_back(std::move(line));
  }
  figure.x_label = "cycles";
  figure.y_from_zero = true;
}

Figure depth_over_cycles(const RunData& run, const ContactData& contact) {
  const Unit unit = length_unit(deepest_of(contact));
  Figure figure{.id = "depth-" + file_part(contact.name),
                .title = title_of(run, contact, "Largest wear depth"),
                .y_label = "depth, " + unit.name};
  depth_from_history(run, contact, unit.factor, figure);
  if (!figure.lines.empty()) return figure;
  return per_frame(contact, figure, [&](const SurfaceTable& surface, const FrameRows& rows) {
    const auto first = surface.table.column("wear_depth_mm").begin();
    return unit.factor * *std::max_element(first + static_cast<std::ptrdiff_t>(rows.begin),
                                           first + static_cast<std::ptrdiff_t>(rows.end));
  });
}

Figure worn_over_cycles(const RunData& run, const ContactData& contact) {
  const bool ring = run.identity.analysis == base::Analysis::axisymmetric;
  Figure figure{.id = "worn-" + file_part(contact.name),
                .title = title_of(run, contact, ring ? "Worn volume" : "Worn area"),
                .y_label = ring ? "volume, mm³" : "area, mm²"};
  return per_frame(contact, figure, [&](const SurfaceTable& surface, const FrameRows& rows) {
    return worn_amount(surface, rows, run.identity.analysis);
  });
}

/// Worn profiles of both sides to one scale.
void add_profiles(const RunData& run, const ContactData& contact, std::vector<Figure>& all) {
  const double deepest = deepest_of(contact);
  const Unit unit = length_unit(deepest);
  for (const auto& surface : contact.sides) {
    if (largest(surface.table.column("wear_depth_mm")) == 0.0) continue;
    const std::string side = side_name(surface.side);
    const auto edges = run.identity.sides.find(contact.name);
    const std::string edge =
        edges == run.identity.sides.end() ? "" : ": " + edges->second[surface.side == sim::Side::primary];
    all.push_back(over_cycles(surface, {"profile-" + file_part(contact.name) + '-' + side,
                                        title_of(run, contact, "Worn profile, " + side + " side" + edge),
                                        "wear_depth_mm", "wear depth, " + unit.name, unit.factor, true}));
    all.back().y_range = Range{0.0, deepest * unit.factor};
  }
}

void add_contact(const RunData& run, const ContactData& contact, std::vector<Figure>& all) {
  if (contact.sides.empty()) return;
  add_profiles(run, contact, all);
  const SurfaceTable& first = contact.sides.front();
  if (first.frames.size() > 1)
    all.push_back(over_cycles(
        first, {"pressure-" + file_part(contact.name), title_of(run, contact, "Contact pressure in the frames"),
                "pressure_MPa", "pressure, MPa"}));
  all.push_back(last_tractions(run, contact));
  if (deepest_of(contact) == 0.0 || first.frames.size() < 2) return;
  all.push_back(depth_over_cycles(run, contact));
  all.push_back(worn_over_cycles(run, contact));
}

}  // namespace

std::vector<Figure> figures(const RunData& run) {
  std::vector<Figure> all;
  for (const auto& contact : run.contacts) add_contact(run, contact, all);
  for (auto& figure : history_figures(run)) all.push_back(std::move(figure));
  return all;
}

}  // namespace reye::output
