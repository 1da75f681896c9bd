#include "solver/passage.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace reye::solver {

namespace {

constexpr double least_depth = 0.5;  ///< of the search: a node less deep that faces the other side is detected

/// A side of a contact as straight pieces, at the start of the increment and now; a curved facet has two.
struct Line {
  Points before, now;
  std::vector<char> seen;  ///< per point: the integrals have found its opposite facets
  std::vector<std::array<int, 2>> pieces;
};

Line line_of(const mortar::Surface& surface, const Points& before, const Points& now, const std::vector<char>& seen) {
  Line line{before, now, seen, {}};
  for (const auto& [a, b, c] : surface.facets) {
    if (c < 0) {
      line.pieces.push_back({a, b});
      continue;
    }
    for (auto [from, to] : {std::pair{&before, &line.before}, std::pair{&now, &line.now}})
      (*to)[c] = 0.25 * ((*from)[a] + 2.0 * (*from)[c] + (*from)[b]);
    line.pieces.push_back({a, c});
    line.pieces.push_back({c, b});
  }
  return line;
}

/// How far a side moves at most, but for a translation.
double farthest(const Points& before, const Points& now, const Vec2& translation) {
  double way = 0.0;
  for (std::size_t k = 0; k < now.size(); ++k) way = std::max(way, (now[k] - before[k] - translation).squaredNorm());
  return std::sqrt(way);
}

/// Moments of the increment, in [0, 1), when c0 + c1 t + c2 t^2 changes sign.
std::vector<double> roots(double c0, double c1, double c2) {
  std::vector<double> found;
  const auto add = [&](double t) {
    if (t >= 0.0 && t < 1.0) found.push_back(t);
  };
  const double discriminant = c1 * c1 - 4.0 * c0 * c2;
  if (discriminant <= 0.0) return found;
  const double q = -0.5 * (c1 + std::copysign(std::sqrt(discriminant), c1));
  if (q != 0.0) add(c0 / q);
  if (c2 != 0.0) add(q / c2);
  return found;
}

/// How often point k enters through the pieces of a line, less how often it leaves; all move uniformly.
int entries(const Line& points, std::size_t k, const Line& line) {
  const Vec2 x0 = points.before[k], dx = points.now[k] - x0;
  int count = 0;
  for (const auto& [a, b] : line.pieces) {
    const Vec2 r0 = x0 - line.before[a], e0 = line.before[b] - line.before[a];
    const Vec2 dr = dx - (line.now[a] - line.before[a]), de = line.now[b] - line.now[a] - e0;
    const double c0 = base::cross(e0, r0), c1 = base::cross(de, r0) + base::cross(e0, dr), c2 = base::cross(de, dr);
    for (const double t : roots(c0, c1, c2)) {
      const Vec2 e = e0 + t * de, r = r0 + t * dr;
      const double along = e.dot(r) / e.squaredNorm();
      if (along >= 0.0 && along < 1.0) count += c1 + 2.0 * c2 * t > 0.0 ? 1 : -1;  // inside is on the left
    }
  }
  return count;
}

/// Depth of a point behind a line; 0 where it lies in front, or nearest to an open end.
double depth_behind(const Vec2& x, const Line& line) {
  double nearest = -1.0;
  bool behind = false;
  for (const auto& [a, b] : line.pieces) {
    const Vec2 e = line.now[b] - line.now[a], r = x - line.now[a];
    const double along = e.dot(r) / e.squaredNorm();
    const double distance = (r - std::clamp(along, 0.0, 1.0) * e).norm();
    if (nearest >= 0.0 && distance >= nearest) continue;
    nearest = distance;
    behind = along >= 0.0 && along <= 1.0 && base::cross(e, r) > 0.0;
  }
  return behind ? nearest : 0.0;
}

std::optional<Passage> passage(const Line& points, const std::vector<contact::SurfaceNode>& nodes, const Line& line,
                               double allowed) {
  for (std::size_t k = 0; k < points.now.size(); ++k) {
    if (points.seen[k] || entries(points, k, line) <= 0) continue;
    const double depth = depth_behind(points.now[k], line);
    if (depth > allowed) return Passage{nodes[k], points.now[k], depth};
  }
  return std::nullopt;
}

}  // namespace

std::optional<Passage> passage(const contact::Interface& face, const Sides& before, const Sides& now) {
  const auto& setup = face.setup();
  if (setup.options.bonded) return std::nullopt;
  const Vec2 way = now.primary.front() - before.primary.front();
  if (farthest(before.secondary, now.secondary, way) + farthest(before.primary, now.primary, way) < setup.search)
    return std::nullopt;
  std::vector<char> seen(now.secondary.size(), 0), met(now.primary.size(), 0);
  for (std::size_t j = 0; j < seen.size(); ++j) {
    if (face.rows()[j].cover <= contact::Interface::minimum_cover * setup.secondary.area[j]) continue;
    seen[j] = 1;
    for (const auto& [l, M] : face.rows()[j].M) met[l] = 1;
  }
  const Line secondary = line_of(setup.secondary, before.secondary, now.secondary, seen);
  const Line primary = line_of(setup.primary, before.primary, now.primary, met);
  const double allowed = face.inset() + least_depth * setup.search;  // a drawn overlap may still be there
  const auto found = passage(secondary, setup.secondary_nodes, primary, allowed);
  return found ? found : passage(primary, setup.primary_nodes, secondary, allowed);
}

}  // namespace reye::solver
