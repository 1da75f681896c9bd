#include "sim/solid/solid_measure.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesh/solid/solid_measure.hpp"

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

/// What acts on a body, in its frame and on X where it turns, else in space.
struct Acting {
  base::Vector forces;    ///< of contacts on its points
  base::Vector supports;  ///< resultants, each about its centre
  body::Mode loads;       ///< their resultant
  Vec3 loads_about;
};

body::SolidPose pose_of(const solver::SolidSystem& system, const solver::SolidSolution& solution, std::size_t b) {
  return system.turning[b] ? solver::poses_of(system, solution.state)[b] : body::SolidPose{};
}

Acting acting_on(const solver::SolidSystem& system, const solver::SolidSolution& solution, std::size_t b) {
  const auto& body = system.bodies[b];
  Acting all{forces_on(system, solution, b), {}, body::Mode::Zero(), body.centre()};
  base::Vector s = system.of_driven(solution.state.s, b);
  if (const auto& turning = system.turning[b]) {
    const auto pose = pose_of(system, solution, b);
    all.forces = body::to_frame(pose, all.forces);
    s = body::frame_values(*turning, pose, s);
    all.loads = turning->resultants * s;
    all.loads_about = turning->pivot.centre;
  } else {
    for (std::size_t k = 0; k < body.driven().size(); ++k)
      if (const int load = body.driven()[k].load; load >= 0)
        all.loads += s[static_cast<int>(k)] * body.load_resultant()[static_cast<std::size_t>(load)];
  }
  all.supports = body.F() * all.forces + body.G() * s;
  return all;
}

/// The places of all points, on X; of points that no contact has, zero: no force acts there.
Points3 places(const solver::SolidSystem& system) {
  Points3 x(static_cast<std::size_t>(system.points()), Vec3::Zero());
  for (const auto& contact : system.contacts)
    for (const auto* side : {&contact.secondary, &contact.primary})
      for (std::size_t i = 0; i < side->points.size(); ++i) x[side->points[i].column] = side->skin.x[i];
  return x;
}

/// What acts on a body: forces, and moments about its centre.
class Balance {
 public:
  Balance(const Vec3& centre, double size) : centre_(centre), size_(size) {}

  body::Mode about_centre(const Vec3& force, const Vec3& moment, const Vec3& at) const {
    body::Mode resultant;
    resultant << force, moment + (at - centre_).cross(force);
    return resultant;
  }
  void add(const body::Mode& resultant) {
    sum_ += resultant;
    largest_ = std::max({largest_, resultant.head<3>().norm(), resultant.tail<3>().norm() / size_});
  }
  double left_N() const { return std::max(sum_.head<3>().norm(), sum_.tail<3>().norm() / size_); }
  double largest_N() const { return largest_; }

 private:
  Vec3 centre_;
  double size_, largest_ = 0.0;
  body::Mode sum_ = body::Mode::Zero();
};

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
  row.depth_secondary_mm = deepest_worn(setup, state.solution.wear[c], Side::secondary);
  row.depth_primary_mm = deepest_worn(setup, state.solution.wear[c], Side::primary);
  const auto sum = [](const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); };
  row.volume_secondary_mm3 = sum(state.solution.wear[c].removed_secondary);
  row.volume_primary_mm3 = sum(state.solution.wear[c].removed_primary);
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
  std::vector<base::Vector> resultants;  // in space
  for (std::size_t b = 0; b < system.bodies.size(); ++b)
    resultants.push_back(body::to_space(pose_of(system, solution, b), acting_on(system, solution, b).supports));
  std::vector<SupportRow> rows;
  for (const auto& [body, place] : problem.support_of)
    rows.push_back({resultants[body].segment<3>(6 * place), resultants[body].segment<3>(6 * place + 3)});
  return rows;
}

BalanceOfBodies balance_of_bodies(const SolidProblem& problem, const solver::SolidSystem& system,
                                  const solver::SolidSolution& solution) {
  BalanceOfBodies all;
  const Points3 x = places(system);
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const auto& body = system.bodies[b];
    Balance balance(body.centre(), mesh::box_diagonal(body.input().mesh->X));
    body::Mode contact = body::Mode::Zero();
    const auto acting = acting_on(system, solution, b);
    for (Eigen::Index i = 0; i < acting.forces.size(); i += 3)
      contact += balance.about_centre(acting.forces.segment<3>(i), Vec3::Zero(), x[system.first_point[b] + i / 3]);
    balance.add(contact);
    for (const auto& [of_body, place] : problem.support_of) {
      if (of_body != static_cast<int>(b)) continue;
      const auto wrench = acting.supports.segment<6>(6 * static_cast<Eigen::Index>(place));
      balance.add(balance.about_centre(wrench.head<3>(), wrench.tail<3>(), body.support_centre(place)));
    }
    balance.add(balance.about_centre(acting.loads.head<3>(), acting.loads.tail<3>(), acting.loads_about));
    all.left_N = std::max(all.left_N, balance.left_N());
    all.largest_N = std::max(all.largest_N, balance.largest_N());
  }
  return all;
}

}  // namespace reye::sim
