#pragma once
#include <array>
#include <optional>
#include <string>

#include "base/linalg.hpp"

namespace reye::fem {

/// A traction on a boundary, integrated over the facets it covers (cut facets included).
struct BoundaryLoad {
  std::string name;
  std::string edge;                                  ///< boundary name
  double pressure_MPa = 0.0;                         ///< > 0 pushes on the body
  base::Vec2 traction_MPa{0.0, 0.0};                 ///< in x, y; adds to the pressure
  std::optional<std::array<double, 2>> interval_mm;  ///< arc length, from the origin of mesh::arc_chains
  std::string history;                               ///< empty: full from the start
};

/// A force at the node nearest to a point.
struct PointLoad {
  std::string name;
  std::string body;  ///< empty: the body whose node is nearest
  base::Vec2 point_mm{0.0, 0.0};
  base::Vec2 force_N_per_mm{0.0, 0.0};  ///< axisymmetric: N on the whole ring
  std::string history;
};

/// A force per volume on a whole body [N/mm^3].
struct BodyForce {
  std::string name;
  std::string body;
  base::Vec2 force_N_per_mm3{0.0, 0.0};
  std::string history;
};

}  // namespace reye::fem
