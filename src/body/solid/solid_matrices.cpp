#include "body/solid/solid_matrices.hpp"

#include "fem/solid/solid_loads.hpp"
#include "mesh/solid/solid_measure.hpp"

namespace reye::body {

std::vector<Driven> driven_of(const SolidInput& input) {
  std::vector<Driven> driven;
  for (int s = 0; s < static_cast<int>(input.supports.size()); ++s)
    for (int m = 0; m <= normal_motion; ++m) {
      const Motion& motion = motion_of(input.supports[s], m);
      if ((motion.drive == Drive::moved || motion.drive == Drive::loaded) && !motion.parts.empty())
        driven.push_back({s, -1, m, motion.parts});
    }
  for (int l = 0; l < static_cast<int>(input.loads.size()); ++l)
    driven.push_back({-1, l, 0, {base::Part{1.0, input.loads[l].history}}});
  return driven;
}

int driven_motion(const std::vector<Driven>& driven, int support, int motion) {
  for (int k = 0; k < static_cast<int>(driven.size()); ++k)
    if (driven[k].support == support && driven[k].motion == motion) return k;
  return -1;
}

Vector nodal_forces(const mesh::SolidMesh& mesh, const SolidLoad& load) {
  if (load.face.empty()) return fem::body_load(mesh, load.force_N_per_mm3);
  const auto facets = mesh::facets_of(mesh, load.face);
  return fem::face_load(mesh, facets, load.pressure_MPa, load.traction_MPa) +
         fem::face_force(mesh, facets, load.force_N);
}

Mode resultant_of(const SolidInput& input, const SolidLoad& load, const Vec3& c) {
  const auto& mesh = *input.mesh;
  if (input.rigid && load.face.empty())  // its mesh may have no cells
    return modes_at(mesh::volume_centroid(mesh), c).transpose() * Vec3(mesh::volume(mesh) * load.force_N_per_mm3);
  const Vector forces = nodal_forces(mesh, load);
  Mode sum = Mode::Zero();
  for (int k = 0; k < mesh.node_count(); ++k) sum += modes_at(mesh.X[k], c).transpose() * forces.segment<3>(3 * k);
  return sum;
}

}  // namespace reye::body
