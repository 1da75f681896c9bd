#pragma once
#include <vector>

#include "solver/solid/increment_state.hpp"

namespace reye::solver {

/// The gaps of a contact where all of its facets were integrated.
struct WholeIntegrals {
  Vector u;                 ///< of the points of the system then [mm]
  std::vector<double> gap;  ///< per secondary point [mm]
};

/// Marks the secondary facets whose integrals have to follow the points to `u`. The others stay open wherever their
/// points went: their gaps were larger than `much` times what both sides have moved since. For open points integrals
/// decide only that they are open, so that those of before serve as well: an increment that presses on a small part of
/// its patch integrates that part. Facets with a bare point follow, too: what covers a sliver may leave it.
std::vector<char> near_facets(const contact::SkinSetup& setup, const contact::SkinPlace& place,
                              const std::vector<contact::SkinStatus>& status, const WholeIntegrals& whole,
                              const Vector& u);

}  // namespace reye::solver
