#pragma once
#include <string>

#include "body/shape.hpp"

namespace reye::adapt {

/// Bounds beyond which a worn body is remeshed.
struct Triggers {
  double min_scaled_jacobian = 0.3;
  double min_angle_deg = 15.0;
  double size_ratio = 2.5;
  double wear_fraction = 0.5;
};

/// A measured value and where in the body it was found [mm, on X].
struct Measured {
  double value = 0.0;
  base::Vec2 at{0.0, 0.0};
};

/// The quality of a mesh after wear and deformation since it was made.
struct MeshState {
  Measured scaled_jacobian{1.0};  ///< poorest of the cells that have less than 0.7 of what they were born with; 1: none
  Measured angle_deg{
      90.0};  ///< smallest of the cells whose smallest corner angle is below 0.7 of that at birth; 90: none
  Measured size_ratio{
      1.0};  ///< of the length of an outline facet to that at birth, or the other way round; the largest
  Measured wear_fraction{
      0.0};  ///< wear since birth over the height of the element below then; the largest of all nodes
};

/// Of the lengths of a shape's outline facets with its nodes at `x`: `MeshState::size_ratio`.
Measured largest_size_ratio(const body::Shape& shape, const base::Points& x);

/// Measures a shape with its nodes at `x`: X itself, or X + u; the wear is always that on X.
MeshState measure(const body::Shape& shape, const base::Points& x);

/// Why a mesh is no longer fit, in words: value, place and bound of what exceeds its bound by the largest factor, on X
/// or in the current shape. Empty when it is fit. `current`: positions in the current shape; null: X alone. A mesh that
/// was poor from the start is no reason: only cells that have lost 0.3 of their quality since count, or no new mesh
/// would ever pass.
std::string why_remesh(const body::Shape& shape, const base::Points* current, const Triggers& triggers);

/// Why the current shape should become X on a fresh mesh, by the elements and facets of the current shape alone.
std::string why_renew(const body::Shape& shape, const base::Points& current, const Triggers& triggers);

}  // namespace reye::adapt
