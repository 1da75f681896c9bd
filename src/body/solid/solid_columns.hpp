#pragma once
#include <vector>

#include "body/solid/solid_place.hpp"
#include "fem/solid/solid_dofs.hpp"

/// The independent dofs of a supported solid: y = [own dofs of other nodes; own dofs of retained nodes; active motions;
/// prescribed motions].
namespace reye::body {

/// A motion that nodes share. Of a rigid face one of its six, along and about the support's axes; of a support by node
/// an imposed motion, or a probe: the rigid motion along or about x, y, z of what it holds, always zero, whose force is
/// the support's resultant.
struct SharedMotion {
  int support = -1, motion = 0;
  bool probe = false;
};

struct SolidColumns {
  fem::SolidDofs dofs;
  int interior = 0;                      ///< own dofs of nodes that are not retained
  std::vector<SharedMotion> active;      ///< free or loaded motions of rigid faces
  std::vector<SharedMotion> prescribed;  ///< fixed, imposed, probes
  Points3 points;                        ///< where the point of each node lies: nodes, or Bernstein control points

  int unknown() const { return dofs.own - interior + static_cast<int>(active.size()); }
};

/// Supports are to be free of conflicts.
SolidColumns number_columns(const SolidInput& input, const std::vector<SolidPlace>& places,
                            const std::vector<int>& retained);

}  // namespace reye::body
