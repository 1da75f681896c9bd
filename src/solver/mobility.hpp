#pragma once
#include "solver/system.hpp"

namespace reye::solver {

/// What the supports leave of the motions of a contact's nodes in one increment from q; without entries where they hold
/// no secondary node along one direction only. Its turn is that of rigid bodies and of linear ones that turn, where the
/// angle is prescribed, between sides that are one body each.
contact::Mobility mobility(const System& system, const contact::Setup& setup, const Vector& q,
                           const Controls& controls);

}  // namespace reye::solver
