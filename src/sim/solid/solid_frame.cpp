#include <map>

#include "fem/solid/solid_stress.hpp"
#include "sim/solid/skin_depth.hpp"
#include "sim/solid/solid_measure.hpp"

namespace reye::sim {

namespace {

using contact::SkinStatus;

/// Stress 11, 22, 33, 12, 23, 31 of a body that turns, along the axes of space.
std::array<double, 6> turned_stress(const base::Mat3& R, const std::array<double, 6>& s) {
  const base::Mat3 own{{s[0], s[3], s[5]}, {s[3], s[1], s[4]}, {s[5], s[4], s[2]}};
  const base::Mat3 turned = R * own * R.transpose();
  return {turned(0, 0), turned(1, 1), turned(2, 2), turned(0, 1), turned(1, 2), turned(2, 0)};
}

/// Displacements of a body in its present shape, which its equations need not be of.
Points3 displacements_of(const body::SolidBody& body, const std::shared_ptr<const mesh::SolidMesh>& shape,
                         const base::Vector& force, const base::Vector& s, const base::Vector& a) {
  return shape == body.input().mesh ? body.displacements(force, s, a) : body.displacements_in(shape, force, s, a);
}

SolidFrameBody frame_body(const SolidAssembly& assembly, const SolidRunState& state, std::size_t b) {
  const auto& system = assembly.system;
  const auto& solution = *state.solved;
  const auto& shape = state.meshes[b];
  const auto& input = system.bodies[b].input();
  const auto& turning = system.turning[b];
  const body::SolidPose pose = solver::poses_of(system, solution.state)[b];
  const base::Vector force = forces_on(system, solution, b), s = system.of_driven(solution.state.s, b);
  const Eigen::Index modes = system.bodies[b].A().cols();
  SolidFrameBody body{input.name, shape, {}, {}};
  body.u = turning ? displacements_of(system.bodies[b], shape, body::to_frame(pose, force),
                                      body::frame_values(*turning, pose, s), base::Vector::Zero(modes))
                   : displacements_of(system.bodies[b], shape, force, s, system.of_free(solution.state.a, b));
  if (!input.rigid) body.stress_MPa = fem::nodal_stress(*shape, input.material, body.u);
  if (!turning) return body;
  for (std::size_t n = 0; n < body.u.size(); ++n) body.u[n] = pose.place(shape->X[n], body.u[n]) - shape->X[n];
  for (auto& stress : body.stress_MPa) stress = turned_stress(pose.R, stress);
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

/// How the body of each row has turned.
void add_turns(const solver::SolidSystem& system, const solver::SolidSolution& solution, SkinRecord& record) {
  if (!system.turns()) return;
  Points3 turns;
  for (const auto& pose : solver::poses_of(system, solution.state))
    turns.push_back(base::rotation_vector(base::Turn(pose.R)));
  for (const int body : record.body) record.turn_rad.push_back(turns[body]);
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
      frame.bodies.push_back(frame_body(assembly, state, static_cast<std::size_t>(b)));
  for (std::size_t c = 0; c < assembly.system.contacts.size(); ++c) {
    const auto& wear = state.solution.wear[c];
    frame.surfaces.push_back(secondary_record(assembly.system, solution, wear, c));
    frame.surfaces.push_back(primary_record(assembly.system, solution, c, wear, frame.surfaces.back()));
    for (auto* record : {&frame.surfaces.back() - 1, &frame.surfaces.back()})
      add_turns(assembly.system, solution, *record);
  }
  return frame;
}

}  // namespace reye::sim
