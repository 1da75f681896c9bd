#include "cad/meshing/divide.hpp"

#include <algorithm>
#include <cmath>

namespace reye::cad {

namespace {

/// Number of elements for a wished (real) number of them.
int count(double wished, bool even) {
  return even ? std::max(2, 2 * static_cast<int>(std::lround(0.5 * wished)))
              : std::max(1, static_cast<int>(std::lround(wished)));
}

/// Arc lengths dividing [begin, end] so that each element holds the same integral of ds / size(s): interior points
/// only. The integral is marched from the finer end, so that mirrored stretches get mirrored points.
std::vector<double> graded(const Edge& edge, double begin, double end, const SizeField& size, bool even) {
  const double step = size(at(edge, begin)) <= size(at(edge, end)) ? 1.0 : -1.0;
  const double from = step > 0.0 ? begin : end, length = end - begin;
  std::vector<double> distance{0.0}, integral{0.0};
  while (distance.back() < length * (1.0 - 1e-12)) {
    const double d = distance.back();
    const double ds = std::min(0.05 * size(at(edge, from + step * d)), length - d);
    integral.push_back(integral.back() + ds / size(at(edge, from + step * (d + 0.5 * ds))));
    distance.push_back(d + ds);
  }
  const int elements = count(integral.back(), even);
  std::vector<double> points;
  std::size_t k = 0;
  for (int i = 1; i < elements; ++i) {
    const double target = integral.back() * i / elements;
    while (integral[k + 1] < target) ++k;
    const double u = (target - integral[k]) / (integral[k + 1] - integral[k]);
    points.push_back(from + step * (distance[k] + u * (distance[k + 1] - distance[k])));
  }
  if (step < 0.0) std::reverse(points.begin(), points.end());
  return points;
}

std::vector<double> equal(double begin, double end, double size, bool even) {
  const int elements = count((end - begin) / size, even);
  std::vector<double> points;
  for (int i = 1; i < elements; ++i) points.push_back(begin + (end - begin) * i / elements);
  return points;
}

/// Where an edge must have nodes: its ends, the ends of fine stretches, marked points and the centres of zones.
std::vector<double> breaks(const Edge& edge, int k, const std::vector<ZoneOutline>& zones, const SizeField& size,
                           const std::vector<Mark>& points) {
  std::vector<double> marks{0.0, edge.length()};
  for (const ZoneOutline& zone : zones) {
    for (const Stretch& stretch : zone.stretches)
      if (stretch.edge == k) marks.insert(marks.end(), {stretch.begin, stretch.end});
  }
  for (const Mark& point : points) {
    const double apart = 0.25 * size(at(edge, point.s));
    const auto near = [&](double mark) { return std::abs(mark - point.s) < apart; };
    if (point.edge == k && std::none_of(marks.begin(), marks.end(), near)) marks.push_back(point.s);
  }
  for (const ZoneOutline& zone : zones) {
    // A centre within two elements of a mark would only leave slivers.
    const auto near = [&](double mark) { return std::abs(mark - zone.centre_arc) < 2.0 * zone.size; };
    if (zone.centre_edge == k && std::none_of(marks.begin(), marks.end(), near)) marks.push_back(zone.centre_arc);
  }
  std::sort(marks.begin(), marks.end());
  const double apart = 1e-9 * edge.length();
  const auto last = std::unique(marks.begin(), marks.end(), [&](double a, double b) { return b - a < apart; });
  marks.erase(last, marks.end());
  marks.back() = edge.length();
  return marks;
}

/// Smallest size of the zones whose stretch of edge k covers arc length s; 0 if none does.
double fine_size(double s, int k, const std::vector<ZoneOutline>& zones) {
  double size = 0.0;
  for (const ZoneOutline& zone : zones)
    for (const Stretch& stretch : zone.stretches)
      if (stretch.edge == k && s > stretch.begin && s < stretch.end && (size == 0.0 || zone.size < size))
        size = zone.size;
  return size;
}

}  // namespace

DividedLoop divide(const Loop& loop, const std::vector<ZoneOutline>& zones, const SizeField& size, bool even,
                   const std::vector<Mark>& points) {
  DividedLoop divided;
  const auto add = [&](const Vec2& node, int edge, bool corner) {
    divided.nodes.push_back(node);
    divided.edge.push_back(edge);
    divided.corner.push_back(corner);
  };
  for (int k = 0; k < static_cast<int>(loop.size()); ++k) {
    const Edge& edge = loop[k];
    std::vector<double> marks = breaks(edge, k, zones, size, points);
    // A loop of one edge needs a second corner: gmsh's runs must not close on themselves.
    if (loop.size() == 1 && marks.size() == 2) marks.insert(marks.begin() + 1, 0.5 * edge.length());
    for (std::size_t i = 0; i + 1 < marks.size(); ++i) {
      const double fine = fine_size(0.5 * (marks[i] + marks[i + 1]), k, zones);
      add(at(edge, marks[i]), k, true);
      for (double s :
           fine > 0.0 ? equal(marks[i], marks[i + 1], fine, even) : graded(edge, marks[i], marks[i + 1], size, even))
        add(at(edge, s), k, false);
    }
  }
  return divided;
}

}  // namespace reye::cad
