#include "sim/solid/solid_assembly.hpp"

#include "sim/problem/timer.hpp"

namespace reye::sim {

namespace {

std::vector<int> chosen(const std::vector<char>& nodes) {
  std::vector<int> list;
  for (std::size_t n = 0; n < nodes.size(); ++n)
    if (nodes[n]) list.push_back(static_cast<int>(n));
  return list;
}

/// Whether a primary point that faces a secondary one lies at the rim.
bool faces_rim(const contact::SkinPlace& place, int point, const std::vector<char>& rim_columns) {
  for (contact::SkinRows::InnerIterator it(place.Q, point); it; ++it)
    if (it.value() < 0.0 && rim_columns[static_cast<std::size_t>(it.col())]) return true;
  return false;
}

}  // namespace

SolidAssembly assemble(const SolidProblem& problem, const Touchable& touchable) {
  const double start = cpu_seconds();
  SolidAssembly assembly;
  std::vector<body::SolidBody> bodies;
  std::vector<std::optional<body::SolidTurning>> turning;
  int next = 0;
  for (std::size_t b = 0; b < problem.inputs.size(); ++b) {
    const auto& input = problem.inputs[b];
    const auto retained = chosen(touchable[b]);
    const auto pivot = body::solid_pivot(input);
    bodies.emplace_back(pivot ? body::in_frame(input, *pivot) : input, retained);
    turning.push_back(pivot ? std::optional(body::make_turning(input, *pivot, retained)) : std::nullopt);
    auto& columns = assembly.columns.emplace_back(touchable[b].size(), -1);
    for (const int node : bodies.back().retained()) columns[node] = next++;
  }
  assembly.system = solver::make_system(std::move(bodies), std::move(turning));
  std::vector<const mesh::SolidMesh*> meshes;
  for (const auto& input : problem.inputs) meshes.push_back(input.mesh.get());
  for (const auto& contact : problem.contacts)
    assembly.system.contacts.push_back(contact::make_skin_setup(
        contact.options, contact::make_side({contact.secondary}, meshes, assembly.columns),
        contact::make_side(contact.primary, meshes, assembly.columns), contact.modulus_MPa, contact.search_mm));
  assembly.seconds = cpu_seconds() - start;
  return assembly;
}

solver::SolidState carried(const SolidAssembly& from, const SolidAssembly& to, const solver::SolidState& state) {
  solver::SolidState fresh = solver::initial_state(to.system);
  fresh.a = state.a;
  fresh.s = state.s;
  fresh.turn = state.turn;
  for (std::size_t c = 0; c < from.system.contacts.size(); ++c) {
    std::map<std::array<int, 2>, std::size_t> places;
    const auto& old_points = from.system.contacts[c].secondary.points;
    for (std::size_t j = 0; j < old_points.size(); ++j) places[{old_points[j].body, old_points[j].node}] = j;
    const auto& points = to.system.contacts[c].secondary.points;
    for (std::size_t j = 0; j < points.size(); ++j)
      if (const auto found = places.find({points[j].body, points[j].node}); found != places.end()) {
        fresh.traction[c][j] = state.traction[c][found->second];
        fresh.status[c][j] = state.status[c][found->second];
      }
  }
  fresh.u = solver::displacements_of(to.system, fresh);
  return fresh;
}

bool outrun(const solver::SolidSystem& system, const solver::SolidSolution& solution) {
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const auto& setup = system.contacts[c];
    std::vector<char> rim(static_cast<std::size_t>(system.points()), 0);
    for (std::size_t l = 0; l < setup.primary.points.size(); ++l)
      if (setup.primary.rim[l]) rim[setup.primary.points[l].column] = 1;
    for (int j = 0; j < setup.count(); ++j) {
      if (solution.state.status[c][j] == contact::SkinStatus::open) continue;
      if (setup.secondary.rim[j] || faces_rim(solution.place[c], j, rim)) return true;
    }
  }
  return false;
}

}  // namespace reye::sim
