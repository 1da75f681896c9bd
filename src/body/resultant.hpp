#pragma once
#include <Eigen/Core>

#include "base/analysis.hpp"
#include "fem/loads.hpp"
#include "mesh/mesh.hpp"

namespace reye::body {

/// The resultant of a load on a rigid body: force = sum f_i and spread = sum f_i (X_i - c)^T. The work on the velocity
/// of a rotation R(theta) about c is the entrywise product R' : spread.
struct Resultant {
  base::Vec2 force{0.0, 0.0};
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();

  double moment() const { return spread(1, 0) - spread(0, 1); }  ///< about c, unrotated
};

Resultant resultant(const mesh::Mesh& mesh, base::Analysis analysis, const fem::BoundaryLoad& load,
                    const base::Vec2& centre);
Resultant resultant(const mesh::Mesh& mesh, base::Analysis analysis, const fem::PointLoad& load,
                    const base::Vec2& centre);
/// From the outline when the mesh has no cells (in axisymmetry the force alone).
Resultant resultant(const mesh::Mesh& mesh, base::Analysis analysis, const fem::BodyForce& load,
                    const base::Vec2& centre);

/// Centre of the bounding box of a mesh.
base::Vec2 box_centre(const mesh::Mesh& mesh);

}  // namespace reye::body
