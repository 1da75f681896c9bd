#include "output/report/profiles.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace reye::output {

Unit length_unit(double largest_mm) {
  if (largest_mm < 1e-4) return {1e6, "nm"};
  if (largest_mm < 0.1) return {1e3, "µm"};
  return {1.0, "mm"};
}

double largest(const std::vector<double>& values) {
  double size = 0.0;
  for (const double v : values)
    if (std::isfinite(v)) size = std::max(size, std::abs(v));
  return size;
}

std::string title_of(const RunData& run, const ContactData& contact, const std::string& what) {
  return run.contacts.size() > 1 ? what + ", contact " + contact.name : what;
}

namespace {

/// Arc length all round where the rows of a frame are one ring, which ends with the row it began with; else 0.
double round_of(const SurfaceTable& surface, const FrameRows& rows) {
  const auto &x = surface.table.column("x_mm"), &y = surface.table.column("y_mm"), &body = surface.table.column("body");
  const std::size_t first = rows.begin, last = rows.end - 1;
  const bool ring = last > first + 1 && x[first] == x[last] && y[first] == y[last] && body[first] == body[last];
  return ring ? surface.table.column("arc_length_mm")[last] : 0.0;
}

/// Arc length from the centre, on a ring along the shorter way.
double position(double arc, double centre, double round) {
  return round > 0.0 ? std::remainder(arc - centre, round) : arc - centre;
}

/// The mean position of a weight on the rows of a frame, about `from`; nothing where it adds up to nothing.
std::optional<double> centroid(const SurfaceTable& surface, const FrameRows& rows, const std::vector<double>& weight,
                               double from) {
  const auto& s = surface.table.column("arc_length_mm");
  const double round = round_of(surface, rows);
  double sum = 0.0, moment = 0.0;
  for (std::size_t i = rows.begin; i + 1 < rows.end; ++i) {
    const double w = 0.5 * (weight[i] + weight[i + 1]) * (s[i + 1] - s[i]);
    sum += w;
    moment += w * position(0.5 * (s[i] + s[i + 1]), from, round);
  }
  return sum > 0.0 ? std::optional(from + moment / sum) : std::nullopt;
}

/// The row with the largest weight of a frame.
std::size_t heaviest(const FrameRows& rows, const std::vector<double>& weight) {
  const auto at = [&](std::size_t i) { return weight.begin() + static_cast<std::ptrdiff_t>(i); };
  return static_cast<std::size_t>(std::max_element(at(rows.begin), at(rows.end)) - weight.begin());
}

}  // namespace

double centre_of(const SurfaceTable& surface) {
  const auto& s = surface.table.column("arc_length_mm");
  const FrameRows& rows = surface.frames.back();
  for (const char* name : {"pressure_MPa", "wear_depth_mm"}) {
    const auto& weight = surface.table.column(name);
    const auto near = centroid(surface, rows, weight, s[heaviest(rows, weight)]);
    if (near) return *centroid(surface, rows, weight, *near);
  }
  return 0.5 * (s[rows.begin] + s[rows.end - 1]);
}

Range active_range(const SurfaceTable& surface, double centre) {
  const auto& s = surface.table.column("arc_length_mm");
  const auto& p = surface.table.column("pressure_MPa");
  const auto& h = surface.table.column("wear_depth_mm");
  const double p_small = 1e-6 * largest(p), h_small = 1e-3 * largest(h);
  Range active{INFINITY, -INFINITY}, whole = active;
  for (const FrameRows& rows : surface.frames) {
    const double round = round_of(surface, rows);
    for (std::size_t i = rows.begin; i < rows.end; ++i) {
      const double at = position(s[i], centre, round);
      whole = {std::min(whole.low, at), std::max(whole.high, at)};
      if (p[i] > p_small || h[i] > h_small) active = {std::min(active.low, at), std::max(active.high, at)};
    }
  }
  if (active.low > active.high) return whole;
  const double margin = 0.12 * active.width();
  return {std::max(whole.low, active.low - margin), std::min(whole.high, active.high + margin)};
}

Line column_line(const SurfaceTable& surface, const FrameRows& rows, const std::string& column, double factor,
                 double centre) {
  const auto& s = surface.table.column("arc_length_mm");
  const auto& y = surface.table.column(column);
  const double round = round_of(surface, rows);
  Line line;
  for (std::size_t i = rows.begin; i < rows.end; ++i) {
    if (i > rows.begin && s[i] <= s[i - 1]) {  // another chain
      line.x.push_back(s[i] - centre);
      line.y.push_back(NAN);
    }
    line.x.push_back(position(s[i], centre, round));
    line.y.push_back(factor * y[i]);
  }
  if (round == 0.0) return line;
  line.x.pop_back();  // the row that the ring began with
  line.y.pop_back();
  const auto first = std::min_element(line.x.begin(), line.x.end()) - line.x.begin();
  std::rotate(line.x.begin(), line.x.begin() + first, line.x.end());
  std::rotate(line.y.begin(), line.y.begin() + first, line.y.end());
  return line;
}

double deepest_of(const ContactData& contact) {
  double deepest = 0.0;
  for (const auto& surface : contact.sides) deepest = std::max(deepest, largest(surface.table.column("wear_depth_mm")));
  return deepest;
}

std::vector<std::size_t> evenly_chosen(std::size_t count, std::size_t most) {
  std::vector<std::size_t> some;
  if (count <= most)
    for (std::size_t k = 0; k < count; ++k) some.push_back(k);
  else
    for (std::size_t k = 0; k < most; ++k) some.push_back(k * (count - 1) / (most - 1));
  return some;
}

}  // namespace reye::output
