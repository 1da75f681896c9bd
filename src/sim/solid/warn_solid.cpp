#include "sim/solid/warn_solid.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/formatted.hpp"
#include "body/solid/solid_pivot.hpp"
#include "mesh/solid/solid_measure.hpp"
#include "sim/problem/warnings.hpp"
#include "sim/solid/whole_patch.hpp"

namespace reye::sim {

namespace {

using contact::SkinStatus;

void forget(std::vector<Warning>& warnings, const std::string& kind, const std::string& about) {
  std::erase_if(warnings, [&](const Warning& w) { return w.kind == kind && w.about == about; });
}

/// Points on the edge of the secondary side that no support holds there, as one on a plane of symmetry is.
std::vector<char> edge_points(const contact::SkinSetup& setup, const contact::SkinPlace& place) {
  std::map<std::array<int, 2>, int> edges;
  const auto ends = [](const mesh::Facet& f, int k) {
    std::array<int, 2> edge{f.nodes[k], f.nodes[(k + 1) % facet_corners(f.kind)]};
    std::sort(edge.begin(), edge.end());
    return edge;
  };
  for (const auto& facet : setup.secondary.skin.facets)
    for (int k = 0; k < facet_corners(facet.kind); ++k) ++edges[ends(facet, k)];
  std::vector<char> at_edge(setup.secondary.points.size(), 0);
  for (const auto& [edge, count] : edges)
    for (const int j : edge)
      if (count == 1 && !setup.secondary.rim[j] && place.frame[j].free == 2) at_edge[j] = 1;
  return at_edge;
}

struct Pressures {
  double largest = 0.0, at_edge = 0.0, mean = 0.0;
};

Pressures pressures(const contact::SkinSetup& setup, const solver::SolidSolution& solution, std::size_t c) {
  const auto at_edge = edge_points(setup, solution.place[c]);
  Pressures p;
  double area = 0.0;
  for (int j = 0; j < setup.count(); ++j) {
    if (solution.state.status[c][j] == SkinStatus::open) continue;
    const double own = solution.nodes[c][j].traction.dot(solution.place[c].frame[j].normal);
    p.largest = std::max(p.largest, own);
    if (at_edge[j]) p.at_edge = std::max(p.at_edge, own);
    p.mean += own * solution.place[c].covered[j];
    area += solution.place[c].covered[j];
  }
  if (area > 0.0) p.mean /= area;
  return p;
}

/// Facets across the smaller half width of the contact.
double elements_across(const SolidProblem& problem, const solver::SolidSystem& system,
                       const solver::SolidSolution& solution, std::size_t c) {
  const WholePatch patch = whole_patch(problem, system, solution, c);
  if (patch.x.empty()) return 0.0;
  const double size = patch.element();
  return size > 0.0 ? patch.half_widths()[1] / size : 0.0;
}

void warn_resolution(const SolidProblem& problem, const solver::SolidSystem& system,
                     const solver::SolidSolution& solution, std::size_t c, std::vector<Warning>& warnings) {
  constexpr double enough = 4.0;
  const std::string about = "contact " + problem.contacts[c].options.name;
  const double across = elements_across(problem, system, solution, c);
  forget(warnings, "resolution", about);  // what counts is the last state
  if (across > 0.0 && across < enough)
    warn(warnings, {"resolution", about,
                    base::formatted("%.2g elements lie across half the width of the contact: pressure and area may be "
                                    "off by tens of per cent; give its fine_zone a smaller size_mm",
                                    across),
                    1.0 / across});
}

void warn_edge(const SolidProblem& problem, const solver::SolidSystem& system, const solver::SolidSolution& solution,
               std::size_t c, std::vector<Warning>& warnings) {
  const auto p = pressures(system.contacts[c], solution, c);
  if (p.at_edge > 1.5 * p.mean && p.at_edge > 0.0)
    warn(warnings, {"edge", "contact " + problem.contacts[c].options.name,
                    base::formatted("the pressure rises to %.3g MPa at the edge of the secondary face, its mean is "
                                    "%.3g MPa: at a sharp edge it grows without bound as elements get smaller",
                                    p.at_edge, p.mean),
                    p.at_edge / p.mean});
  const double strain = p.largest / problem.contacts[c].modulus_MPa;
  if (strain > 0.02)
    warn(warnings,
         {"strain", "contact " + problem.contacts[c].options.name,
          base::formatted("the pressure reaches %.2g of Young's modulus: solids are computed at small strain, "
                          "whose error is of that size",
                          strain),
          strain});
}

/// Because of which support a body does not turn by any angle.
std::string small_turn_reason(const body::SolidInput& input) {
  const std::string support = body::solid_keeps_direction(input);
  return support.empty() ? std::string()
                         : ": support " + base::quoted(support) + " acts along directions that do not turn with it";
}

void warn_turn(const solver::SolidSystem& system, const solver::SolidSolution& solution,
               std::vector<Warning>& warnings) {
  constexpr double small = 0.02;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const auto& A = system.bodies[b].A();
    if (system.turning[b] || A.cols() == 0 || A.rows() < 6) continue;
    const auto a = solution.state.a.segment(system.first_free[b], A.cols());
    const base::Vector moved = A * a;
    Vec3 mean = Vec3::Zero();
    for (Eigen::Index i = 0; i < moved.size(); i += 3)
      mean += 3.0 / static_cast<double>(moved.size()) * moved.segment<3>(i);
    double spread = 0.0;
    for (Eigen::Index i = 0; i < moved.size(); i += 3) spread = std::max(spread, (moved.segment<3>(i) - mean).norm());
    const double turn = 2.0 * spread / mesh::box_diagonal(system.bodies[b].input().mesh->X);
    if (turn > small)
      warn(warnings, {"turn", "body " + system.bodies[b].input().name,
                      base::formatted("the body turns by about %.2g rad, which is computed as if it were small", turn) +
                          small_turn_reason(system.bodies[b].input()),
                      turn});
  }
}

}  // namespace

void watch_solid(const SolidProblem& problem, const solver::SolidSystem& system, const solver::SolidSolution& solution,
                 std::vector<Warning>& warnings) {
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    warn_resolution(problem, system, solution, c, warnings);
    warn_edge(problem, system, solution, c, warnings);
  }
  warn_turn(system, solution, warnings);
}

}  // namespace reye::sim
