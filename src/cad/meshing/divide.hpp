#pragma once
#include <vector>

#include "cad/meshing/points.hpp"
#include "cad/meshing/size_field.hpp"
#include "cad/part/part.hpp"
#include "cad/part/zone.hpp"

namespace reye::cad {

/// The nodes of a closed loop in order, without repeating the first, and the edge each segment lies on:
/// `edge[i]` carries the segment from node i to the next. `corner` marks nodes that may end a run of the outline:
/// all ends of edges and stretches.
struct DividedLoop {
  Points nodes;
  std::vector<int> edge;
  std::vector<bool> corner;
};

/// Divides the edges of a loop by the size field. Stretches of fine zones, on each side of the zone's centre,
/// are divided equally by the zone's size. `even`: an even number between any two corners, as all-quad meshing needs.
/// Points marked on the loop become nodes, or move to a corner within a quarter of an element.
DividedLoop divide(const Loop& loop, const std::vector<ZoneOutline>& zones, const SizeField& size, bool even,
                   const std::vector<Mark>& points = {});

}  // namespace reye::cad
