#include "sim/measure/worn_through.hpp"

#include <cmath>
#include <limits>
#include <map>

#include "adapt/shape/unworn.hpp"
#include "base/formatted.hpp"

namespace reye::sim {

namespace {

/// The distance from a node along d to the nearest facet of the outline that does not end at it; infinite where there
/// is none.
double way_through(const mesh::Mesh& mesh, int node, const Vec2& d) {
  double way = std::numeric_limits<double>::infinity();
  const Vec2& from = mesh.X[node];
  for (const auto& loop : mesh.outline)
    for (std::size_t i = 0; i + 1 < loop.size(); ++i) {
      if (loop[i] == node || loop[i + 1] == node) continue;
      const Vec2 a = mesh.X[loop[i]] - from, e = mesh.X[loop[i + 1]] - mesh.X[loop[i]];
      const double across = base::cross(d, e);
      if (across == 0.0) continue;
      const double t = base::cross(a, e) / across, s = base::cross(a, d) / across;
      if (t > 0.0 && s >= 0.0 && s <= 1.0) way = std::min(way, t);
    }
  return way;
}

/// Direction into the body at every node of a boundary: the material lies left of its facets.
std::map<int, Vec2> inward(const mesh::Mesh& mesh, const mesh::Boundary& boundary) {
  std::map<int, Vec2> sums;
  for (const auto& chain : boundary)
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      const Vec2 e = mesh.X[chain[i + 1]] - mesh.X[chain[i]];
      for (int node : {chain[i], chain[i + 1]})
        sums.try_emplace(node, Vec2::Zero()).first->second += Vec2(-e.y(), e.x());
    }
  return sums;
}

/// The thinnest place of one worn side, if it is thinner than `most`.
void look(const Problem& problem, const contact::BoundaryRef& ref, const mesh::Mesh& mesh,
          std::optional<Thinnest>& most) {
  const auto& first = problem.shapes[ref.body]->mesh;
  const adapt::UnwornLine unworn(first, first.boundaries.at(ref.boundary));
  for (const auto& [node, d] : inward(mesh, mesh.boundaries.at(ref.boundary))) {
    const double worn = unworn.depth(mesh.X[node]), n = d.norm();
    if (!(worn > 0.0) || n == 0.0) continue;
    const Thinnest here{ref.body, way_through(mesh, node, d / n), worn};
    if (std::isfinite(here.left_mm) && (!most || here.share_left() < most->share_left())) most = here;
  }
}

}  // namespace

std::optional<Thinnest> thinnest(const Problem& problem, const std::vector<body::ShapePtr>& shapes) {
  std::optional<Thinnest> most;
  for (const auto& contact : problem.contacts) {
    const auto& law = contact.options.wear;
    if (law.secondary > 0.0) look(problem, contact.secondary, shapes[contact.secondary.body]->mesh, most);
    for (const auto& ref : contact.primary)
      if (law.primary > 0.0) look(problem, ref, shapes[ref.body]->mesh, most);
  }
  return most;
}

std::string in_words(const Problem& problem, const Thinnest& thinnest, double cycle) {
  return base::formatted(
      "body %s is worn by %.3g mm of the %.3g mm that it measured at cycle 0, %.2g mm are left (cycle %g); "
      "end the run before with a limit "
      "with stop = true, or check the wear coefficients",
      problem.inputs[thinnest.body].name.c_str(), thinnest.worn_mm, thinnest.worn_mm + thinnest.left_mm,
      thinnest.left_mm, cycle);
}

std::string worn_through(const Problem& problem, const State& last) {
  constexpr double worn_away = 0.2;  // of a body's thickness
  const auto place = thinnest(problem, last.shapes);
  return place && place->share_left() < 1.0 - worn_away ? in_words(problem, *place, last.cycle) : std::string();
}

}  // namespace reye::sim
