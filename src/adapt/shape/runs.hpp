#pragma once
#include <numbers>
#include <vector>

#include "base/linalg.hpp"

namespace reye::adapt {

using base::Points;

/// Turning of an outline at a node [rad]: the least at which it may be a corner; the least of the drawing where it has
/// one.
constexpr double least_turning = 20.0 * std::numbers::pi / 180.0, drawn_kink = 30.0 * std::numbers::pi / 180.0;

/// One segment a -> b of an outline loop, and the edge it was drawn as.
struct Segment {
  int a = -1, b = -1;
  int edge = -1;  ///< of the old drawing
  bool starts_edge = false, ends_edge = false;
  bool worn = false;    ///< to be drawn through its nodes
  bool hard = false;    ///< nothing is drawn across its node a: a corner, or names change
  double length = 0.0;  ///< now [mm]
  int mid = -1;         ///< in second order the node in the middle
};

/// Angle by which the outline turns at the node where segment i of a closed loop starts, without sign [rad].
double turning_at(const std::vector<Segment>& loop, std::size_t i, const Points& X);

/// Whether a closed loop has a corner where segment i starts: it turns there by more than 50 degrees, or by more than
/// 20 degrees and five times the mean of the nodes beside.
std::vector<bool> corners(const std::vector<Segment>& loop, const Points& X);

/// Cuts a closed loop into runs that become one edge each: worn segments between hard nodes and fresh segments, fresh
/// segments of one old edge. A run shorter than about two facets beside it is no edge of its own: a fresh one is
/// taken into the worn one beside it, a worn one takes as much of the fresh one beside it.
/// `worn_edges`: edges of the old drawing that are redrawn as a whole or not at all.
std::vector<std::vector<Segment>> runs_of(std::vector<Segment> loop, const std::vector<bool>& worn_edges);

}  // namespace reye::adapt
