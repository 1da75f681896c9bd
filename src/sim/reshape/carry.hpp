#pragma once
#include <vector>

#include "sim/problem/problem.hpp"
#include "sim/reshape/equilibrate.hpp"

namespace reye::sim {

/// The nodes and facets of a boundary on given shapes.
mortar::Surface surface_of(const contact::BoundaryRef& ref, base::Analysis analysis,
                           const std::vector<body::ShapePtr>& shapes);

/// Carries the fields of a contact's surfaces from the nodes of the old meshes to those of the fresh ones, boundary by
/// boundary. Removed volumes, frictional work and held forces keep their sums, slip and normals are interpolated, the
/// status is that of the nearest node; lambda follows from the forces. The slip reference starts empty: the next
/// equilibrium gives it. `from`: shapes whose nodes the state counts; `to`: the shapes with some bodies remeshed.
void carry_contact(const PlacedContact& placed, base::Analysis analysis, const std::vector<body::ShapePtr>& from,
                   const std::vector<body::ShapePtr>& to, contact::ContactState& state, HeldTraction& held);

}  // namespace reye::sim
