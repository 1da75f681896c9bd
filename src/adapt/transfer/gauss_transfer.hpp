#pragma once
#include <vector>

#include "base/analysis.hpp"
#include "material/elastic_part.hpp"
#include "mesh/mesh.hpp"

/// State of Gauss points (fem::stiffness_rule, cell by cell) carried from the mesh of a body to another of the same
/// body.
namespace reye::adapt {

/// Method of transfer. h: cell size; front: a jump of the field.
///   nearest  value of the nearest old Gauss point: first order, nothing is averaged or created, fronts stay sharp
///   patch    nodal values by patch recovery, interpolated in the old cell: second order, exact for affine fields,
///            smooths at every transfer and keeps no sum
///   l2       L2 projection over the intersected cells between fields that are affine in each cell (constant in tri3):
///   second
///            order (first in tri3), keeps the integral of every component, overshoots beside fronts (by a seventh of a
///            jump)
enum class GaussTransfer { nearest, patch, l2 };

struct GaussOptions {
  GaussTransfer how = GaussTransfer::l2;
  base::Analysis analysis = base::Analysis::plane_strain;  ///< integrals of l2: per thickness or around the axis
};

/// One row per Gauss point, one column per component. Columns listed in `nonnegative` stay so.
base::Matrix transfer_gauss(const mesh::Mesh& from, const base::Matrix& values, const mesh::Mesh& to,
                            const GaussOptions& options, const std::vector<int>& nonnegative = {});

/// The state that stress and yielding depend on, at the Gauss points of another mesh, component by component; p >= 0.
/// The plastic strain is not carried: material::plastic_state gives the one that leaves this with the deformation found
/// there.
std::vector<material::ElasticState> transfer_elastic(const mesh::Mesh& from,
                                                     const std::vector<material::ElasticState>& state,
                                                     const mesh::Mesh& to, const GaussOptions& options);

/// Deformation when the current shape becomes the reference: `from` is the old mesh on the current shape x = X + u,
/// `to` a fresh mesh of that shape; a row of F, and of the F0 it returns, is (F_11, F_12, F_21, F_22, F_33) from the
/// unstressed state, det F > 0. With F = R U, what is carried is ln U, ln F_33 and the rotation as (cos, sin), which is
/// scaled back to length one: det F0 > 0 always, a rigid rotation is exact whatever its angle. From then on F = Grad u
/// F0.
base::Matrix transfer_deformation(const mesh::Mesh& from, const base::Matrix& F, const mesh::Mesh& to,
                                  const GaussOptions& options);

}  // namespace reye::adapt
