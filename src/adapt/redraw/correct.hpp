#pragma once
#include <vector>

#include "base/analysis.hpp"
#include "base/linalg.hpp"

namespace reye::adapt {

using base::Analysis;
using base::Points;

/// One edge of a drawing as nodes of the old outline and of the new one; both polygons have the same ends.
struct EdgePair {
  std::vector<int> before, after;
  bool worn = false;  ///< may be corrected
};

/// The correction that makes the new outline enclose as much as the old one.
struct Correction {
  Points shift;             ///< of every new node; zero off the worn edges and at their ends
  double residue = 0.0;     ///< excess content of the new outline, all edges together [mm^2 per mm; mm^3]
  double left = 0.0;        ///< the part of it that no edge could take [mm^2 per mm; mm^3]
  double largest_mm = 0.0;  ///< longest shift
};

/// Content between the polygon of `points` and its closing chord, body on the left: 1/2 sum (x_i - x_0) cross (x_(i+1)
/// - x_i); in axisymmetry of the solid of revolution. In second order every second point is the middle node of a
/// quadratic edge, whose curve bounds the content.
double fan_volume(Analysis analysis, const Points& points, int order = 1);

/// Shifts the inner nodes of every worn edge along their normals: first each by the mean height of the old outline over
/// the new one round it, int N_k h ds / int N_k ds, so that content is kept where it was; then all by one length, less
/// within two facets of the ends, that gives the edge its whole content, found by the secant method down to round-off.
/// Edges are measured one by one from their own first point, so that no digits go into the size of the body. The excess
/// of straight edges and of worn edges without inner nodes goes to the longest worn edge. In second order edges list
/// middle nodes between vertices, and N_k are the Bernstein functions of vertices and control points.
Correction correct(Analysis analysis, const Points& before, const Points& after, const std::vector<EdgePair>& edges,
                   int order = 1);

}  // namespace reye::adapt
