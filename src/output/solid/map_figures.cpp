#include "output/solid/map_figures.hpp"

#include <algorithm>
#include <cmath>

#include "output/folder/text.hpp"
#include "output/report/isobands.hpp"
#include "output/report/profiles.hpp"

namespace reye::output {

namespace {

constexpr const char *no_contact_colour = "#e9ecef", *stick_colour = "#2f8f5b", *slip_colour = "#dfa24a",
                     *map_ink = "#14171b";

std::vector<double> sizes_of(const base::Points3& v) {
  std::vector<double> sizes;
  for (const auto& one : v) sizes.push_back(one.norm());
  return sizes;
}

/// The region where a property of rows, continued between them, is more than one half.
Area region_of(const SkinMap& map, const std::vector<char>& holds, const char* colour) {
  const std::vector<double> rows(holds.begin(), holds.end());
  const auto bands = isobands(map.x, map.at_points(rows), map.triangles, {-1.0, 0.5, 2.0});
  return {.colour = colour, .loops = bands[1]};
}

/// The border of a region as a line.
Line border_of(const Area& region, double width) {
  Line line{.colour = map_ink, .width = width};
  for (const auto& loop : region.loops) {
    for (std::size_t k = 0; k <= loop.size(); ++k) {
      line.x.push_back(loop[k % loop.size()].x());
      line.y.push_back(loop[k % loop.size()].y());
    }
    line.x.push_back(NAN);
    line.y.push_back(NAN);
  }
  return line;
}

std::vector<char> with_status(const DrawnSkin& skin, int status) {
  std::vector<char> holds;
  for (const int s : skin.status) holds.push_back(s == status);
  return holds;
}

/// A figure with the axes of the map, all its facets in grey.
Figure empty_map(const SkinMap& map, const std::string& id, const std::string& title) {
  Figure figure{
      .id = id, .title = title, .x_label = axis_label(map.across) + ", mm", .y_label = axis_label(map.up) + ", mm"};
  figure.x_range = map.x_seen;
  figure.y_range = map.y_seen;
  figure.aspect = map.x_seen.width() / map.y_seen.width();
  figure.exact_ranges = true;
  figure.areas.push_back(region_of(map, std::vector<char>(map.active.size(), 1), no_contact_colour));
  return figure;
}

/// Round levels from zero to at least the largest value.
std::vector<double> map_levels(double top) {
  constexpr int about = 14;
  const Range whole = rounded_out({0.0, top > 0.0 ? top : 1.0}, about);
  return nice_ticks(whole.low, whole.high, about).values;
}

/// Adds a value in bands over the facets that touch an active row, and the border of these rows.
void add_bands(const SkinMap& map, const std::vector<double>& rows, const std::vector<double>& levels,
               std::vector<Area>& areas, std::vector<Line>& lines) {
  const auto values = map.at_points(rows), contact = map.at_points({map.active.begin(), map.active.end()});
  std::vector<std::array<int, 3>> touching;
  const auto touches = [&](int point) { return contact[static_cast<std::size_t>(point)] > 0.0; };
  std::copy_if(map.triangles.begin(), map.triangles.end(), std::back_inserter(touching),
               [&](const auto& t) { return touches(t[0]) || touches(t[1]) || touches(t[2]); });
  const auto bands = isobands(map.x, values, touching, levels);
  for (std::size_t k = 0; k < bands.size(); ++k)
    if (!bands[k].empty())
      areas.push_back({.colour = scale_colour((static_cast<double>(k) + 0.5) / static_cast<double>(bands.size())),
                       .loops = bands[k]});
  std::vector<char> open;
  for (const char active : map.active) open.push_back(!active);
  areas.push_back(region_of(map, open, no_contact_colour));
  lines.push_back(border_of(region_of(map, map.active, ""), 1.2));
}

ColourScale scale_of(const std::string& unit, const std::vector<double>& levels) {
  return {unit, {levels.front(), levels.back()}, static_cast<int>(levels.size()) - 1};
}

/// Adds bands to a figure with a scale of its own.
void add_bands(const SkinMap& map, const std::vector<double>& rows, const std::string& unit, Figure& figure) {
  const auto levels = map_levels(largest(rows));
  add_bands(map, rows, levels, figure.areas, figure.lines);
  figure.scale = scale_of(unit, levels);
}

/// The rows in contact nearest to the middles of an even grid, so that arrows keep apart.
std::vector<std::size_t> spread_rows(const SkinMap& map, int cells) {
  const double size = map.x_seen.width() / cells;
  const int rows = static_cast<int>(std::ceil(map.y_seen.width() / size));
  std::vector<std::size_t> best(static_cast<std::size_t>(cells * rows), SIZE_MAX);
  std::vector<double> off(best.size(), INFINITY);
  for (std::size_t i = 0; i < map.active.size(); ++i) {
    const base::Vec2 at = (map.x[i] - base::Vec2(map.x_seen.low, map.y_seen.low)) / size;
    const int column = static_cast<int>(std::floor(at.x())), row = static_cast<int>(std::floor(at.y()));
    if (!map.active[i] || column < 0 || row < 0 || column >= cells || row >= rows) continue;
    const auto cell = static_cast<std::size_t>(row * cells + column);
    const double distance = (at - base::Vec2(column + 0.5, row + 0.5)).norm();
    if (distance >= off[cell]) continue;
    off[cell] = distance;
    best[cell] = i;
  }
  std::erase(best, SIZE_MAX);
  return best;
}

void add_stroke(Line& line, const std::vector<base::Vec2>& points) {
  for (const auto& p : points) {
    line.x.push_back(p.x());
    line.y.push_back(p.y());
  }
  line.x.push_back(NAN);
  line.y.push_back(NAN);
}

/// Adds arrows as long as their share of the largest.
void add_arrows(const SkinMap& map, const base::Points3& vectors, Figure& figure) {
  constexpr int cells = 17;
  const double most = largest(sizes_of(vectors)), length = 0.95 * map.x_seen.width() / cells;
  Line line{.colour = map_ink, .width = 1.1};
  for (const std::size_t i : spread_rows(map, cells)) {
    const base::Vec2 way = length / most * map.flat(vectors[i]), tail = map.x[i] - 0.5 * way, tip = tail + way;
    if (!(way.norm() > 0.06 * length)) continue;
    const base::Vec2 back = 0.32 * way, side(-0.45 * back.y(), 0.45 * back.x());
    add_stroke(line, {tail, tip});
    add_stroke(line, {tip - back + side, tip, tip - back - side});
  }
  if (most > 0.0 && !line.x.empty()) figure.lines.push_back(std::move(line));
}

/// The ends of a line inside what is seen.
Line drawn_line(const SkinMap& map, const MapLine& line, const std::string& label, std::size_t colour) {
  const double reach = map.x_seen.width() + map.y_seen.width();
  const base::Vec2 a = line.through - reach * line.along, b = line.through + reach * line.along;
  return {.label = label,
          .x = {a.x(), b.x()},
          .y = {a.y(), b.y()},
          .colour = line_colour(colour),
          .width = 1.3,
          .dashed = true};
}

/// A wide line that stands for an area in the legend.
Line legend_of(const std::string& label, const char* colour) {
  return {.label = label, .x = {}, .y = {}, .colour = colour, .width = 9.0};
}

base::Vec3 in_space(const SkinMap& map, const base::Vec2& d) { return d.x() * map.across + d.y() * map.up; }

}  // namespace

Figure pressure_map(const SkinMap& map, const DrawnSkin& skin, const MapWords& words) {
  Figure figure = empty_map(map, "map-pressure-" + words.id, words.before + "pressure, " + words.when);
  add_bands(map, skin.pressure_MPa, "MPa", figure);
  const auto lines = principal_lines(map, skin);
  for (std::size_t k = 0; k < lines.size(); ++k)
    figure.lines.push_back(drawn_line(map, lines[k], "line " + std::to_string(k + 1), k == 0 ? 1 : 3));
  return figure;
}

Figure shear_map(const SkinMap& map, const DrawnSkin& skin, const MapWords& words) {
  Figure figure = empty_map(map, "map-shear-" + words.id, words.before + "shear, " + words.when);
  add_bands(map, sizes_of(skin.shear_MPa), "MPa", figure);
  add_arrows(map, skin.shear_MPa, figure);
  return figure;
}

Figure slip_map(const SkinMap& map, const DrawnSkin& skin, const MapWords& words) {
  Figure figure = empty_map(map, "map-slip-" + words.id, words.before + "slip of the last increment, " + words.when);
  auto sizes = sizes_of(skin.slip_mm);
  const Unit unit = length_unit(largest(sizes));
  for (double& size : sizes) size *= unit.factor;
  add_bands(map, sizes, unit.name, figure);
  add_arrows(map, skin.slip_mm, figure);
  return figure;
}

Figure status_map(const SkinMap& map, const DrawnSkin& skin, const MapWords& words) {
  Figure figure = empty_map(map, "map-status-" + words.id, words.before + "stick and slip, " + words.when);
  figure.areas.push_back(region_of(map, map.active, slip_colour));
  figure.areas.push_back(region_of(map, with_status(skin, 1), stick_colour));
  figure.lines.push_back(border_of(figure.areas[1], 1.2));
  const auto area_in = [&](int status) {
    double area = 0.0;
    for (std::size_t i = 0; i < skin.status.size(); ++i) area += skin.status[i] == status ? skin.area_mm2[i] : 0.0;
    return rounded(area) + " mm²";
  };
  figure.lines.push_back(legend_of("stick, " + area_in(1), stick_colour));
  figure.lines.push_back(legend_of("slip, " + area_in(2), slip_colour));
  figure.lines.push_back(legend_of("no contact", no_contact_colour));
  return figure;
}

std::vector<char> worn_rows(const DrawnSkin& skin) {
  constexpr double faint = 1e-3;
  const double least = faint * largest(skin.wear_depth_mm);
  std::vector<char> worn;
  for (const double depth : skin.wear_depth_mm) worn.push_back(depth > least);
  return worn;
}

Figure depth_map(const SkinMap& map, const DrawnSkin& skin, const MapWords& words) {
  Figure figure =
      empty_map(map, "map-depth-" + words.id,
                words.before + "worn depth, " + (skin.secondary ? "secondary" : "primary") + " side, " + words.when);
  auto depth = skin.wear_depth_mm;
  const Unit unit = length_unit(largest(depth));
  for (double& value : depth) value *= unit.factor;
  add_bands(map, depth, unit.name, figure);
  return figure;
}

Figure moving_map(const std::vector<MovingMap>& frames, const std::string& unit, const std::string& id,
                  const std::string& title) {
  Figure figure = empty_map(frames.back().map, id, title);
  double top = 0.0;
  for (const auto& frame : frames) top = std::max(top, largest(frame.rows));
  const auto levels = map_levels(top);
  figure.scale = scale_of(unit, levels);
  for (const auto& frame : frames) {
    Moment moment{.caption = frame.caption};
    add_bands(frame.map, frame.rows, levels, moment.areas, moment.lines);
    figure.moments.push_back(std::move(moment));
  }
  return figure;
}

std::vector<Figure> line_profiles(const SkinMap& map, const DrawnSkin& skin, const MapWords& words) {
  const auto pressure = map.at_points(skin.pressure_MPa), shear = map.at_points(sizes_of(skin.shear_MPa));
  const auto lines = principal_lines(map, skin);
  std::vector<Figure> all;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const std::string number_of_line = std::to_string(k + 1);
    Figure figure{
        .id = "profile-" + words.id + '-' + number_of_line,
        .title = words.before + "along line " + number_of_line + ", " + words.when,
        .x_label = "position from the largest pressure, " + axis_label(in_space(map, lines[k].along)) + ", mm",
        .y_label = "MPa"};
    figure.y_from_zero = true;
    const auto p = sampled(map, pressure, lines[k]), t = sampled(map, shear, lines[k]);
    figure.lines.push_back({.label = "pressure", .x = p.position, .y = p.value, .colour = line_colour(0)});
    if (words.friction) {
      Line limit{.label = "friction × pressure",
                 .x = p.position,
                 .y = p.value,
                 .colour = line_colour(5),
                 .width = 1.2,
                 .dashed = true};
      for (double& value : limit.y) value *= *words.friction;
      figure.lines.push_back(std::move(limit));
    }
    figure.lines.push_back({.label = "shear", .x = t.position, .y = t.value, .colour = line_colour(1)});
    all.push_back(std::move(figure));
  }
  return all;
}

}  // namespace reye::output
