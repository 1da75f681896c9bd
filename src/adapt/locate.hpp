#pragma once
#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "mesh/shape.hpp"

/// Where a point lies in a mesh or beside a polyline. n log n; answers do not hang on the order of the queries.
namespace reye::adapt {

using base::Points;
using base::Vec2;

/// The cell of a mesh under a point, of sound meshes and of ruined ones: an inverted or concave quadrilateral still
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
    Vec2 xi{0.0, 0.0};                            ///< reference coordinates, within the reference cell
    mesh::NodeValues weights = mesh::NodeValues::Zero();  ///< of the nodes of the cell: sum 1, sum w_a X_a = the place
    double distance = 0.0;                        ///< from the point to its place [mm], 0 inside
  };

  /// The place of p, or of the point of the mesh closest to it. weights = N(xi); where the map of no cell can be
  /// inverted with det J > 0 they are the barycentric coordinates in a sub-triangle of the cell, and xi only the
  /// same mean of the reference corners. On a node to round-off (1e-14 of the largest coordinate): a unit vector.
  Place find(const Vec2& p) const;

 private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

/// Segments a -> b in the plane, searched for the nearest one; a == b is a point.
class SegmentTree {
 public:
  using Segment = std::array<Vec2, 2>;
  explicit SegmentTree(std::vector<Segment> segments);
  explicit SegmentTree(const Points& points);

  /// Place a + s (b - a), 0 <= s <= 1, of the segment nearest to a point; segment -1: none wanted is near enough.
  struct Foot {
    int segment = -1;
    double s = 0.0;
    double distance = std::numeric_limits<double>::infinity();
  };
  /// Of equally near ones that with the smallest number. `wanted` leaves segments out, null: none; `within` [mm]
  /// bounds the search.
  Foot nearest(const Vec2& p, const std::function<bool(int)>& wanted = {},
               double within = std::numeric_limits<double>::infinity()) const;

 private:
  struct Box {
    Eigen::Array2d low, high;
    int begin = 0, end = 0;     ///< range of order_
    int left = -1, right = -1;  ///< boxes_ of the two halves, -1 in a leaf
  };
  int build(int begin, int end);

  std::vector<Segment> segments_;
  std::vector<int> order_;
  std::vector<Box> boxes_;
};

}  // namespace reye::adapt
