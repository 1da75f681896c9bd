#include "cad/part/axis_pieces.hpp"

#include <algorithm>
#include <cmath>

namespace reye::cad {

namespace {

int side_of(double x, double width) { return x > width ? 1 : x < -width ? -1 : 0; }

double crossing(const Edge& edge, double a, double b) {
  const bool rising = at(edge, b).x() > 0.0;
  for (int bisection = 0; bisection < 100; ++bisection) {
    const double middle = 0.5 * (a + b);
    ((at(edge, middle).x() > 0.0) == rising ? b : a) = middle;
  }
  return 0.5 * (a + b);
}

/// The piece with those ends that are nearly on the axis put exactly onto it.
Edge laid_on_axis(Edge edge, double width) {
  for (Vec2* end : {&edge.knots.front(), &edge.knots.back()})
    if (side_of(end->x(), width) == 0) end->x() = 0.0;
  if (edge.type != EdgeType::line) return edge;
  const Vec2 way = edge.last() - edge.first();
  Edge line = make_edge(EdgeType::line, {edge.first(), edge.last()}, {way, way});
  line.names = std::move(edge.names);
  return line;
}

/// The bounding box of all loops, since one part may hold two faces.
std::array<double, 4> whole_box(const Part& part) {
  std::array<double, 4> box = bounding_box(part);
  for (const Loop& loop : part.loops)
    for (const Edge& edge : loop) {
      const auto b = bounding_box(edge);
      box = {std::min(box[0], b[0]), std::min(box[1], b[1]), std::max(box[2], b[2]), std::max(box[3], b[3])};
    }
  return box;
}

}  // namespace

double extent(const Part& part) {
  const auto box = whole_box(part);
  return std::hypot(box[2] - box[0], box[3] - box[1]);
}

double axis_width(const Part& part) { return 1e-7 * extent(part); }

std::vector<AxisPiece> axis_pieces(const Edge& edge, double width) {
  std::vector<double> cuts{0.0};
  std::vector<int> sides;
  double before = 0.0;
  for (std::size_t i = 0; i < edge.knots.size(); ++i) {
    const int side = side_of(edge.knots[i].x(), width);
    if (side == 0) continue;
    if (sides.empty()) sides.push_back(side);
    if (side != sides.back()) {
      cuts.push_back(crossing(edge, before, edge.arc[i]));
      sides.push_back(side);
    }
    before = edge.arc[i];
  }
  const bool ring = edge.first() == edge.last() && side_of(edge.first().x(), width) != 0;
  if (ring && sides.size() > 1)
    return axis_pieces(begun_at(edge, cuts[1]), width);  // no joint where the file begins it
  if (sides.empty()) sides.push_back(0);
  cuts.push_back(edge.length());
  std::vector<AxisPiece> pieces;
  for (std::size_t k = 0; k < sides.size(); ++k)
    pieces.push_back({laid_on_axis(trimmed(edge, cuts[k], cuts[k + 1]), width), sides[k]});
  return pieces;
}

bool crosses_axis(const Part& part) {
  const auto box = whole_box(part);
  const double width = axis_width(part);
  return side_of(box[0], width) < 0 && side_of(box[2], width) > 0;
}

}  // namespace reye::cad
