#include "sim/reshape/depth.hpp"

#include <algorithm>

#include "adapt/shape/unworn.hpp"
#include "sim/measure/roundness.hpp"
#include "sim/measure/sides.hpp"
#include "sim/reshape/carry.hpp"

namespace reye::sim {

namespace {

/// Depths at the nodes of a boundary; of middle nodes the coefficients of their Bernstein functions.
std::vector<double> depths_on(const body::Shape& now, const body::Shape& first, const std::string& boundary,
                              const mortar::Surface& surface) {
  const adapt::UnwornLine unworn(first.mesh, first.mesh.boundaries.at(boundary));
  std::vector<double> depth;
  for (int node : mesh::nodes_of(now.mesh.boundaries.at(boundary))) depth.push_back(unworn.depth(now.mesh.X[node]));
  return mesh::control_points(surface.facets, std::move(depth));
}

/// `others`: volume that other contacts have taken off; null: none.
void measure(const Problem& problem, const State& state, const contact::BoundaryRef& ref, const double* pending,
             const double* others, double* removed) {
  const auto surface = surface_of(ref, problem.scene.analysis, state.shapes);
  const auto depth = depths_on(*state.shapes[ref.body], *problem.shapes[ref.body], ref.boundary, surface);
  // A remesh divides an arc into other chords and keeps the content under them: nodes lie off the worn curve by about a
  // sagitta. The depth of wear that is not much deeper follows from the volume removed at each node.
  constexpr double sagittas = 20.0;
  double facets = 0.0, deepest = 0.0;
  for (std::size_t k = 0; k < depth.size(); ++k) {
    if (removed[k] <= 0.0) continue;
    facets = std::max(facets, sagitta(surface, static_cast<int>(k)));
    deepest = std::max(deepest, depth[k]);
  }
  if (deepest < sagittas * facets) return;
  for (std::size_t k = 0; k < depth.size(); ++k)
    if (removed[k] > 0.0)
      removed[k] = std::max(depth[k] * surface.area[k] - (others ? others[k] : 0.0), 0.0) + pending[k];
}

/// The part of a list per node from `first` on; null: there is no list.
const double* part_from(const std::vector<double>& volume, std::size_t first) {
  return volume.empty() ? nullptr : volume.data() + first;
}

void measure_sides(const Problem& problem, const State& state, const PlacedContact& placed,
                   contact::ContactState& contact) {
  const auto& law = placed.options.wear;
  if (law.secondary > 0.0)
    measure(problem, state, placed.secondary, contact.pending_secondary.data(), part_from(contact.others_secondary, 0),
            contact.removed_secondary.data());
  std::size_t first = 0;
  for (const auto& ref : placed.primary) {
    if (law.primary > 0.0)
      measure(problem, state, ref, contact.pending_primary.data() + first, part_from(contact.others_primary, first),
              contact.removed_primary.data() + first);
    first += side_nodes(state.shapes, ref).size();
  }
}

}  // namespace

void measure_depths(const Problem& problem, State& state) {
  for (std::size_t c = 0; c < problem.contacts.size(); ++c)
    if (problem.contacts[c].options.wear.wears())
      measure_sides(problem, state, problem.contacts[c], state.solution.contacts[c]);
}

}  // namespace reye::sim
