#pragma once
#include <string>
#include <vector>

#include "adapt/shape/strip.hpp"
#include "adapt/shape/worn_boundary.hpp"
#include "base/analysis.hpp"
#include "mesh/mesh.hpp"

namespace reye::adapt {

/// Neighbours of every node along the closed outline, body on the left; -1 for nodes inside. In second order every
/// second one is the middle node of an edge.
struct Outline {
  std::vector<int> before, after;
  std::vector<char> middle;
  bool holds(int node) const { return after[node] >= 0; }
  /// The facet that starts at a vertex, and the one that ends there.
  LineFacet facet_after(int a) const {
    return middle[after[a]] ? LineFacet{a, after[after[a]], after[a]} : LineFacet{a, after[a], -1};
  }
  LineFacet facet_before(int b) const { return facet_after(middle[before[b]] ? before[before[b]] : before[b]); }
};

Outline outline_of(const mesh::Mesh& mesh);

/// What one outline node loses, separated by the facets on which it was worn: the one before the node, the
/// one after it, or both together (shared by their lengths).
struct WornNode {
  int node = -1;
  double before = 0.0, after = 0.0, both = 0.0;
  double total() const { return before + after + both; }
};

/// The worn nodes in ascending order, boundaries that share nodes added up; nodes without loss left out.
std::vector<WornNode> worn_nodes(const mesh::Mesh& mesh, const std::vector<WornBoundary>& worn);

/// Every outline facet with at least one worn node.
std::vector<LineFacet> touched_facets(const Outline& outline, const std::vector<WornNode>& nodes);

/// Step of a worn vertex for which, to first order, its strip has the volume it lost, with W = volume / nodal
/// length on each side.
/// Smooth outline: along the averaged normal of its worn facets. Corner (turning more than 50 degrees): to the
/// place where both facets are offset by their own W, so a corner worn on one side slides along the other.
/// P: nodes and control points.
Vec2 nodal_step(Analysis analysis, const Points& P, const Outline& outline, const WornNode& worn);

/// Step of the control point of a facet that lost `volume` while its ends move by `ends`: the middle of the curve gets
/// the depth sum B_j(1/2) W_j along its own normal, and moves along the chord by the mean of the ends.
Vec2 control_step(Analysis analysis, const std::array<Vec2, 3>& facet, const std::array<Vec2, 2>& ends, double volume);

/// A moved outline, or why it could not be moved.
struct MovedOutline {
  Points X;            ///< all nodes; those inside as they were
  double theta = 1.0;  ///< of all parts, the one farthest from 1
  int parts = 1;
  std::string failure;
};

/// Moves the worn nodes by their whole loss, in as many equal parts as the limits on one part ask for
/// (README, 3). Middle nodes stay between 0.4 and 0.6 of their chord.
MovedOutline move_outline(Analysis analysis, const mesh::Mesh& mesh, const Outline& outline,
                          const std::vector<WornNode>& nodes);

}  // namespace reye::adapt
