#include <map>

#include "fem/solid/solid_stress.hpp"
#include "sim/solid/skin_depth.hpp"
#include "sim/solid/solid_measure.hpp"

namespace reye::sim {

namespace {

using contact::SkinStatus;

Points3 body_displacements(const solver::SolidSystem& system, const solver::SolidSolution& solution, std::size_t b) {
  const auto& state = solution.state;
  return system.bodies[b].displacements(
      forces_on(system, solution, b),
      state.s.segment(system.first_driven[b], system.first_driven[b + 1] - system.first_driven[b]),
      state.a.segment(system.first_free[b], system.first_free[b + 1] - system.first_free[b]));
}

SolidFrameBody frame_body(const SolidAssembly& assembly, const solver::SolidSolution& solution, std::size_t b) {
  const auto& input = assembly.system.bodies[b].input();
  SolidFrameBody body{input.name, input.mesh, body_displacements(assembly.system, solution, b), {}};
  if (!input.rigid) body.stress_MPa = fem::nodal_stress(*input.mesh, input.material, body.u);
  return body;
}

SkinRecord empty_record(const contact::SkinSetup& setup, const contact::SkinWear& wear, Side side) {
  const auto& own = side == Side::secondary ? setup.secondary : setup.primary;
  SkinRecord record;
  record.contact = setup.options.name;
  record.side = side;
  record.facets = own.skin.facets;
  const std::size_t count = own.points.size();
  for (const auto& point : own.points) {
    record.body.push_back(point.body);
    record.node.push_back(point.node);
  }
  record.x_mm = own.skin.x;
  record.shear_MPa.assign(count, Vec3::Zero());
  record.slip_mm.assign(count, Vec3::Zero());
  record.normal.assign(count, Vec3::Zero());
  record.pressure_MPa.assign(count, 0.0);
  record.area_mm2.assign(count, 0.0);
  record.status.assign(count, 0);
  record.wear_depth_mm = worn_depths(setup, wear, side);
  return record;
}

SkinRecord secondary_record(const solver::SolidSystem& system, const solver::SolidSolution& solution,
                            const contact::SkinWear& wear, std::size_t c) {
  const auto& setup = system.contacts[c];
  SkinRecord record = empty_record(setup, wear, Side::secondary);
  for (int j = 0; j < setup.count(); ++j) {
    const auto& node = solution.nodes[c][j];
    const auto& frame = solution.place[c].frame[j];
    const SkinStatus status = solution.state.status[c][j];
    record.normal[j] = frame.normal;
    record.area_mm2[j] = solution.place[c].covered[j];
    if (status == SkinStatus::open) continue;
    record.pressure_MPa[j] = node.traction.dot(frame.normal);
    record.shear_MPa[j] = frame.across(node.traction);
    record.slip_mm[j] = node.slip;
    record.status[j] = status == SkinStatus::stick && setup.options.friction > 0.0 ? 1 : 2;
  }
  return record;
}

/// The primary side repeats what the secondary points exert on it, averaged with the integrals M as weights.
SkinRecord primary_record(const solver::SolidSystem& system, const solver::SolidSolution& solution, std::size_t c,
                          const contact::SkinWear& wear, const SkinRecord& secondary) {
  const auto& setup = system.contacts[c];
  SkinRecord record = empty_record(setup, wear, Side::primary);
  std::map<int, int> place_of_column;
  for (std::size_t l = 0; l < setup.primary.points.size(); ++l)
    place_of_column[setup.primary.points[l].column] = static_cast<int>(l);
  std::vector<double> most(setup.primary.points.size(), 0.0);
  for (int j = 0; j < setup.count(); ++j)
    for (contact::SkinRows::InnerIterator it(solution.place[c].Q, j); it; ++it) {
      const auto found = place_of_column.find(static_cast<int>(it.col()));
      if (found == place_of_column.end()) continue;
      const int l = found->second;
      const double share = -it.value();
      record.area_mm2[l] += share;
      record.pressure_MPa[l] += share * secondary.pressure_MPa[j];
      record.shear_MPa[l] -= share * secondary.shear_MPa[j];
      record.slip_mm[l] -= share * secondary.slip_mm[j];
      record.normal[l] -= share * secondary.normal[j];
      if (share > most[l]) {
        most[l] = share;
        record.status[l] = secondary.status[j];
      }
    }
  for (std::size_t l = 0; l < most.size(); ++l) {
    if (!(record.area_mm2[l] > 0.0)) continue;
    record.pressure_MPa[l] /= record.area_mm2[l];
    record.shear_MPa[l] /= record.area_mm2[l];
    record.slip_mm[l] /= record.area_mm2[l];
    record.normal[l].normalize();
  }
  return record;
}

}  // namespace

SolidFrame solid_frame(const SolidProblem& problem, const SolidAssembly& assembly, const SolidRunState& state,
                       const std::string& step, const FrameMoment& moment) {
  const auto& solution = *state.solved;
  SolidFrame frame{moment.cycle, moment.progress, step, {}, {}};
  if (moment.bodies)
    for (int b = 0; b < problem.body_count(); ++b)
      frame.bodies.push_back(frame_body(assembly, solution, static_cast<std::size_t>(b)));
  for (std::size_t c = 0; c < assembly.system.contacts.size(); ++c) {
    const auto& wear = state.solution.wear[c];
    frame.surfaces.push_back(secondary_record(assembly.system, solution, wear, c));
    frame.surfaces.push_back(primary_record(assembly.system, solution, c, wear, frame.surfaces.back()));
  }
  return frame;
}

}  // namespace reye::sim
