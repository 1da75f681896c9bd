#pragma once
#include <vector>

#include "sim/reshape/equilibrate.hpp"

/// Moves of worn nodes that close the gaps of a shape under held tractions.
namespace reye::sim {

/// One side of a contact: the losses of its nodes, the tractions, and the outward moves of the nodes.
struct SideShift {
  std::vector<double> room;  ///< largest move of a node: the depth that it, or a node beside it, has lost
  std::vector<char> loaded;
  std::vector<double> by, free;
};

bool any_moved(const std::vector<double>& moves);

/// The gaps of a contact under held tractions, and the moves that close them.
struct Closing {
  SideShift secondary, primary;
  double left_mm = 0.0;   ///< largest gap under a pressure that stays
  double moved_mm = 0.0;  ///< farthest move
};

/// Moves of the worn nodes of a contact, in its state `contact`, that close the gaps at the positions `at`, where the
/// tractions `held` are in equilibrium.   (README, 5)
Closing closing_of(const contact::Setup& setup, const contact::ContactState& contact, const solver::Sides& at,
                   const HeldTraction& held);

}  // namespace reye::sim
