#include "output/profiles.hpp"

#include <algorithm>
#include <cmath>

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

double centre_of(const SurfaceTable& surface) {
  const auto& s = surface.table.column("arc_length_mm");
  const FrameRows& rows = surface.frames.back();
  for (const char* name : {"pressure_MPa", "wear_depth_mm"}) {
    const auto& weight = surface.table.column(name);
    double sum = 0.0, moment = 0.0;
    for (std::size_t i = rows.begin; i + 1 < rows.end; ++i) {
      const double w = 0.5 * (weight[i] + weight[i + 1]) * (s[i + 1] - s[i]);
      sum += w;
      moment += 0.5 * w * (s[i] + s[i + 1]);
    }
    if (sum > 0.0) return moment / sum;
  }
  return 0.5 * (s[rows.begin] + s[rows.end - 1]);
}

Range active_range(const SurfaceTable& surface, double centre) {
  const auto& s = surface.table.column("arc_length_mm");
  const auto& p = surface.table.column("pressure_MPa");
  const auto& h = surface.table.column("wear_depth_mm");
  const double p_small = 1e-6 * largest(p), h_small = 1e-3 * largest(h);
  Range active{INFINITY, -INFINITY}, whole = active;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const double at = s[i] - centre;
    whole = {std::min(whole.low, at), std::max(whole.high, at)};
    if (p[i] > p_small || h[i] > h_small) active = {std::min(active.low, at), std::max(active.high, at)};
  }
  if (active.low > active.high) return whole;
  const double margin = 0.12 * active.width();
  return {std::max(whole.low, active.low - margin), std::min(whole.high, active.high + margin)};
}

Line column_line(const SurfaceTable& surface, const FrameRows& rows, const std::string& column, double factor,
                 double centre) {
  const auto& s = surface.table.column("arc_length_mm");
  const auto& y = surface.table.column(column);
  Line line;
  for (std::size_t i = rows.begin; i < rows.end; ++i) {
    line.x.push_back(s[i] - centre);
    line.y.push_back(factor * y[i]);
  }
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
