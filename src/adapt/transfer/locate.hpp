#pragma once
#include <memory>

#include "mesh/shape.hpp"

/// Where a point lies in a mesh. n log n; answers do not depend on the order of the queries.
namespace reye::adapt {

using base::Points;
using base::Vec2;

/// The cell of a mesh under a point, for sound and for degraded meshes: an inverted or concave quadrilateral still
/// gives weights that reproduce the point.
class Locator {
 public:
  /// Throws base::MeshError when no cell has any area. The mesh need not outlive the locator.
  explicit Locator(const mesh::Mesh& mesh);
  ~Locator();
  Locator(Locator&&) noexcept;
  Locator& operator=(Locator&&) noexcept;

  struct Place {
    int cell = -1;
    Vec2 xi{0.0, 0.0};                                    ///< reference coordinates, within the reference cell
    mesh::NodeValues weights = mesh::NodeValues::Zero();  ///< of the nodes of the cell: sum 1, sum w_a X_a = the place
    double distance = 0.0;                                ///< from the point to its place [mm], 0 inside
  };

  /// The place of p, or of the point of the mesh closest to it. weights = N(xi); where the map of no cell can be
  /// inverted with det J > 0 they are the barycentric coordinates in a sub-triangle of the cell, and xi only the
  /// same mean of the reference corners. On a node to round-off (1e-14 of the largest coordinate): a unit vector.
  Place find(const Vec2& p) const;

 private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

}  // namespace reye::adapt
