#include "cad/part/mirror.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/errors.hpp"
#include "cad/part/axis_pieces.hpp"
#include "cad/part/half.hpp"
#include "cad/part/text.hpp"

namespace reye::cad {

namespace {

constexpr double mirror_share = 1e-6;  ///< of a part's extent: how far mirror images may lie apart

/// The pieces of a part on one side, those on the left mirrored.
std::vector<Edge> pieces_on(const Part& part, int side, double width) {
  std::vector<Edge> edges;
  for (const Loop& loop : part.loops)
    for (const Edge& whole : loop)
      for (AxisPiece& piece : axis_pieces(whole, width)) {
        if (piece.side != side) continue;
        if (side < 0)
          for (Points* list : {&piece.edge.knots, &piece.edge.tangents})
            for (Vec2& p : *list) p.x() = -p.x();
        edges.push_back(std::move(piece.edge));
      }
  return edges;
}

double distance(const std::vector<Edge>& edges, const Vec2& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Edge& edge : edges) {
    const auto box = bounding_box(edge);
    const double dx = std::max({box[0] - p.x(), p.x() - box[2], 0.0}),
                 dy = std::max({box[1] - p.y(), p.y() - box[3], 0.0});
    if (std::hypot(dx, dy) < least) least = std::min(least, foot_on(edge, p).distance);
  }
  return least;
}

struct Farthest {
  double distance = 0.0;
  Vec2 at{0.0, 0.0};
};

/// The point of some edges that lies farthest from others.
Farthest farthest(const std::vector<Edge>& from, const std::vector<Edge>& to) {
  constexpr int samples = 16;
  Farthest most;
  for (const Edge& edge : from)
    for (int i = 0; i <= samples; ++i) {
      const Vec2 p = at(edge, edge.length() * i / samples);
      if (const double d = distance(to, p); d > most.distance) most = {d, p};
    }
  return most;
}

}  // namespace

bool are_mirrored(const Part& left, const Part& right) {
  const double size = extent(right), width = axis_width(right);
  const auto mirrored = pieces_on(left, -1, width), own = pieces_on(right, 1, width);
  const double most = mirror_share * size;
  return !mirrored.empty() && farthest(mirrored, own).distance <= most && farthest(own, mirrored).distance <= most;
}

std::string asymmetry(const Part& part) {
  const double width = axis_width(part);
  const auto left = pieces_on(part, -1, width), right = pieces_on(part, 1, width);
  Farthest most = farthest(right, left);
  if (Farthest other = farthest(left, right); other.distance > most.distance)
    most = {other.distance, {-other.at.x(), other.at.y()}};
  if (most.distance <= mirror_share * extent(part)) return {};
  const auto box = bounding_box(part);
  std::string areas;
  try {
    const double right_area = area(half_of(part).part);
    areas = ", has " + text(area(part) - right_area) + " mm^2 at x < 0 and " + text(right_area) + " mm^2 at x > 0";
  } catch (const base::MeshError&) {  // the other sizes are enough
  }
  return "it reaches from x = " + text(box[0]) + " to " + text(box[2]) + areas + ", and its outline at " +
         text(most.at) + " lies " + text(most.distance) + " mm from the mirrored other half";
}

std::string chosen_on_one_side(const Part& part, const EdgeChoice& choice) {
  const double size = extent(part), width = axis_width(part);
  std::vector<Edge> right;
  std::vector<std::pair<const Edge*, Vec2>> left;  // a point of each piece, mirrored
  for (std::size_t l = 0; l < part.loops.size(); ++l)
    for (std::size_t k = 0; k < part.loops[l].size(); ++k) {
      if (!choice[l][k]) continue;
      for (AxisPiece& piece : axis_pieces(part.loops[l][k], width)) {
        const Vec2 middle = at(piece.edge, 0.5 * piece.edge.length());
        if (piece.side < 0) left.emplace_back(&part.loops[l][k], Vec2(-middle.x(), middle.y()));
        if (piece.side > 0) right.push_back(std::move(piece.edge));
      }
    }
  const auto lonely = std::find_if(left.begin(), left.end(),
                                   [&](const auto& p) { return distance(right, p.second) > mirror_share * size; });
  return lonely == left.end() ? "" : describe(*lonely->first);
}

}  // namespace reye::cad
