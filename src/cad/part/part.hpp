#pragma once
#include <optional>
#include <string>
#include <vector>

#include "cad/part/edge.hpp"
#include "mesh/mesh.hpp"

namespace reye::cad {

/// Edges that close on themselves, body on the left.
using Loop = std::vector<Edge>;

/// A piece of material found in a file: a candidate for a body. Parts share nothing, so that touching bodies stay
/// distinct even where their CAD shares curves.
struct Part {
  std::string label;               ///< STEP product or physical surface; empty when the file names none
  std::vector<Loop> loops;         ///< outer loop first
  std::optional<mesh::Mesh> mesh;  ///< when the file brought its own; one edge knot per outline node, then
  std::string file{};              ///< that holds it
};

double area(const Part& part);
std::array<double, 4> bounding_box(const Part& part);

/// Whether p lies inside, by the number of times the outline winds round it.
bool contains(const Part& part, const Vec2& p);

/// Chains loose edges into loops by their end points, turns them so that the body lies on the left, outer loop
/// first. Throws base::MeshError naming the place where an outline stays open.
std::vector<Loop> make_loops(std::vector<Edge> edges);

/// "'punch' in [-6, 0, 6, 6]" for lists in issues.
std::string describe(const Part& part);

/// "line [0, 0] to [1, 0]"
std::string describe(const Edge& edge);

}  // namespace reye::cad
