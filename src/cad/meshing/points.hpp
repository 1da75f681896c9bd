#pragma once
#include <vector>

#include "cad/meshing/size_field.hpp"
#include "cad/part/part.hpp"

/// Places where a point load or support acts: vertices of every mesh of the body, so that none moves to another node
/// when the body is remeshed.
namespace reye::cad {

/// A place on an edge of a loop.
struct Mark {
  int loop = 0, edge = 0;
  double s = 0.0;
};

/// The marks of those points that lie on the outline or within a quarter of an element of it.
std::vector<Mark> marks_of(const Part& part, const std::vector<Vec2>& points, const SizeField& size);

/// Moves the inner vertex nearest to each other point inside the body onto it, and its neighbours less the farther away
/// they are. A point to which cells of fair shape cannot be drawn is left.
void draw_to_points(mesh::Mesh& mesh, const Part& part, const std::vector<Vec2>& points, const SizeField& size);

/// The vertices that lie at the points.
std::vector<int> vertices_at(const mesh::Mesh& mesh, const std::vector<Vec2>& points);

}  // namespace reye::cad
