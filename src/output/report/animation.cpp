#include "output/report/animation.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "output/folder/text.hpp"
#include "output/folder/vtk_frames.hpp"
#include "output/report/drawn_frame.hpp"
#include "output/report/profiles.hpp"

namespace reye::output {

namespace fs = std::filesystem;
using base::Vec2;

namespace {

constexpr std::size_t most_moments = 60;
constexpr std::size_t most_points = 300;  ///< of one profile
constexpr std::size_t most_edges = 300;   ///< drawn inside the bodies in one moment

std::string caption(double cycle) { return "cycle " + rounded(cycle, 6); }

std::string frame_path(const std::string& dir, const char* stem, const char* ext, std::size_t k) {
  return (fs::path(dir) / frame_file(stem, ext, k)).string();
}

/// Number of frames with both files and the rows of all tables.
std::size_t frame_count(const RunData& run, const std::string& dir) {
  std::size_t count = run.contacts.empty() ? 0 : SIZE_MAX;
  for (const auto& contact : run.contacts) {
    if (contact.sides.empty()) return 0;
    for (const auto& surface : contact.sides) count = std::min(count, surface.frames.size());
  }
  while (count > 0 && !fs::is_regular_file(frame_path(dir, "surface", "vtp", count - 1))) --count;
  return count;
}

/// The part of the plane that is shown.
struct Window {
  Range x{INFINITY, -INFINITY}, y{INFINITY, -INFINITY};

  void add(const Vec2& at) {
    x = {std::min(x.low, at.x()), std::max(x.high, at.x())};
    y = {std::min(y.low, at.y()), std::max(y.high, at.y())};
  }
  bool empty() const { return x.low > x.high; }
  Vec2 centre() const { return {0.5 * (x.low + x.high), 0.5 * (y.low + y.high)}; }
  bool meets(const Vec2& a, const Vec2& b) const {
    return std::max(a.x(), b.x()) >= x.low && std::min(a.x(), b.x()) <= x.high && std::max(a.y(), b.y()) >= y.low &&
           std::min(a.y(), b.y()) <= y.high;
  }
};

/// Twice the size of what it holds, in the aspect of the field.
Window widened_about(const Window& held) {
  const Vec2 centre = held.centre();
  const double half = std::max(held.x.width(), plot_aspect * held.y.width());
  return {{centre.x() - half, centre.x() + half}, {centre.y() - half / plot_aspect, centre.y() + half / plot_aspect}};
}

/// The window of all places under pressure or worn in one of the frames; the whole surfaces without any.
Window contact_window(const RunData& run, const std::string& dir, const std::vector<std::size_t>& chosen) {
  double p_small = 0.0, h_small = 0.0;
  for (const auto& contact : run.contacts) {
    h_small = std::max(h_small, 1e-3 * deepest_of(contact));
    p_small = std::max(p_small, 1e-6 * largest(contact.sides.front().table.column("pressure_MPa")));
  }
  Window active, whole;
  for (const std::size_t k : chosen) {
    const auto at = read_drawn_surfaces(frame_path(dir, "surface", "vtp", k));
    for (std::size_t i = 0; i < at.x.size(); ++i) {
      whole.add(at.x[i]);
      if (at.pressure_MPa[i] > p_small || at.wear_depth_mm[i] > h_small) active.add(at.x[i]);
    }
  }
  return widened_about(active.empty() || active.x.width() + active.y.width() == 0.0 ? whole : active);
}

void draw(const DrawnFrame& frame, const DrawnEdge& edge, Line& line) {
  const auto to = [&](int node) {
    line.x.push_back(frame.x[static_cast<std::size_t>(node)].x());
    line.y.push_back(frame.x[static_cast<std::size_t>(node)].y());
  };
  to(edge.from);
  if (edge.mid >= 0) to(edge.mid);
  to(edge.to);
  line.x.push_back(NAN);
  line.y.push_back(NAN);
}

/// Edges of a frame inside the window: the outline, and of the others those nearest to the contact.
Moment bodies_at(const DrawnFrame& frame, const Window& window) {
  std::vector<DrawnEdge> inner, outline;
  const auto at = [&](int node) { return frame.x[static_cast<std::size_t>(node)]; };
  for (const auto& edge : frame.edges)
    if (window.meets(at(edge.from), at(edge.to))) (edge.outline ? outline : inner).push_back(edge);
  const Vec2 centre = window.centre();
  const auto distance = [&](const DrawnEdge& e) { return (0.5 * (at(e.from) + at(e.to)) - centre).squaredNorm(); };
  std::stable_sort(inner.begin(), inner.end(), [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  if (inner.size() > most_edges) inner.resize(most_edges);
  Line mesh{.colour = "#b4bac3", .width = 0.7};
  for (const auto& edge : inner) draw(frame, edge, mesh);
  std::map<int, Line> lines;
  for (const auto& edge : outline) {
    Line& line =
        lines.try_emplace(edge.body, Line{.colour = line_colour(static_cast<std::size_t>(edge.body))}).first->second;
    draw(frame, edge, line);
  }
  Moment moment{caption(frame.cycle), {mesh}};
  for (auto& [body, line] : lines) moment.lines.push_back(std::move(line));
  return moment;
}

Figure moving_bodies(const RunData& run, const std::string& dir, const std::vector<std::size_t>& chosen) {
  const Window window = contact_window(run, dir, chosen);
  Figure figure{
      .id = "moving-bodies", .title = "Bodies about the contact, deformed", .x_label = "x, mm", .y_label = "y, mm"};
  figure.x_range = window.x;
  figure.y_range = window.y;
  figure.exact_ranges = true;
  for (const std::size_t k : chosen)
    figure.moments.push_back(bodies_at(read_drawn(frame_path(dir, "bodies", "vtu", k)), window));
  return figure;
}

/// A moving figure of a column of both sides, or of the secondary one alone.
Figure moving_column(const ContactData& contact, const std::string& column, double factor, bool both, Figure figure,
                     const std::vector<std::size_t>& chosen) {
  figure.x_label = "position along the surface, mm";
  figure.y_from_zero = true;
  double top = 0.0;
  for (const std::size_t k : chosen) figure.moments.push_back({caption(contact.sides.front().frames[k].cycle), {}});
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
  const auto chosen = evenly_chosen(count, most_moments);
  std::vector<Figure> all{moving_bodies(run, dir, chosen)};
  for (const auto& contact : run.contacts) {
    const std::string name = file_part(contact.name);
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
