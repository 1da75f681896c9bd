#pragma once
#include <vector>

#include "body/solid/point_compliance.hpp"
#include "body/solid/rigid_modes.hpp"
#include "body/solid/solid_columns.hpp"

/// The two kinds of solids behind `SolidBody`.
namespace reye::body {

/// u = C f + U s + A a,  A^T f + B s = 0,  r = F f + G s
struct SolidMatrices {
  std::vector<Driven> driven;
  PointCompliance C;
  Matrix U, A, B, F, G;
  Vec3 centre = Vec3::Zero();        ///< of the modes
  Modes modes;                       ///< the free ones
  std::vector<Mode> load_resultant;  ///< per load at factor 1, about `centre`
};

/// Imposed motions and loads of supports, then loads.
std::vector<Driven> driven_of(const SolidInput& input);

/// The entry of `driven` of a support's motion, or -1.
int driven_motion(const std::vector<Driven>& driven, int support, int motion);

/// Nodal forces of a load, 3 per node. The mesh has cells where the load is one per volume.
Vector nodal_forces(const mesh::SolidMesh& mesh, const SolidLoad& load);

/// Force, and moment about c, of a load at factor 1.
Mode resultant_of(const SolidInput& input, const SolidLoad& load, const Vec3& c);

/// A rigid body: its motion in six numbers z about `centre`, z = of_f f + of_s s + modes a.
struct RigidMotion {
  Matrix of_f, of_s;
};
RigidMotion condense_rigid(const SolidInput& input, const std::vector<SolidPlace>& places,
                           const std::vector<int>& retained, SolidMatrices& out);

}  // namespace reye::body
