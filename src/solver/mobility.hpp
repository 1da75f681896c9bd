#pragma once
#include "solver/system.hpp"

namespace reye::solver {

/// What the supports leave of the motions of a contact's nodes in one increment; empty where they hold no secondary node
/// along one direction only.
contact::Mobility mobility(const System& system, const contact::Setup& setup, const Vector& q, const Controls& controls);

}  // namespace reye::solver
