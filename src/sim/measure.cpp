#include "sim/measure.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesh/measure.hpp"

namespace reye::sim {

using contact::ContactStatus;

std::vector<double> at_nodes(const mortar::Surface& surface, std::vector<double> coefficients) {
  for (const auto& [a, b, c] : surface.facets)
    if (c >= 0) coefficients[c] = 0.25 * (coefficients[a] + 2.0 * coefficients[c] + coefficients[b]);
  return coefficients;
}

std::vector<double> depths(const mortar::Surface& surface, const std::vector<double>& removed) {
  std::vector<double> depth(removed.size());
  for (std::size_t j = 0; j < depth.size(); ++j) depth[j] = removed[j] / surface.area[j];
  return at_nodes(surface, std::move(depth));
}

double deepest(const mortar::Surface& surface, const std::vector<double>& removed) {
  const auto depth = depths(surface, removed);
  return depth.empty() ? 0.0 : *std::max_element(depth.begin(), depth.end());
}

wear::Ledger ledger(const contact::ContactState& state) {
  const auto sum = [](const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); };
  return {state.law_work, state.strip_secondary + sum(state.pending_secondary),
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

template <class Keep, class Value>
std::optional<double> half_width_of(const SurfaceRecord& s, Keep keep, Value value) {
  std::vector<double> x, f;
  for (std::size_t i = 0; i < s.node.size(); ++i)
    if (keep(i)) {
      x.push_back(s.arc_length_mm[i]);
      f.push_back(value(i));
    }
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

std::optional<double> contact_half_width(const SurfaceRecord& s) {
  return half_width_of(
      s, [&](std::size_t i) { return s.status[i] != 0 && s.pressure_MPa[i] > 0.0; },
      [&](std::size_t i) { return s.pressure_MPa[i] * s.pressure_MPa[i]; });
}

std::optional<double> stick_half_width(const SurfaceRecord& s, double friction) {
  return half_width_of(
      s, [&](std::size_t i) { return s.status[i] == 1; },
      [&](std::size_t i) {
        const double margin = friction * s.pressure_MPa[i] - std::abs(s.shear_MPa[i]);
        return margin * margin;
      });
}

double scar_width(const SurfaceRecord& s) {
  const auto& d = s.wear_depth_mm;
  if (d.empty()) return 0.0;
  const double bound = 0.005 * *std::max_element(d.begin(), d.end());
  if (bound <= 0.0) return 0.0;
  std::size_t first = 0, last = d.size() - 1;
  while (d[first] <= bound) ++first;
  while (d[last] <= bound) --last;
  const auto crossing = [&](std::size_t in, std::size_t out) {
    return s.arc_length_mm[in] + (s.arc_length_mm[out] - s.arc_length_mm[in]) * (d[in] - bound) / (d[in] - d[out]);
  };
  const double begin = first == 0 ? s.arc_length_mm[0] : crossing(first, first - 1);
  const double end = last + 1 == d.size() ? s.arc_length_mm[last] : crossing(last, last + 1);
  return end - begin;
}

ContactSummary summarise(const contact::Setup& setup, const contact::ContactState& state,
                         const std::vector<body::ShapePtr>& shapes, const PlacedContact& placed) {
  ContactSummary c;
  c.name = setup.options.name;
  const auto surfaces = surface_records(setup, state, shapes, placed);
  const auto& s = surfaces[0];
  const double peak = *std::max_element(s.pressure_MPa.begin(), s.pressure_MPa.end());
  if (peak > 0.0) c.peak_pressure_MPa = peak;
  c.contact_half_width_mm = contact_half_width(s);
  if (state.friction > 0.0 && !setup.options.imposed) c.stick_half_width_mm = stick_half_width(s, state.friction);
  Vec2 force = Vec2::Zero(), direction = Vec2::Zero();
  for (int j = 0; j < setup.secondary_count(); ++j) {
    const int facet = setup.secondary.before[j] >= 0 ? setup.secondary.before[j] : setup.secondary.after[j];
    const auto [a, b, mid] = setup.secondary.facets[facet];
    const Vec2 normal = mesh::outward_normal(setup.secondary.X[a], setup.secondary.X[b]);
    const Vec2 f = state.reference[j].carried() * state.lambda[j];
    force += f;
    direction += f.dot(normal) * normal;
  }
  if (direction.norm() > 0.0) {
    const Vec2 n = direction.normalized();
    Vec2 along(-n.y(), n.x());
    if (along.x() < 0.0 || (along.x() == 0.0 && along.y() < 0.0)) along = -along;
    c.normal_force = force.dot(n);
    c.tangential_force = -force.dot(along);
  }
  c.dissipated_energy = setup.options.wear.wears() ? state.worn_work : state.frictional_work;
  const auto book = ledger(state);
  c.secondary = side_summary(s, book.removed_secondary);
  c.primary = side_summary(surfaces[1], book.removed_primary);
  if (setup.options.wear.wears()) c.ledger_relative_error = book.relative_error(setup.options.wear);
  return c;
}

double limit_measure(const scene::Limit& limit, const contact::Setup& setup, const contact::ContactState& state,
                     const std::vector<body::ShapePtr>& shapes, const PlacedContact& placed) {
  const auto c = summarise(setup, state, shapes, placed);
  const auto of = [&](const SideSummary& side) { return limit.depth_mm ? side.max_depth_mm : side.worn_area; };
  if (limit.side == "secondary") return of(c.secondary);
  if (limit.side == "primary") return of(c.primary);
  return of(c.secondary) + of(c.primary);
}

std::map<std::string, double> limit_measures(const Problem& problem, const solver::System& system, const State& state) {
  std::map<std::string, double> measures;
  for (const auto& limit : problem.scene.limits) {
    const auto found = std::find_if(problem.contacts.begin(), problem.contacts.end(),
                                    [&](const auto& c) { return c.options.name == limit.contact; });
    const auto c = static_cast<std::size_t>(found - problem.contacts.begin());
    measures[limit.name] = limit_measure(limit, system.contacts[c], state.solution.contacts[c], state.shapes, *found);
  }
  return measures;
}

}  // namespace reye::sim
