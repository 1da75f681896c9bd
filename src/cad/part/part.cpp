#include "cad/part/part.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/errors.hpp"
#include "cad/part/text.hpp"

namespace reye::cad {

namespace {

double swept_area(const Loop& loop) {
  double sum = 0.0;
  for (const Edge& edge : loop) sum += swept_area(edge);
  return sum;
}

double extent(const std::vector<Edge>& edges) {
  double largest = 0.0;
  for (const Edge& edge : edges) {
    const auto box = bounding_box(edge);
    largest = std::max(largest, std::hypot(box[2] - box[0], box[3] - box[1]));
  }
  return largest;
}

/// Takes from `loose` the edge that continues at `end`, turned if need be; ends may differ by CAD tolerance.
Edge take_next(std::vector<Edge>& loose, const Vec2& end, double tolerance) {
  auto best = loose.end();
  double nearest = tolerance;
  for (auto edge = loose.begin(); edge != loose.end(); ++edge) {
    const double distance = std::min((edge->first() - end).norm(), (edge->last() - end).norm());
    if (distance > nearest) continue;
    nearest = distance;
    best = edge;
  }
  if (best == loose.end()) throw base::MeshError("the outline stays open at " + text(end));
  Edge next = std::move(*best);
  loose.erase(best);
  return (next.first() - end).norm() <= (next.last() - end).norm() ? next : reversed(std::move(next));
}

void turn_round(Loop& loop) {
  std::reverse(loop.begin(), loop.end());
  for (Edge& edge : loop) edge = reversed(std::move(edge));
}

}  // namespace

double area(const Part& part) {
  double sum = 0.0;
  for (const Loop& loop : part.loops) sum += swept_area(loop);
  return sum;
}

std::array<double, 4> bounding_box(const Part& part) {
  std::array<double, 4> box = bounding_box(part.loops.front().front());
  for (const Edge& edge : part.loops.front()) {
    const auto b = bounding_box(edge);
    box = {std::min(box[0], b[0]), std::min(box[1], b[1]), std::max(box[2], b[2]), std::max(box[3], b[3])};
  }
  return box;
}

bool contains(const Part& part, const Vec2& p) {
  double angle = 0.0;
  for (const Loop& loop : part.loops)
    for (const Edge& edge : loop)
      for (std::size_t i = 0; i + 1 < edge.knots.size(); ++i) {
        const Vec2 a = edge.knots[i] - p, b = edge.knots[i + 1] - p;
        angle += std::atan2(base::cross(a, b), a.dot(b));
      }
  return angle > std::numbers::pi;
}

std::vector<Loop> make_loops(std::vector<Edge> loose) {
  const double tolerance = 1e-5 * extent(loose);
  std::vector<Loop> loops;
  while (!loose.empty()) {
    Loop loop{std::move(loose.front())};
    loose.erase(loose.begin());
    while ((loop.back().last() - loop.front().first()).norm() > tolerance)
      loop.push_back(take_next(loose, loop.back().last(), tolerance));
    // Exactly common end points, whatever the CAD's tolerance.
    for (std::size_t i = 0; i < loop.size(); ++i) loop[i].knots.back() = loop[(i + 1) % loop.size()].knots.front();
    loops.push_back(std::move(loop));
  }
  const auto outer = std::max_element(loops.begin(), loops.end(), [](const Loop& a, const Loop& b) {
    return std::abs(swept_area(a)) < std::abs(swept_area(b));
  });
  if (outer != loops.end()) std::rotate(loops.begin(), outer, outer + 1);
  for (std::size_t i = 0; i < loops.size(); ++i)
    if ((swept_area(loops[i]) > 0.0) != (i == 0)) turn_round(loops[i]);
  return loops;
}

std::string describe(const Part& part) {
  return (part.label.empty() ? std::string("unnamed") : "'" + part.label + "'") + " in " + text(bounding_box(part));
}

std::string describe(const Edge& edge) {
  return to_string(edge.type) + " " + text(edge.first()) + " to " + text(edge.last());
}

}  // namespace reye::cad
