#pragma once
#include <vector>

#include "cad/part/edge.hpp"
#include "mesh/mesh.hpp"

namespace reye::adapt {

/// A named boundary as it was before any wear: smooth curves through the nodes of its first mesh, exact at these and
/// third order between them, with its corners.
class UnwornLine {
 public:
  UnwornLine(const mesh::Mesh& mesh, const mesh::Boundary& boundary);

  /// How far x lies below the line along the line's own normal where x is nearest to it [mm]; negative outside.
  double depth(const base::Vec2& x) const;

 private:
  std::vector<cad::Edge> edges_;
};

}  // namespace reye::adapt
