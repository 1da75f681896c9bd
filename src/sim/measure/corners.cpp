#include "sim/measure/corners.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "base/formatted.hpp"
#include "mesh/measure.hpp"

namespace reye::sim {

namespace {

constexpr double faced = 20.0 * std::numbers::pi / 180.0;  ///< normals farther apart than this do not face each other
constexpr double worth_a_word = 0.02;                      ///< of a contact's normal load

bool has_corners(const mortar::Surface& s) { return std::find(s.corner.begin(), s.corner.end(), 1) != s.corner.end(); }

/// The point of a surface nearest to x, and the outward normal there.
struct NearestPoint {
  double distance = std::numeric_limits<double>::infinity();
  Vec2 normal{0.0, 0.0};
};

/// `at`: where the nodes of the surface are.
NearestPoint nearest_point(const mortar::Surface& surface, const base::Points& at, const Vec2& x) {
  NearestPoint best;
  for (const auto& [a, b, c] : surface.facets) {
    const double distance = mesh::distance_to_edge(at[a], at[b], x);
    if (distance < best.distance) best = {distance, mesh::outward_normal(at[a], at[b])};
  }
  return best;
}

double angle_between(const Vec2& a, const Vec2& b) {
  return std::acos(std::clamp(a.dot(b) / (a.norm() * b.norm()), -1.0, 1.0));
}

/// The normal of a facet at one of its nodes.
Vec2 normal_at(const mortar::Surface& s, int facet, int end) {
  const auto& [a, b, c] = s.facets[facet];
  return end == 0 ? mesh::outward_normal(s.X[a], s.X[s.beside(facet, 0)])
                  : mesh::outward_normal(s.X[s.beside(facet, 1)], s.X[b]);
}

/// Whether the corner at a node points out of the body and neither of its facets faces a normal.
bool pokes(const mortar::Surface& s, int node, const Vec2& opposite) {
  const Vec2 n1 = normal_at(s, s.before[node], 1), n2 = normal_at(s, s.after[node], 0);
  return base::cross(n1, n2) > 0.0 && std::min(angle_between(n1, -opposite), angle_between(n2, -opposite)) > faced;
}

std::string advice(const Problem& problem, const PlacedContact& contact) {
  const bool swap = contact.primary.size() == 1 && !problem.rigid[contact.primary.front().body];
  return swap ? "swap primary and secondary" : "round it by a few elements";
}

/// The corner of the secondary side that is what touches on the drawing; -1: there is none.
int touching_corner(const contact::Setup& setup) {
  const auto& s = setup.secondary;
  double first = std::numeric_limits<double>::infinity();
  for (const Vec2& X : s.X) first = std::min(first, nearest_point(setup.primary, setup.primary.X, X).distance);
  for (int j = 0; j < s.node_count(); ++j) {
    if (!s.corner[j]) continue;
    const auto opposite = nearest_point(setup.primary, setup.primary.X, s.X[j]);
    if (opposite.distance <= first + 0.5 * setup.length[j] && pokes(s, j, opposite.normal)) return j;
  }
  return -1;
}

/// The normal load of each secondary node.
std::vector<double> normal_loads(const contact::ContactState& state) {
  std::vector<double> load;
  for (std::size_t j = 0; j < state.lambda.size(); ++j)
    load.push_back(state.reference[j].carried() * state.lambda[j].dot(state.normal[j]));
  return load;
}

}  // namespace

std::vector<base::Issue> corner_issues(const Problem& problem, const solver::System& system) {
  std::vector<base::Issue> issues;
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const auto& setup = system.contacts[c];
    const int corner = has_corners(setup.secondary) ? touching_corner(setup) : -1;
    if (corner < 0) continue;
    const Vec2& X = setup.secondary.X[corner];
    const std::string text = base::formatted(
        "its corner at (%.4g, %.4g) mm is what touches, and at a corner the direction of contact forces is "
        "undefined; %s",
        X.x(), X.y(), advice(problem, problem.contacts[c]).c_str());
    issues.push_back({"contact." + setup.options.name + ".secondary", '"' + setup.options.secondary + '"', text});
  }
  return issues;
}

namespace {

std::optional<Warning> corner_warning(const contact::Setup& setup, const contact::ContactState& state,
                                      const solver::Sides& sides) {
  const auto& s = setup.secondary;
  const auto load = normal_loads(state);
  const double all = std::accumulate(load.begin(), load.end(), 0.0);
  std::optional<Warning> worst;
  for (int j = 0; j < s.node_count(); ++j) {
    const double share = load[j] / all;
    if (!s.corner[j] || !(share > worth_a_word) || (worst && share <= worst->severity)) continue;
    const double angle =
        angle_between(state.normal[j], -nearest_point(setup.primary, sides.primary, sides.secondary[j]).normal);
    if (angle <= faced) continue;
    const std::string text = base::formatted(
        "a corner of its secondary side, at (%.4g, %.4g) mm, carries %.2g %% of its normal load along a normal %.2g "
        "degrees off the surface opposite: its force may leave the friction cone; swap the sides, or round it",
        sides.secondary[j].x(), sides.secondary[j].y(), 100.0 * share, angle * 180.0 / std::numbers::pi);
    worst = Warning{"corner", "contact " + setup.options.name, text, share};
  }
  return worst;
}

}  // namespace

std::vector<Warning> corner_warnings(const solver::System& system, const State& state) {
  std::vector<Warning> warnings;
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const auto& setup = system.contacts[c];
    if (setup.options.bonded || !has_corners(setup.secondary)) continue;
    auto warning =
        corner_warning(setup, state.solution.contacts[c], solver::positions(system, setup, state.solution.q.high));
    if (warning) warnings.push_back(std::move(*warning));
  }
  return warnings;
}

}  // namespace reye::sim
