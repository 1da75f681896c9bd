#pragma once
#include <string>

#include "body/shape.hpp"

namespace reye::adapt {

/// The curves a worn outline is made of, or why there are none.
struct Redrawn {
  cad::Drawing drawing;
  std::string failure;  ///< empty; else what of the outline cannot be drawn, and where
};

/// Redraws the outline of a worn shape: curves of CAD where nothing has moved, straight lines between their present
/// ends where a side has only become shorter, and one C1 spline through the nodes of each worn run, ending where the
/// scar ends, where a name changes and at corners.   (README, 7)
/// Nothing moved: the drawing of the shape, unchanged. A shape without drawing is drawn from its outline of birth.
/// `fit_tolerance_mm`: a worn run whose estimated error of the spline is larger is drawn as the polyline of its nodes;
/// 0 stands for a twentieth of the mean facet of the run.
/// Fails when a named boundary or a side of the body has vanished, or the drawing is not that of the mesh.
Redrawn redraw(const body::Shape& shape, double fit_tolerance_mm = 0.0);

}  // namespace reye::adapt
