#pragma once
#include <string>
#include <vector>

#include "base/analysis.hpp"
#include "body/shape.hpp"

namespace reye::adapt {

struct RemeshOptions {
  double most_nodes = 2e6;
  bool keep_nodes = false;        ///< the outline keeps its nodes where good cells can be made on them
  double fit_tolerance_mm = 0.0;  ///< of the spline through a worn run; 0: a twentieth of its mean facet
};

struct RemeshResult {
  body::ShapePtr shape;                ///< null when it failed
  double area_residue = 0.0;           ///< excess content of the fresh outline on worn runs before the correction
                                       ///< [mm^2 per mm; mm^3 in axisymmetry]
  double largest_correction_mm = 0.0;  ///< largest move of a node by the correction
  double mesh_seconds = 0.0;           ///< spent in redrawing and meshing
  std::string failure;                 ///< empty; else what cannot be drawn or meshed, and where
};

/// A fresh mesh inside the worn outline, with the same boundaries. On worn runs the fresh polygon has exactly the
/// content of the old one, to round-off; curves of CAD are only redivided (their polygons differ by the area that
/// chords cut off). `zones` replace the fine zones of the drawing; none: the drawing keeps its own. Its other sizes do
/// not change. With `keep_nodes` the outline keeps the nodes of the worn one and no field on it needs to be carried;
/// where the cells are poor it is divided again all the same. Runs gmsh: one call at a time.   (README, 7)
RemeshResult remesh(const body::ShapePtr& worn, base::Analysis analysis, const std::vector<cad::FineZone>& zones = {},
                    const RemeshOptions& options = {});

}  // namespace reye::adapt
