#include "sim/solid/solid_measure.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/solid/skin_depth.hpp"

namespace reye::sim {

namespace {

using contact::SkinStatus;

bool closed(const solver::SolidSolution& solution, std::size_t c, int j) {
  return solution.state.status[c][j] != SkinStatus::open;
}

/// Points without friction slide freely.
int status_number(SkinStatus status, double friction) {
  if (status == SkinStatus::open) return 0;
  return status == SkinStatus::stick && friction > 0.0 ? 1 : 2;
}

/// Resultants of all supports of a body, in space.
base::Vector resultants_of(const solver::SolidSystem& system, const solver::SolidSolution& solution, std::size_t b) {
  const auto& body = system.bodies[b];
  const base::Vector force = forces_on(system, solution, b), s = system.of_driven(solution.state.s, b);
  const auto& turning = system.turning[b];
  if (!turning) return body.F() * force + body.G() * s;
  const auto pose = solver::poses_of(system, solution.state)[b];
  return body::to_space(pose,
                        body.F() * body::to_frame(pose, force) + body.G() * body::frame_values(*turning, pose, s));
}

/// Forces of the loads on a body, in space.
Points3 load_forces(const SolidProblem& problem, const solver::SolidSystem& system,
                    const solver::SolidSolution& solution, std::size_t b) {
  const base::Vector s = system.of_driven(solution.state.s, b);
  if (const auto& turning = system.turning[b])
    return {body::load_wrench(*turning, solver::poses_of(system, solution.state)[b], s).head<3>()};
  Points3 forces;
  const auto& driven = system.bodies[b].driven();
  for (std::size_t k = 0; k < driven.size(); ++k)
    if (driven[k].load >= 0) forces.push_back(s[static_cast<int>(k)] * problem.load_force[b][driven[k].load]);
  return forces;
}

}  // namespace

SkinContactRow contact_row(const solver::SolidSystem& system, const SolidRunState& state, std::size_t c) {
  const auto& solution = *state.solved;
  SkinContactRow row;
  const auto& setup = system.contacts[c];
  const auto& place = solution.place[c];
  Vec3 shear = Vec3::Zero();
  for (int j = 0; j < place.count(); ++j) {
    if (!closed(solution, c, j)) continue;
    const auto& frame = place.frame[j];
    const Vec3& z = solution.nodes[c][j].traction;
    const double p = z.dot(frame.normal), area = place.covered[j];
    row.pressure_max_MPa = std::max(row.pressure_max_MPa, p);
    row.area_mm2 += area;
    if (status_number(solution.state.status[c][j], setup.options.friction) == 1) row.stick_area_mm2 += area;
    row.force_N -= area * z;
    row.normal_force_N += area * p;
    shear += area * frame.across(z);
  }
  row.tangential_force_N = shear.norm();
  row.energy_mJ = energy_of(state, c);
  if (!setup.options.wear.wears()) return row;
  row.depth_secondary_mm = deepest_of(setup.secondary, state.solution.wear[c].removed_secondary);
  row.depth_primary_mm = deepest_of(setup.primary, state.solution.wear[c].removed_primary);
  return row;
}

base::Vector forces_on(const solver::SolidSystem& system, const solver::SolidSolution& solution, std::size_t body) {
  base::Vector force = base::Vector::Zero(3 * system.points());
  for (std::size_t c = 0; c < solution.place.size(); ++c)
    solver::add_contact_forces(solution.place[c], solution.state.traction[c], force);
  const int begin = system.first_point[body], end = system.first_point[body + 1];
  return force.segment(3 * begin, 3 * (end - begin));
}

std::vector<SupportRow> support_rows(const SolidProblem& problem, const solver::SolidSystem& system,
                                     const solver::SolidSolution& solution) {
  std::vector<base::Vector> resultants;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) resultants.push_back(resultants_of(system, solution, b));
  std::vector<SupportRow> rows;
  for (const auto& [body, place] : problem.support_of)
    rows.push_back({resultants[body].segment<3>(6 * place), resultants[body].segment<3>(6 * place + 3)});
  return rows;
}

double imbalance_of_bodies(const SolidProblem& problem, const solver::SolidSystem& system,
                           const solver::SolidSolution& solution) {
  double worst = 0.0;
  const auto supports = support_rows(problem, system, solution);
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const auto forces = forces_on(system, solution, b);
    Vec3 sum = Vec3::Zero();
    double largest = 0.0;
    const auto add = [&](const Vec3& force) {
      sum += force;
      largest = std::max(largest, force.norm());
    };
    Vec3 contact = Vec3::Zero();
    for (Eigen::Index i = 0; i < forces.size(); i += 3) contact += forces.segment<3>(i);
    add(contact);
    for (std::size_t k = 0; k < supports.size(); ++k)
      if (problem.support_of[k][0] == static_cast<int>(b)) add(supports[k].force_N);
    for (const Vec3& force : load_forces(problem, system, solution, b)) add(force);
    if (largest > 0.0) worst = std::max(worst, sum.norm() / largest);
  }
  return worst;
}

}  // namespace reye::sim
