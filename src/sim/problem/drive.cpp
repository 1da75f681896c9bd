#include "sim/problem/drive.hpp"

#include <algorithm>
#include <cmath>

namespace reye::sim {

using body::Drive;

double factor_at(const scene::History& history, double progress) {
  if (progress <= history.front()[0]) return history.front()[1];
  for (std::size_t i = 1; i < history.size(); ++i) {
    const auto &a = history[i - 1], &b = history[i];
    if (progress <= b[0]) return a[1] + (b[1] - a[1]) * (progress - a[0]) / (b[0] - a[0]);
  }
  return history.back()[1];
}

namespace {

constexpr double most_turn = 0.3;  ///< rad in one increment: slip during a rotation is evaluated at its end

/// The change of a sum of parts between two moments of a step.
double played_between(const Histories& histories, const scene::Step& step, const base::Parts& parts, double from,
                      double to) {
  double sum = 0.0;
  for (const auto& [value, history] : parts) {
    if (std::find(step.play.begin(), step.play.end(), history) == step.play.end()) continue;
    const auto& corners = histories.at(history);
    sum += value * step.level * (factor_at(corners, to) - factor_at(corners, from));
  }
  return sum;
}

/// Largest angle by which a support turns its body between two moments of a step [rad].
double turned_between(const scene::Scene& scene, const scene::Step& step, double from, double to) {
  double most = 0.0;
  for (const auto& support : scene.supports) {
    if (support.rotation.drive == body::Drive::moved)
      most = std::max(most, std::abs(played_between(scene.histories, step, support.rotation.parts, from, to)));
  }
  return most;
}

}  // namespace

double parts_of_turn(double turn_rad) { return std::max(1.0, std::ceil(turn_rad / most_turn - 1e-9)); }

std::vector<double> divided_ends(const std::vector<double>& corners,
                                 const std::function<double(double, double)>& turned) {
  std::vector<double> ends;
  double from = 0.0;
  for (const double to : corners) {
    const auto parts = static_cast<int>(parts_of_turn(turned(from, to)));
    for (int i = 1; i < parts; ++i) ends.push_back(from + (to - from) * i / parts);
    ends.push_back(to);
    from = to;
  }
  return ends;
}

std::vector<double> step_corners(const Histories& histories, const scene::Step& step) {
  std::vector<double> corners;
  for (int i = 1; i <= step.increments; ++i) corners.push_back(static_cast<double>(i) / step.increments);
  for (const auto& name : step.play)
    for (const auto& corner : histories.at(name))
      if (corner[0] > 0.0 && corner[0] < 1.0) corners.push_back(corner[0]);
  std::sort(corners.begin(), corners.end());
  const auto same = [](double a, double b) { return std::abs(a - b) < 1e-9; };
  corners.erase(std::unique(corners.begin(), corners.end(), same), corners.end());
  return corners;
}

std::vector<double> increment_ends(const scene::Scene& scene, const scene::Step& step) {
  return divided_ends(step_corners(scene.histories, step),
                      [&](double from, double to) { return turned_between(scene, step, from, to); });
}

double divided_count(const std::vector<double>& corners, const std::function<double(double, double)>& turned) {
  double count = 0.0, from = 0.0;
  for (const double to : corners) {
    count += parts_of_turn(turned(from, to));
    from = to;
  }
  return count;
}

double increments_of(const scene::Scene& scene, const scene::Step& step) {
  return divided_count(step_corners(scene.histories, step),
                       [&](double from, double to) { return turned_between(scene, step, from, to); });
}

std::map<std::string, double> factors_at(const Histories& histories, const scene::Step& step, double progress,
                                         const std::map<std::string, double>& held) {
  auto factors = held;
  for (const auto& name : step.play) factors[name] = step.level * factor_at(histories.at(name), progress);
  return factors;
}

namespace {

double of(const std::map<std::string, double>& factors, const std::string& history) {
  return history.empty() ? 1.0 : factors.at(history);
}

}  // namespace

double sum_at(const base::Parts& parts, const std::map<std::string, double>& factors) {
  double sum = 0.0;
  for (const auto& part : parts) sum += part.value * of(factors, part.history);
  return sum;
}

double slid_between(const Histories& histories, const scene::Step& step, const base::Parts& parts, double from,
                    double to, bool evenly) {
  double sum = played_between(histories, step, parts, from, to);
  for (const auto& part : parts)
    if (evenly && part.history.empty()) sum += part.value * (to - from);
  return sum;
}

namespace {

/// The sign of the first imposed slip: of the first part that slides.
double first_way(const scene::Scene& scene, const base::Parts& parts) {
  for (const auto& [value, history] : parts) {
    double way = value;
    if (!history.empty()) {
      const auto& corners = scene.histories.at(history);
      const auto moved =
          std::find_if(corners.begin(), corners.end(), [&](const auto& c) { return c[1] != corners.front()[1]; });
      way = moved == corners.end() ? 0.0 : value * ((*moved)[1] - corners.front()[1]);
    }
    if (way != 0.0) return way < 0.0 ? -1.0 : 1.0;
  }
  return 1.0;
}

contact::IncrementOptions contact_options(const scene::Scene& scene, const contact::ContactOptions& options,
                                          const scene::Step& step, double from, double to, double jump) {
  contact::IncrementOptions o;
  o.jump = jump;
  o.wear = step.wear && options.wear.wears();
  o.duration_s = step.period_s * (to - from);
  const bool evenly = o.wear || !options.wear.wears();
  o.imposed_slip = slid_between(scene.histories, step, options.imposed_sliding, from, to, evenly);
  o.imposed_turn = slid_between(scene.histories, step, options.imposed_turn, from, to, evenly);
  o.first_way = first_way(scene, options.imposed_sliding);
  return o;
}

}  // namespace

double inset_at(const PlacedContact& contact, const std::map<std::string, double>& factors) {
  return contact.drawn.let_in ? contact.drawn.overlap_mm * factors.at(overlap_left) : 0.0;
}

solver::Controls controls_at(const Problem& problem, const solver::System& system,
                             const std::map<std::string, double>& factors, const scene::Step& step, double from,
                             double to, double jump) {
  solver::Controls controls;
  for (int b = 0; b < problem.body_count(); ++b) {
    for (const auto& column : body::support_columns(system.bodies[b])) {
      const auto& m = body::motion_of(problem.inputs[b].supports[column.support], column.motion);
      const int global = system.offset[b] + column.column;
      if (m.drive == Drive::fixed) controls.prescribed.emplace_back(global, 0.0);
      if (m.drive == Drive::moved) controls.prescribed.emplace_back(global, sum_at(m.parts, factors));
      if (m.drive == Drive::loaded) controls.forces.emplace_back(global, sum_at(m.parts, factors));
      if (m.stiffness > 0.0) controls.springs.push_back({global, m.stiffness});
    }
    const auto& list = body::loads(system.bodies[b]);
    Vector f(static_cast<Eigen::Index>(list.size()));
    for (std::size_t i = 0; i < list.size(); ++i) f[static_cast<Eigen::Index>(i)] = of(factors, list[i].history);
    controls.load_factors.push_back(std::move(f));
  }
  for (const auto& contact : problem.contacts) {
    controls.contacts.push_back(contact_options(problem.scene, contact.options, step, from, to, jump));
    controls.contacts.back().inset = inset_at(contact, factors);
  }
  for (std::size_t b = 0; b < problem.bonds.size(); ++b) {
    controls.contacts.emplace_back();
    controls.contacts.back().wear = false;
  }
  return controls;
}

void set_cycle(solver::Controls& controls, const Problem& problem, double cycle) {
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    controls.contacts[c].cycle = cycle;
    if (const auto& table = problem.contacts[c].options.friction_over_cycles; !table.empty())
      controls.contacts[c].friction = factor_at(table, cycle);
  }
}

void count_from_renewal(solver::Controls& controls, const Problem& problem, const solver::System& system,
                        const State& state) {
  if (state.renewed_at.empty()) return;
  std::map<int, double> from;
  for (int b = 0; b < problem.body_count(); ++b)
    for (const auto& column : body::support_columns(system.bodies[b]))
      from[system.offset[b] + column.column] = state.renewed_at[problem.support_of[b][column.support]][column.motion];
  for (auto& [column, value] : controls.prescribed) value -= from.at(column);
  for (auto& spring : controls.springs) spring.rest -= from.at(spring.column);
}

std::vector<std::optional<double>> support_moments(const Problem& problem, const solver::System& system,
                                                   const Vector& reactions) {
  std::vector<std::optional<double>> moments(problem.scene.supports.size());
  for (std::size_t s = 0; s < moments.size(); ++s)
    if (problem.scene.analysis != base::Analysis::axisymmetric && problem.scene.supports[s].rigid) moments[s] = 0.0;
  for (int b = 0; b < problem.body_count(); ++b)
    for (const auto& column : body::support_columns(system.bodies[b]))
      if (auto& moment = moments[problem.support_of[b][column.support]]; moment && column.motion == 2)
        *moment += reactions[system.offset[b] + column.column];
  return moments;
}

std::vector<Vec2> support_forces(const Problem& problem, const solver::System& system, const Vector& reactions) {
  std::vector<Vec2> forces(problem.scene.supports.size(), Vec2::Zero());
  for (int b = 0; b < problem.body_count(); ++b)
    for (const auto& column : body::support_columns(system.bodies[b]))
      forces[problem.support_of[b][column.support]] += reactions[system.offset[b] + column.column] * column.direction;
  return forces;
}

}  // namespace reye::sim
