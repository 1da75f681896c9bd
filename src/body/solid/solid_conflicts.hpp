#pragma once
#include <vector>

#include "body/conflicts.hpp"
#include "body/solid/solid_input.hpp"

namespace reye::body {

/// Supports of one solid that contradict each other in one place, as `support_conflicts` finds them in the plane: a
/// node on two rigid faces; a support by node against a rigid face; a direction of a node held twice with different
/// values; a motion that the kind of support does not have. Of a rigid body: a motion driven twice. Equal values are no
/// conflict. One conflict per pair of supports; `motion`: "x", "rotation_x", "normal" ..., or empty. Throws
/// base::InputError where a face does not exist.
std::vector<SupportConflict> solid_support_conflicts(const SolidInput& input);

}  // namespace reye::body
