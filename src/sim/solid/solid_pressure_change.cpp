#include "sim/solid/solid_pressure_change.hpp"

#include <cmath>

namespace reye::sim {

double pressure_change(const solver::SolidSolution& solved, const Points3& before, std::size_t contact) {
  double squares = 0.0, force = 0.0, area = 0.0;
  for (int j = 0; j < solved.place[contact].count(); ++j) {
    const Vec3& normal = solved.place[contact].frame[j].normal;
    const double now = normal.dot(solved.state.traction[contact][j]), then = normal.dot(before[j]);
    if (!(now > 0.0) && !(then > 0.0)) continue;
    const double covered = solved.place[contact].covered[j];
    squares += covered * (now - then) * (now - then);
    force += covered * now;
    area += covered;
  }
  return force > 0.0 ? std::sqrt(squares * area) / force : 0.0;
}

}  // namespace reye::sim
