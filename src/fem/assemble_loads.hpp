#pragma once
#include "base/analysis.hpp"
#include "fem/loads.hpp"
#include "mesh/mesh.hpp"

/// Load vectors on X, dof = 2 * node + component [N per mm; N on the whole ring in axisymmetry].
namespace reye::fem {

/// int N t ds (times 2 pi r in axisymmetry) over the loaded part of the boundary, facets cut by the interval
/// included; t = traction - pressure * n, n outward. The arc length of `interval_mm` runs along each chain from
/// its end with smaller x (then smaller y; a closed chain from its first node) and is clipped to the chain.
/// Throws base::InputError when the edge is unknown or the interval meets none of it.
base::Vector load_vector(const mesh::Mesh& mesh, base::Analysis analysis, const BoundaryLoad& load);

/// The force at the node nearest to the point.
base::Vector load_vector(const mesh::Mesh& mesh, base::Analysis analysis, const PointLoad& load);

/// int N b dV.
base::Vector load_vector(const mesh::Mesh& mesh, base::Analysis analysis, const BodyForce& load);

}  // namespace reye::fem
