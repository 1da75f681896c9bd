#pragma once
#include <optional>

#include "contact/interface.hpp"
#include "solver/system.hpp"

namespace reye::solver {

/// A node that went through the other side of its contact in one increment, undetected by the mortar integrals.
struct Passage {
  contact::SurfaceNode node;
  Vec2 x{0.0, 0.0};
  double depth = 0.0;  ///< how far behind the other side it lies [mm]
};

/// The first such node of a contact that is integrated on all of its nodes; `before`, `now`: its two sides. Where no
/// node moved farther against the other side than the integrals search, none can have passed and none is checked.
std::optional<Passage> passage(const contact::Interface& face, const Sides& before, const Sides& now);

}  // namespace reye::solver
