#pragma once
#include "solver/system.hpp"

namespace reye::solver {

/// The motions of a contact's nodes in one increment from q as supports restrict them; without entries where no
/// secondary node is held along one direction only. Its turn is that of rigid bodies and of linear ones that turn,
/// where the angle is prescribed, between sides that are one body each.
contact::Mobility mobility(const System& system, const contact::Setup& setup, const Vector& q,
                           const Controls& controls);

}  // namespace reye::solver
