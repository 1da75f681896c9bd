#include "sim/solid/solid_assembly.hpp"

#include <map>
#include <type_traits>
#include <utility>

#include "base/cores.hpp"
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

/// A body beside how it turns.
struct CondensedBody {
  body::SolidBody body;
  std::optional<body::SolidTurning> turning;
};

/// A body of the old equations that serves the new ones, too; its nodes must be the same.
std::optional<CondensedBody> kept_body(std::optional<SolidAssembly>& old, std::size_t b, const mesh::SolidMesh* mesh,
                                       const std::vector<int>& nodes) {
  if (!old) return {};
  auto& body = old->system.bodies[b];
  if (body.input().mesh.get() != mesh || body.retained() != nodes) return {};
  return CondensedBody{std::move(body), std::move(old->system.turning[b])};
}

/// A body condensed in its present shape. One that turns does so about centres as they were drawn.
CondensedBody make_body(const body::SolidInput& drawn, const std::shared_ptr<const mesh::SolidMesh>& mesh,
                        const std::vector<int>& nodes, std::optional<algebra::SchurFactor> spare) {
  auto input = drawn;
  input.mesh = mesh;
  const auto pivot = body::solid_pivot(drawn);
  if (!pivot) return {{std::move(input), nodes, std::move(spare)}, {}};
  for (auto& support : input.supports) support.centre_mm = body::place_support(*drawn.mesh, support).centre;
  return {{body::in_frame(input, *pivot), nodes, std::move(spare)}, body::make_turning(input, *pivot, nodes)};
}

using Places = std::map<std::array<int, 2>, std::size_t>;

Places places_of(const std::vector<std::array<int, 2>>& points) {
  Places places;
  for (std::size_t j = 0; j < points.size(); ++j) places[points[j]] = j;
  return places;
}

/// Values of the points that were there before.
template <class T>
void carry_values(const Places& old, const std::vector<std::array<int, 2>>& points, const std::vector<T>& from,
                  std::vector<T>& to) {
  for (std::size_t j = 0; j < points.size(); ++j)
    if (const auto found = old.find(points[j]); found != old.end()) to[j] = from[found->second];
}

}  // namespace

std::vector<SkinPoints> points_of(const solver::SolidSystem& system) {
  std::vector<SkinPoints> all;
  const auto names = [](const contact::SkinSide& side) {
    std::vector<std::array<int, 2>> list;
    for (const auto& point : side.points) list.push_back({point.body, point.node});
    return list;
  };
  for (const auto& setup : system.contacts) all.push_back({names(setup.secondary), names(setup.primary)});
  return all;
}

SolidAssembly assemble(const SolidProblem& problem, const SolidMeshes& meshes, const Touchable& touchable,
                       std::optional<SolidAssembly> old) {
  const double start = cpu_seconds();
  SolidAssembly assembly;
  std::vector<std::optional<CondensedBody>> made(problem.inputs.size());
  std::vector<std::optional<algebra::SchurFactor>> spare(made.size());
  for (std::size_t b = 0; b < made.size(); ++b) {
    made[b] = kept_body(old, b, meshes[b].get(), chosen(touchable[b]));
    assembly.factorised += !made[b];
    if (old && !made[b]) spare[b] = old->system.bodies[b].take_factor();
  }
  old.reset();  // the dense matrices of a body's shape before are gone when those of the next are made
  base::side_by_side(static_cast<int>(made.size()), [&](int body) {
    const auto b = static_cast<std::size_t>(body);
    if (!made[b]) made[b] = make_body(problem.inputs[b], meshes[b], chosen(touchable[b]), std::move(spare[b]));
  });
  std::vector<body::SolidBody> bodies;
  std::vector<std::optional<body::SolidTurning>> turning;
  int next = 0;
  for (auto& one : made) {
    bodies.push_back(std::move(one->body));
    turning.push_back(std::move(one->turning));
    const std::size_t b = bodies.size() - 1;
    auto& columns = assembly.columns.emplace_back(touchable[b].size(), -1);
    for (const int node : bodies.back().retained()) columns[node] = next++;
  }
  assembly.system = solver::make_system(std::move(bodies), std::move(turning));
  set_contacts(problem, meshes, assembly);
  assembly.seconds = cpu_seconds() - start;
  return assembly;
}

void set_contacts(const SolidProblem& problem, const SolidMeshes& meshes, SolidAssembly& assembly) {
  std::vector<const mesh::SolidMesh*> shapes;
  for (const auto& mesh : meshes) shapes.push_back(mesh.get());
  auto& contacts = assembly.system.contacts;
  contacts.clear();
  for (const auto& contact : problem.contacts)
    contacts.push_back(contact::make_skin_setup(
        contact.options, contact::make_side({contact.secondary}, shapes, assembly.columns),
        contact::make_side(contact.primary, shapes, assembly.columns), contact.modulus_MPa, contact.search_mm));
}

std::vector<contact::SkinWear> carried_wear(const std::vector<SkinPoints>& from, const solver::SolidSystem& to,
                                            const std::vector<contact::SkinWear>& wear) {
  const auto points = points_of(to);
  std::vector<contact::SkinWear> all;
  for (std::size_t c = 0; c < points.size(); ++c) {
    const auto secondary = places_of(from[c].secondary), primary = places_of(from[c].primary);
    auto& fresh = all.emplace_back(contact::fresh_wear(to.contacts[c]));
    contact::for_each_field(wear[c], fresh, [&](const contact::Field& field, const auto& old, auto& now) {
      if constexpr (std::is_arithmetic_v<std::remove_reference_t<decltype(now)>>)
        now = old;
      else if (field.site == contact::Site::secondary)
        carry_values(secondary, points[c].secondary, old, now);
      else
        carry_values(primary, points[c].primary, old, now);
    });
  }
  return all;
}

solver::SolidState carried(const std::vector<SkinPoints>& from, const solver::SolidSystem& to,
                           const solver::SolidState& state) {
  solver::SolidState fresh = solver::initial_state(to);
  fresh.a = state.a;
  fresh.s = state.s;
  fresh.turn = state.turn;
  const auto points = points_of(to);
  for (std::size_t c = 0; c < points.size(); ++c) {
    const auto secondary = places_of(from[c].secondary);
    carry_values(secondary, points[c].secondary, state.traction[c], fresh.traction[c]);
    carry_values(secondary, points[c].secondary, state.status[c], fresh.status[c]);
  }
  fresh.wear = carried_wear(from, to, state.wear);
  fresh.u = solver::displacements_of(to, fresh);
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
