#pragma once
#include <string>
#include <vector>

#include "base/linalg.hpp"

/// Frames read back as drawings.
namespace reye::output {

/// An edge of an element, or of a rigid body's outline: corner, mid node (-1: none), corner.
struct DrawnEdge {
  int from = 0, mid = -1, to = 0;
  int body = 0;
  bool outline = false;  ///< of one element only
};

struct DrawnFrame {
  double cycle = 0.0;
  base::Points x;  ///< deformed [mm]
  std::vector<DrawnEdge> edges;
};

/// Points of all contact surfaces.
struct DrawnSurfaces {
  base::Points x;  ///< deformed [mm]
  std::vector<double> pressure_MPa, wear_depth_mm;
};

/// Reads a .vtu that `bodies_vtu` made; throws std::runtime_error when it cannot.
DrawnFrame read_drawn(const std::string& path);

/// Likewise a .vtp that `surfaces_vtp` made.
DrawnSurfaces read_drawn_surfaces(const std::string& path);

}  // namespace reye::output
