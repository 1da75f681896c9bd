#include "output/report/contact_zone.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "output/folder/text.hpp"
#include "output/report/isobands.hpp"

namespace reye::output {

using base::Vec2;

namespace {

constexpr double reach_of_wear = 1.0 / 3.0;  ///< of the window's height: how far into a body magnified wear is drawn

/// The smallest box round some points.
struct Bounds {
  Range x{INFINITY, -INFINITY}, y{INFINITY, -INFINITY};

  void add(const Vec2& at) {
    x = {std::min(x.low, at.x()), std::max(x.high, at.x())};
    y = {std::min(y.low, at.y()), std::max(y.high, at.y())};
  }
  bool without_size() const { return !(x.width() + y.width() > 0.0); }
};

/// A number that is exceeded where something happens.
struct Noise {
  double pressure_MPa = 0.0, depth_mm = 0.0;
};

Noise noise_of(const std::string& contact, const std::vector<DrawnSurfaces>& frames) {
  Noise noise;
  for (const auto& frame : frames)
    for (const auto& line : frame.lines)
      for (std::size_t i = line.begin; i < line.end && line.contact == contact; ++i) {
        noise.pressure_MPa = std::max(noise.pressure_MPa, 1e-6 * frame.pressure_MPa[i]);
        noise.depth_mm = std::max(noise.depth_mm, 1e-3 * frame.wear_depth_mm[i]);
      }
  return noise;
}

/// The point of a segment nearest to p, as its share of the way.
double nearest_share(const Vec2& a, const Vec2& b, const Vec2& p) {
  const double length = (b - a).squaredNorm();
  return length > 0.0 ? std::clamp((p - a).dot(b - a) / length, 0.0, 1.0) : 0.0;
}

/// Moves points of bodies so that wear looks deeper.
class Deeper {
 public:
  Deeper(const DrawnSurfaces& surfaces, double factor, double reach) : at_(surfaces), reach_(reach) {
    move_ = inward(surfaces, Held::deformed);
    for (std::size_t i = 0; i < move_.size(); ++i) move_[i] *= (factor - 1.0) * surfaces.wear_depth_mm[i];
    none_ = factor == 1.0;
  }

  Vec2 moved(int body, const Vec2& p) const {
    double nearest = reach_;
    Vec2 move(0.0, 0.0);
    for (const auto& line : at_.lines)
      for (std::size_t i = line.begin; i + 1 < line.end && line.body == body && !none_; ++i) {
        const double t = nearest_share(at_.x[i], at_.x[i + 1], p);
        const double distance = (at_.x[i] + t * (at_.x[i + 1] - at_.x[i]) - p).norm();
        if (distance >= nearest) continue;
        nearest = distance;
        move = move_[i] + t * (move_[i + 1] - move_[i]);
      }
    const double share = 1.0 - nearest / reach_;
    return p + share * share * move;
  }

 private:
  const DrawnSurfaces& at_;
  base::Points move_;
  double reach_;
  bool none_ = false;
};

void draw(const base::Points& x, const DrawnEdge& edge, Line& line) {
  for (const int node : {edge.from, edge.mid, edge.to}) {
    if (node < 0) continue;
    line.x.push_back(x[static_cast<std::size_t>(node)].x());
    line.y.push_back(x[static_cast<std::size_t>(node)].y());
  }
  line.x.push_back(NAN);
  line.y.push_back(NAN);
}

/// A window that no colour at its border ends in.
Window with_border(const Window& window) {
  const double border = 0.02 * window.x.width();
  return {{window.x.low - border, window.x.high + border}, {window.y.low - border, window.y.high + border}};
}

/// The stress as areas, one per band.
std::vector<Area> stress_areas(const base::Points& x, const DrawnFrame& frame,
                               const std::vector<std::array<int, 3>>& triangles, const std::vector<double>& levels) {
  std::vector<Area> areas;
  const auto bands = isobands(x, frame.von_mises_MPa, triangles, levels);
  for (std::size_t k = 0; k < bands.size(); ++k) {
    Area area{.colour = scale_colour((static_cast<double>(k) + 0.5) / static_cast<double>(bands.size()))};
    for (const auto& loop : bands[k]) area.loops.push_back(loop);
    if (!area.loops.empty()) areas.push_back(std::move(area));
  }
  return areas;
}

/// Rigid bodies, which have no stress; those inside others look like holes.
Area rigid_area(const base::Points& x, const DrawnFrame& frame) {
  Area area{.colour = "#d4d8de"};
  for (const auto& outline : frame.rigid) {
    area.loops.emplace_back();
    for (const int node : outline) area.loops.back().push_back(x[static_cast<std::size_t>(node)]);
  }
  return area;
}

}  // namespace

bool Window::meets(std::initializer_list<Vec2> points) const {
  Bounds held_in;
  for (const auto& p : points) held_in.add(p);
  return held_in.x.high >= x.low && held_in.x.low <= x.high && held_in.y.high >= y.low && held_in.y.low <= y.high;
}

Window contact_window(const std::string& contact, const std::vector<DrawnSurfaces>& frames, Held held, double margin) {
  const Noise noise = noise_of(contact, frames);
  Bounds active, whole;
  for (const auto& frame : frames)
    for (const auto& line : frame.lines)
      for (std::size_t i = line.begin; i < line.end && line.contact == contact; ++i) {
        const Vec2& at = held == Held::deformed ? frame.x[i] : frame.X[i];
        whole.add(at);
        if (frame.pressure_MPa[i] > noise.pressure_MPa || frame.wear_depth_mm[i] > noise.depth_mm) active.add(at);
      }
  const Bounds& held_in = active.without_size() ? whole : active;
  const Vec2 centre(0.5 * (held_in.x.low + held_in.x.high), 0.5 * (held_in.y.low + held_in.y.high));
  const double half = 0.5 * margin * std::max(held_in.x.width(), plot_aspect * held_in.y.width());
  return {{centre.x() - half, centre.x() + half}, {centre.y() - half / plot_aspect, centre.y() + half / plot_aspect}};
}

double magnification(double depth_mm, const Window& window) {
  const double wanted = 0.125 * window.y.width() / depth_mm;
  if (!(wanted > 2.0) || !std::isfinite(wanted)) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  return (wanted >= 5.0 * power ? 5.0 : wanted >= 2.0 * power ? 2.0 : 1.0) * power;
}

base::Points inward(const DrawnSurfaces& surfaces, Held held) {
  const auto& x = held == Held::deformed ? surfaces.x : surfaces.X;
  base::Points directions(x.size(), Vec2(0.0, 0.0));
  for (const auto& [contact, secondary, body, left, begin, end] : surfaces.lines) {
    const bool ring = end - begin > 3 && x[begin] == x[end - 1];
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t before = i > begin ? i - 1 : ring ? end - 2 : i;
      const std::size_t after = i + 1 < end ? i + 1 : ring ? begin + 1 : i;
      const Vec2 along = x[after] - x[before];
      const double length = (left ? 1.0 : -1.0) * along.norm();
      if (length != 0.0) directions[i] = Vec2(-along.y(), along.x()) / length;
    }
  }
  return directions;
}

Moment stressed_bodies(const DrawnFrame& frame, const DrawnSurfaces& surfaces, const Window& shown,
                       const std::vector<double>& levels, double factor) {
  const Window window = with_border(shown);
  const auto at = [&](int node) { return frame.x[static_cast<std::size_t>(node)]; };
  std::vector<std::array<int, 3>> triangles;
  std::vector<const DrawnEdge*> outline;
  std::vector<char> seen(frame.x.size(), 0);
  for (const auto& t : frame.triangles) {
    if (!window.meets({at(t[0]), at(t[1]), at(t[2])})) continue;
    triangles.push_back(t);
    for (const int node : t) seen[static_cast<std::size_t>(node)] = 1;
  }
  for (const auto& edge : frame.edges)
    if (edge.outline && window.meets({at(edge.from), at(edge.to)})) outline.push_back(&edge);
  const Deeper deeper(surfaces, factor, reach_of_wear * window.y.width());
  base::Points x = frame.x;
  for (const auto* edge : outline)
    for (const int node : {edge->from, edge->mid, edge->to})
      if (node >= 0) seen[static_cast<std::size_t>(node)] = 1;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (seen[i]) x[i] = deeper.moved(frame.body[i], x[i]);
  Moment moment{.areas = stress_areas(x, frame, triangles, levels)};
  if (!frame.rigid.empty()) moment.areas.push_back(rigid_area(x, frame));
  Line line{.colour = "#1b1e23", .width = 1.2};
  for (const auto* edge : outline) draw(x, *edge, line);
  moment.lines.push_back(std::move(line));
  return moment;
}

double largest_stress(const DrawnFrame& frame, const Window& window) {
  double largest = 0.0;
  for (std::size_t i = 0; i < frame.x.size(); ++i)
    if (window.meets({frame.x[i]})) largest = std::max(largest, frame.von_mises_MPa[i]);
  return largest;
}

std::vector<double> stress_levels(double top_MPa) {
  constexpr int about = 10;
  const Range whole = rounded_out({0.0, top_MPa > 0.0 ? top_MPa : 1.0}, about);
  return nice_ticks(whole.low, whole.high, about).values;
}

Figure stress_figure(const std::string& id, const std::string& title, const Window& window, double top_MPa) {
  const auto levels = stress_levels(top_MPa);
  Figure figure{.id = id, .title = title, .x_label = "x, mm", .y_label = "y, mm"};
  figure.scale = ColourScale{"MPa", {levels.front(), levels.back()}, static_cast<int>(levels.size()) - 1};
  figure.x_range = window.x;
  figure.y_range = window.y;
  figure.exact_ranges = true;
  return figure;
}

std::string times_words(double factor) { return "×" + rounded(factor, 4); }

}  // namespace reye::output
