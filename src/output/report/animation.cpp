#include "output/report/animation.hpp"

#include <algorithm>
#include <cmath>

#include "output/folder/text.hpp"
#include "output/report/contact_zone.hpp"
#include "output/report/drawn_frame.hpp"
#include "output/report/profiles.hpp"

namespace reye::output {

namespace {

constexpr std::size_t most_moments = 60, least_moments = 12;  ///< of one contact
constexpr std::size_t most_points = 300;                      ///< of one profile

std::string caption(double cycle) { return "cycle " + rounded(cycle, 6); }

/// The median of those above zero: the start of a run, where contact is narrow, would leave the rest without colours.
double usual(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !(value > 0.0); });
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// The bodies about a contact in all chosen frames, with stress and wear to one scale; more than its end has the last
/// colour.
Figure moving_bodies(const RunData& run, const ContactData& contact, const std::string& dir,
                     const std::vector<std::size_t>& chosen) {
  std::vector<DrawnSurfaces> surfaces;
  for (const std::size_t k : chosen) surfaces.push_back(read_drawn_surfaces(frame_path(dir, "surface", "vtp", k)));
  const Window window = contact_window(contact.name, surfaces, Held::deformed, 2.0);
  std::vector<DrawnFrame> frames;
  std::vector<double> most;
  for (const std::size_t k : chosen) {
    frames.push_back(read_drawn(frame_path(dir, "bodies", "vtu", k)));
    most.push_back(largest_stress(frames.back(), window));
  }
  const double top = usual(most);
  const double factor = magnification(deepest_of(contact), window);
  Figure figure = stress_figure(
      "moving-bodies-" + file_part(contact.name),
      title_of(run, contact, "Bodies, deformed") + (factor > 1.0 ? ", wear " + times_words(factor) : std::string()),
      window, top);
  for (std::size_t m = 0; m < chosen.size(); ++m) {
    figure.moments.push_back(stressed_bodies(frames[m], surfaces[m], window, stress_levels(top), factor));
    figure.moments.back().caption = caption(frames[m].cycle) + ", up to " + rounded(most[m], 3) + " MPa";
  }
  return figure;
}

/// A moving figure of a column of both sides, or of the secondary one alone.
Figure moving_column(const ContactData& contact, const std::string& column, double factor, bool both, Figure figure,
                     const std::vector<std::size_t>& chosen) {
  figure.x_label = "position along the surface, mm";
  figure.y_from_zero = true;
  double top = 0.0;
  for (const std::size_t k : chosen)
    figure.moments.push_back({.caption = caption(contact.sides.front().frames[k].cycle)});
  for (const auto& surface : contact.sides) {
    const double centre = centre_of(surface);
    Line style{.label = side_name(surface.side), .colour = line_colour(surface.side == sim::Side::secondary ? 0 : 1)};
    if (surface.side == contact.sides.front().side)
      figure.x_range = active_range(surface, centre);
    else if (!both)
      break;
    if (both) figure.lines.push_back(style);
    for (std::size_t m = 0; m < chosen.size(); ++m) {
      Line line = thinned(column_line(surface, surface.frames[chosen[m]], column, factor, centre), most_points);
      top = std::max(top, largest(line.y));
      line.colour = style.colour;
      figure.moments[m].lines.push_back(std::move(line));
    }
  }
  figure.y_range = Range{0.0, top};
  return figure;
}

}  // namespace

std::vector<Figure> moving_figures(const RunData& run, const std::string& dir) {
  const std::size_t count = frame_count(run, dir);
  if (count < 2) return {};
  const auto chosen = evenly_chosen(count, std::max(most_moments / run.contacts.size(), least_moments));
  std::vector<Figure> all;
  for (const auto& contact : run.contacts) {
    const std::string name = file_part(contact.name);
    all.push_back(moving_bodies(run, contact, dir, chosen));
    all.push_back(moving_column(contact, "pressure_MPa", 1.0, false,
                                {.id = "moving-pressure-" + name,
                                 .title = title_of(run, contact, "Contact pressure"),
                                 .y_label = "pressure, MPa"},
                                chosen));
    if (deepest_of(contact) == 0.0) continue;
    const Unit unit = length_unit(deepest_of(contact));
    Figure depth{.id = "moving-depth-" + name,
                 .title = title_of(run, contact, "Wear depth"),
                 .y_label = "wear depth, " + unit.name};
    depth.y_down = true;
    all.push_back(moving_column(contact, "wear_depth_mm", unit.factor, true, std::move(depth), chosen));
  }
  return all;
}

}  // namespace reye::output
