#include "sim/measure/measure.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "sim/measure/surfaces.hpp"

namespace reye::sim {

using contact::ContactStatus;

wear::Ledger ledger(const contact::ContactState& state) {
  const auto sum = [](const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); };
  return {state.law_volume, state.strip_secondary + sum(state.pending_secondary),
          state.strip_primary + sum(state.pending_primary)};
}

namespace {

/// Zero of the straight line through (x1, f1), (x2, f2), x1 the outer point; at most one spacing beyond it,
/// where the next node would have been loaded, and at x1 itself where f does not fall outwards.
double zero_of_line(double x1, double f1, double x2, double f2) {
  if (f2 <= f1) return x1;
  const double ratio = f1 / (f2 - f1);
  return ratio > 1.0 ? x1 : x1 - ratio * (x2 - x1);
}

/// Half of the distance between the ends of a bump f = A (x - low)(high - x). Divided by the distance from the
/// other end it is a straight line, whose zero follows from the two outermost points; the ends are found in turn.
std::optional<double> half_width(const std::vector<double>& x, const std::vector<double>& f) {
  const std::size_t n = x.size();
  if (n < 4) return std::nullopt;
  double low = x[0], high = x[n - 1];
  const auto slope = [&](std::size_t i, double other) { return f[i] / std::abs(x[i] - other); };
  constexpr int turns = 30;  // each turn leaves less than a quarter of the error
  for (int turn = 0; turn < turns; ++turn) {
    low = zero_of_line(x[0], slope(0, high), x[1], slope(1, high));
    high = zero_of_line(x[n - 1], slope(n - 1, low), x[n - 2], slope(n - 2, low));
  }
  return 0.5 * (high - low);
}

bool is_ring(const SurfaceRecord& s) {
  return s.node.size() > 2 && s.node.front() == s.node.back() && s.body.front() == s.body.back();
}

/// Rows of a table in order, with their arc length. A ring is opened in the middle of the longest stretch of rows that
/// `keep` refuses, so that the kept rows are in one piece wherever the table begins.
struct Opened {
  std::vector<std::size_t> row;
  std::vector<double> arc;
};

template <class Keep>
Opened opened(const SurfaceRecord& s, Keep keep) {
  const bool ring = is_ring(s);
  const std::size_t n = s.arc_length_mm.size() - (ring ? 1 : 0);
  std::size_t first = 0, longest = 0;
  for (std::size_t i = 0; ring && i < n; ++i) {
    std::size_t run = 0;
    while (run < n && !keep((i + run) % n)) ++run;
    if (run <= longest) continue;
    longest = run;
    first = (i + run / 2) % n;
  }
  Opened o;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = (first + k) % n;
    o.row.push_back(i);
    o.arc.push_back(s.arc_length_mm[i] + (i < first ? s.arc_length_mm.back() : 0.0));
  }
  return o;
}

/// A bump that ends on the axis of axisymmetry continues beyond it as its mirror image. `r`: distances from the axis.
void mirror_at_axis(const std::vector<double>& r, std::vector<double>& x, std::vector<double>& f) {
  const std::size_t n = r.size();
  if (n == 0) return;
  const double on_axis = 1e-9 * *std::max_element(r.begin(), r.end());
  if (r.back() <= on_axis) {  // so that it begins there, with arc lengths that increase
    std::reverse(x.begin(), x.end());
    std::reverse(f.begin(), f.end());
    for (double& s : x) s = -s;
  } else if (r.front() > on_axis) {
    return;
  }
  std::vector<double> both, values;
  for (std::size_t i = n - 1; i > 0; --i) {
    both.push_back(2.0 * x[0] - x[i]);
    values.push_back(f[i]);
  }
  both.insert(both.end(), x.begin(), x.end());
  values.insert(values.end(), f.begin(), f.end());
  x = std::move(both);
  f = std::move(values);
}

template <class Keep, class Value>
std::optional<double> half_width_of(const SurfaceRecord& s, base::Analysis analysis, Keep keep, Value value) {
  std::vector<double> x, f, r;
  const bool axis = analysis == base::Analysis::axisymmetric;
  const Opened o = opened(s, keep);
  for (std::size_t k = 0; k < o.row.size(); ++k)
    if (keep(o.row[k])) {
      x.push_back(o.arc[k]);
      f.push_back(value(o.row[k]));
      if (axis) r.push_back(s.x_mm[o.row[k]]);
    }
  if (axis) mirror_at_axis(r, x, f);
  return half_width(x, f);
}

SideSummary side_summary(const SurfaceRecord& surface, double worn_area) {
  SideSummary side;
  if (!surface.wear_depth_mm.empty())
    side.max_depth_mm = *std::max_element(surface.wear_depth_mm.begin(), surface.wear_depth_mm.end());
  side.worn_area = worn_area;
  side.scar_width_mm = scar_width(surface);
  return side;
}

}  // namespace

std::optional<double> contact_half_width(const SurfaceRecord& s, base::Analysis analysis) {
  return half_width_of(
      s, analysis, [&](std::size_t i) { return s.status[i] != 0 && s.pressure_MPa[i] > 0.0; },
      [&](std::size_t i) { return s.pressure_MPa[i] * s.pressure_MPa[i]; });
}

std::optional<double> stick_half_width(const SurfaceRecord& s, double friction, base::Analysis analysis) {
  return half_width_of(
      s, analysis, [&](std::size_t i) { return s.status[i] == 1; },
      [&](std::size_t i) {
        const double margin = friction * s.pressure_MPa[i] - std::abs(s.shear_MPa[i]);
        return margin * margin;
      });
}

double scar_width(const SurfaceRecord& s) {
  if (s.wear_depth_mm.empty()) return 0.0;
  const double bound = 0.005 * *std::max_element(s.wear_depth_mm.begin(), s.wear_depth_mm.end());
  if (bound <= 0.0) return 0.0;
  const Opened o = opened(s, [&](std::size_t i) { return s.wear_depth_mm[i] > bound; });
  const auto d = [&](std::size_t k) { return s.wear_depth_mm[o.row[k]]; };
  std::size_t first = 0, last = o.row.size() - 1;
  while (d(first) <= bound) ++first;
  while (d(last) <= bound) --last;
  const auto crossing = [&](std::size_t in, std::size_t out) {
    return o.arc[in] + (o.arc[out] - o.arc[in]) * (d(in) - bound) / (d(in) - d(out));
  };
  if (is_ring(s) && first == 0 && last + 1 == o.row.size()) return s.arc_length_mm.back();  // worn all round
  const double begin = first == 0 ? o.arc[0] : crossing(first, first - 1);
  const double end = last + 1 == o.row.size() ? o.arc[last] : crossing(last, last + 1);
  return end - begin;
}

namespace {

/// The force of a contact: the whole, and the part of the pressures.
struct Carried {
  Vec2 all = Vec2::Zero(), pressure = Vec2::Zero();
};

Carried carried(const contact::ContactState& state) {
  Carried sum;
  for (std::size_t j = 0; j < state.lambda.size(); ++j) {
    const Vec2 f = state.reference[j].carried() * state.lambda[j];
    sum.all += f;
    sum.pressure += f.dot(state.normal[j]) * state.normal[j];
  }
  return sum;
}

/// The direction in which a contact presses: that of its pressures' resultant. A ring has no radial resultant: where
/// the axial one is less than half of the radial integral the contact presses radially, else along the axis.
Vec2 pressing_direction(const Vec2& pressure, base::Analysis analysis) {
  if (analysis != base::Analysis::axisymmetric) return pressure.normalized();
  const bool radial = std::abs(pressure.y()) < 0.5 * std::abs(pressure.x());
  return radial ? Vec2(std::copysign(1.0, pressure.x()), 0.0) : Vec2(0.0, std::copysign(1.0, pressure.y()));
}

}  // namespace

std::pair<double, double> forces_of(const contact::ContactState& state, base::Analysis analysis) {
  const Carried force = carried(state);
  if (force.pressure.norm() == 0.0) return {0.0, 0.0};
  const Vec2 n = pressing_direction(force.pressure, analysis);
  Vec2 along(-n.y(), n.x());
  if (along.x() < 0.0 || (along.x() == 0.0 && along.y() < 0.0)) along = -along;
  // Round a ring pressures along the radius cancel: there it is what friction pulls, summed.
  const bool round = analysis == base::Analysis::axisymmetric && n.x() == 0.0;
  const Vec2 pull = round ? Vec2(force.all - force.pressure) : force.all;
  return {force.all.dot(n), -pull.dot(along)};
}

ContactSummary summarise(const contact::Setup& setup, const contact::ContactState& state,
                         const std::vector<body::ShapePtr>& shapes, const PlacedContact& placed) {
  ContactSummary c;
  c.name = setup.options.name;
  const auto surfaces = surface_records(setup, state, shapes, placed);
  const auto& s = surfaces[0];
  const double peak = *std::max_element(s.pressure_MPa.begin(), s.pressure_MPa.end());
  if (peak > 0.0) c.peak_pressure_MPa = peak;
  c.contact_half_width_mm = contact_half_width(s, setup.analysis);
  if (state.friction > 0.0 && state.nodal_friction.empty() && !setup.options.imposed)
    c.stick_half_width_mm = stick_half_width(s, state.friction, setup.analysis);
  std::tie(c.normal_force, c.tangential_force) = forces_of(state, setup.analysis);
  c.dissipated_energy = setup.options.wear.wears() ? state.worn_work : state.frictional_work;
  const auto book = ledger(state);
  c.secondary = side_summary(s, book.removed_secondary);
  c.primary = side_summary(surfaces[1], book.removed_primary);
  if (setup.options.wear.wears()) c.ledger_relative_error = book.relative_error();
  return c;
}

}  // namespace reye::sim
