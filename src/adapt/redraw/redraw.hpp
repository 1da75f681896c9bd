#pragma once
#include <string>

#include "body/shape.hpp"

namespace reye::adapt {

/// The curves of a worn outline, or why it cannot be drawn.
struct Redrawn {
  cad::Drawing drawing;
  std::string failure;  ///< empty; else the part of the outline that cannot be drawn, and where
};

/// Redraws the outline of a worn shape: curves of CAD where nothing has moved, straight lines between their present
/// ends where a side has only become shorter, and one C1 spline through the nodes of each worn run, ending where the
/// scar ends, where a name changes and at corners.   (README, 7)
/// If nothing has moved, the drawing of the shape is returned unchanged. A shape without a drawing is drawn from its
/// outline at birth. `fit_tolerance_mm`: a worn run whose estimated error of the spline is larger is drawn as the
/// polyline of its nodes; 0 stands for a twentieth of the mean facet of the run. Fails when a named boundary or a side
/// of the body has vanished, or the drawing is not that of the mesh.
Redrawn redraw(const body::Shape& shape, double fit_tolerance_mm = 0.0);

}  // namespace reye::adapt
