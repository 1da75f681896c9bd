#include "sim/solid/solid_redraw.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "adapt/solid/skin_transfer.hpp"
#include "adapt/solid/solid_remesh.hpp"
#include "adapt/solid/solid_wear.hpp"
#include "base/formatted.hpp"
#include "sim/problem/warnings.hpp"
#include "sim/solid/solid_pressure_change.hpp"

namespace reye::sim {

namespace {

using adapt::SurfaceField;
using adapt::SurfaceKind;

adapt::SolidRemeshOptions remesh_options(const SolidProblem& problem, std::size_t b) {
  const auto& geometry = problem.scene.geometry;
  adapt::SolidRemeshOptions options;
  const std::string& name = problem.inputs[b].name;
  for (const auto& body : geometry.bodies)
    if (body.name == name) {
      options.far_size_mm = body.mesh.far_size_mm;
      options.growth = body.mesh.growth;
    }
  for (const auto& zone : geometry.fine_zones)
    if (zone.bodies.empty() || std::find(zone.bodies.begin(), zone.bodies.end(), name) != zone.bodies.end())
      options.zones.push_back({zone.centre_mm, zone.radius_mm, zone.half_widths_mm, zone.size_mm});
  return options;
}

/// The sides of a contact.
struct Sides {
  contact::SkinSide secondary, primary;
};

std::vector<Sides> sides_on(const SolidProblem& problem, const SolidMeshes& meshes, const contact::Columns& columns) {
  std::vector<const mesh::SolidMesh*> shapes;
  for (const auto& mesh : meshes) shapes.push_back(mesh.get());
  std::vector<Sides> sides;
  for (const auto& contact : problem.contacts)
    sides.push_back({contact::make_side({contact.secondary}, shapes, columns),
                     contact::make_side(contact.primary, shapes, columns)});
  return sides;
}

/// Nodes that contact may touch on the new meshes: those of the zones, and those beside what was kept before.
Touchable touchable_after(const SolidProblem& problem, const SolidMeshes& meshes, const std::vector<char>& fresh,
                          const std::vector<Sides>& before, const Touchable& old) {
  Touchable touchable = touchable_nodes(problem, meshes);
  const auto add = [&](const contact::SkinSide& side, const contact::FaceRef& face) {
    const auto b = static_cast<std::size_t>(face.body);
    if (!fresh[b]) return;
    Points3 places;
    for (std::size_t i = 0; i < side.points.size(); ++i)
      if (side.points[i].body == face.body) places.push_back(side.skin.x[i]);
    take_beside(*meshes[b], face.face, places, touchable[b]);
  };
  for (std::size_t c = 0; c < before.size(); ++c) {
    add(before[c].secondary, problem.contacts[c].secondary);
    for (const auto& face : problem.contacts[c].primary) add(before[c].primary, face);
  }
  for (std::size_t b = 0; b < fresh.size(); ++b)
    if (!fresh[b]) touchable[b] = old[b];
  return touchable;
}

bool lies_on_any(const contact::SkinSide& side, const std::vector<char>& fresh) {
  return std::any_of(side.points.begin(), side.points.end(),
                     [&](const auto& point) { return fresh[static_cast<std::size_t>(point.body)] != 0; });
}

/// Collects the fields of one side, and puts them back from what was carried, in the same order.
class SideFields {
 public:
  explicit SideFields(contact::Site site) : site_(site) {}

  std::vector<SurfaceField> of(const SolidRunState& state, std::size_t c) const {
    std::vector<SurfaceField> fields;
    if (site_ == contact::Site::secondary) {
      for (int d = 0; d < 3; ++d) {
        std::vector<double> values;
        for (const auto& z : state.solution.traction[c]) values.push_back(z[d]);
        fields.push_back({"traction", SurfaceKind::interpolated, std::move(values)});
      }
      std::vector<double> status, slid(state.slid[c].begin(), state.slid[c].end());
      for (const auto s : state.solution.status[c]) status.push_back(static_cast<double>(s));
      fields.push_back({"status", SurfaceKind::nearest, std::move(status)});
      fields.push_back({"slid", SurfaceKind::nearest, std::move(slid)});
    }
    contact::for_each_field(state.solution.wear[c], [&](const contact::Field& field, const auto& member) {
      if constexpr (!std::is_arithmetic_v<std::remove_cvref_t<decltype(member)>>)
        if (is_carried(field)) fields.push_back({std::string(field.name), kind_of(field), member});
    });
    return fields;
  }

  void put(const std::vector<SurfaceField>& fields, std::size_t c, SolidRunState& state) const {
    std::size_t next = 0;
    if (site_ == contact::Site::secondary) {
      for (int d = 0; d < 3; ++d, ++next)
        for (std::size_t j = 0; j < fields[next].values.size(); ++j)
          state.solution.traction[c][j][d] = fields[next].values[j];
      const auto &status = fields[next++].values, &slid = fields[next++].values;
      for (std::size_t j = 0; j < status.size(); ++j) {
        state.solution.status[c][j] = static_cast<contact::SkinStatus>(static_cast<char>(status[j]));
        if (state.solution.status[c][j] == contact::SkinStatus::open) state.solution.traction[c][j].setZero();
      }
      state.slid[c].assign(slid.begin(), slid.end());
    }
    contact::for_each_field(state.solution.wear[c], [&](const contact::Field& field, auto& member) {
      if constexpr (!std::is_arithmetic_v<std::remove_cvref_t<decltype(member)>>)
        if (is_carried(field)) member = fields[next++].values;
    });
  }

 private:
  bool is_carried(const contact::Field& field) const {
    return field.site == site_ && field.on_fresh_mesh != contact::OnFreshMesh::derived;
  }
  static SurfaceKind kind_of(const contact::Field& field) {
    return field.on_fresh_mesh == contact::OnFreshMesh::summed ? SurfaceKind::summed : SurfaceKind::interpolated;
  }
  contact::Site site_;
};

/// The state on the new equations: values of sides that lie on no fresh mesh stay with their nodes, the others are
/// carried from the old faces, as worn.
void carry_onto(const solver::SolidSystem& system, const std::vector<Sides>& before, const std::vector<char>& fresh,
                const SolidRunState& old, SolidRunState& state) {
  auto points = old.points;
  for (auto& contact : points)
    for (auto* side : {&contact.secondary, &contact.primary})
      for (auto& [body, node] : *side)
        if (fresh[static_cast<std::size_t>(body)]) node = -1;  // of no mesh
  state.solution = carried(points, system, old.solution);
  state.points = points_of(system);
  for (std::size_t c = 0; c < before.size(); ++c) {
    const auto& setup = system.contacts[c];
    state.slid[c].assign(setup.secondary.points.size(), 0);
    const auto move = [&](contact::Site site, const contact::SkinSide& from, const contact::SkinSide& to) {
      if (!lies_on_any(from, fresh)) return;
      const SideFields fields(site);
      fields.put(adapt::carry(from.skin, fields.of(old, c), to.skin).fields, c, state);
    };
    move(contact::Site::secondary, before[c].secondary, setup.secondary);
    move(contact::Site::primary, before[c].primary, setup.primary);
  }
  state.block_wear = state.solution.wear;
}

SolidRemeshRecord record_of(const SolidProblem& problem, std::size_t b, const MovedSolids& old,
                            const mesh::SolidMesh& born, const adapt::SolidRemeshResult& made) {
  SolidRemeshRecord r;
  r.body = problem.inputs[b].name;
  r.reason = old.reasons[b];
  r.nodes_before = old.meshes[b]->node_count();
  r.nodes_after = made.mesh->node_count();
  r.quality_before = adapt::worn_cells(*old.meshes[b], born, 0.0).least;
  r.quality_after = made.quality;
  r.fresh_facets = made.fresh_facets;
  r.volume_residue_mm3 = made.volume_residue;
  r.correction_mm = made.correction_mm;
  return r;
}

/// What a fresh mesh cost a contact.
struct ContactChange {
  double pressure = 0.0, fit_mm = 0.0;  ///< as in SolidRemeshRecord
};

std::vector<ContactChange> changes_of(const std::vector<Points3>& carried, const SolidRunState& state) {
  std::vector<ContactChange> changes(carried.size());
  for (std::size_t c = 0; c < carried.size(); ++c) {
    changes[c].pressure = pressure_change(*state.solved, carried[c], c);
    for (const double by : state.solution.wear[c].fit) changes[c].fit_mm = std::max(changes[c].fit_mm, std::abs(by));
  }
  return changes;
}

bool touches(const contact::SkinSide& side, std::size_t b) {
  return std::any_of(side.points.begin(), side.points.end(),
                     [&](const auto& point) { return static_cast<std::size_t>(point.body) == b; });
}

/// Enters in the record of a body the worst of its contacts.
void enter(const std::vector<ContactChange>& changes, const solver::SolidSystem& system, std::size_t b,
           SolidRemeshRecord& record) {
  for (std::size_t c = 0; c < changes.size(); ++c) {
    if (!touches(system.contacts[c].secondary, b) && !touches(system.contacts[c].primary, b)) continue;
    record.pressure_change = std::max(record.pressure_change, changes[c].pressure);
    record.fit_mm = std::max(record.fit_mm, changes[c].fit_mm);
  }
}

void tell_changes(const SolidProblem& problem, const std::vector<ContactChange>& changes, const SolidObserver& observer,
                  SolidRunState& state) {
  constexpr double much = 0.05;
  for (std::size_t c = 0; c < changes.size(); ++c) {
    const std::string& name = problem.contacts[c].options.name;
    const auto& [change, fit] = changes[c];
    if (observer.log)
      observer.log(
          base::formatted("contact %s on the fresh mesh: pressures differ by %.2g %% of their mean, gaps are "
                          "fitted by up to %.2g mm",
                          name.c_str(), 100.0 * change, fit));
    if (change > much)
      warn(state.warnings, {"remesh", "contact " + name,
                            base::formatted("At cycle %.9g a fresh mesh changed the pressures by %.2g %% of their "
                                            "mean. A smaller size_mm in its fine zone changes them less.",
                                            state.cycle, 100.0 * change),
                            change / much});
  }
}

}  // namespace

std::string redraw_bodies(const SolidProblem& problem, SolidPlayer& player, MovedSolids moved, const scene::Step& step,
                          const SolidObserver& observer, SolidRunState& state) {
  const auto before = sides_on(problem, moved.meshes, player.assembly().columns);
  const SolidRunState old = state;
  std::vector<char> fresh(moved.meshes.size(), 0);
  std::vector<std::pair<std::size_t, SolidRemeshRecord>> records;  // with their bodies
  for (std::size_t b = 0; b < moved.meshes.size(); ++b) {
    if (moved.reasons[b].empty()) continue;
    auto result = adapt::remesh_solid(*moved.meshes[b], *state.born[b], remesh_options(problem, b));
    if (!result.failure.empty())
      return "body " + problem.inputs[b].name + " cannot be remeshed: " + result.failure + " (" + moved.reasons[b] +
             ")";
    records.emplace_back(b, record_of(problem, b, moved, *state.born[b], result));
    moved.meshes[b] = state.born[b] = result.mesh;
    fresh[b] = 1;
    ++state.counts.remeshes;
  }
  player.redraw(state, moved.meshes, touchable_after(problem, moved.meshes, fresh, before, old.touchable));
  carry_onto(player.system(), before, fresh, old, state);
  const auto carried = state.solution.traction;
  if (auto why = player.settle(state, step); !why.empty()) return why;
  const auto changes = changes_of(carried, state);
  tell_changes(problem, changes, observer, state);
  for (auto& [b, record] : records) {
    record.step = step.name;
    record.cycle = state.cycle;
    enter(changes, player.system(), b, record);
    if (observer.remesh) observer.remesh(record);
  }
  return {};
}

}  // namespace reye::sim
