#include "cad/part/map_to_plane.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "cad/part/own_mesh.hpp"
#include "cad/part/plane.hpp"

namespace reye::cad {

namespace {

std::vector<Vec3> all_points(const RawPart& raw) {
  std::vector<Vec3> points = raw.mesh.nodes;
  for (const RawCurve& curve : raw.curves) points.insert(points.end(), curve.points.begin(), curve.points.end());
  points.insert(points.end(), raw.surface_points.begin(), raw.surface_points.end());
  return points;
}

/// Largest distance of the points from a common plane across the axes, over their extent.
double unevenness(const std::vector<Vec3>& points, const Plane& plane) {
  const Vec3 normal = plane.e1.cross(plane.e2), origin = points.front();
  double height = 0.0, extent = 0.0;
  for (const Vec3& p : points) {
    height = std::max(height, std::abs((p - origin).dot(normal)));
    extent = std::max(extent, (p - origin).norm());
  }
  return extent > 0.0 ? height / extent : 0.0;
}

Part mapped(const RawPart& raw, const Plane& plane) {
  if (!raw.mesh.cells.empty()) return part_with_mesh(raw, plane);
  std::vector<Edge> edges;
  for (const RawCurve& curve : raw.curves) {
    Points knots, directions;
    for (const Vec3& p : curve.points) knots.push_back(plane.map(p));
    for (const Vec3& t : curve.directions) directions.push_back(plane.map(t));
    edges.push_back(make_edge(curve.type, std::move(knots), std::move(directions)));
    edges.back().names = curve.names;
  }
  return {raw.label, make_loops(std::move(edges)), {}};
}

/// The error of the k-th face of a scene.
base::Issue issue_of(const RawPart& raw, std::size_t k, const std::string& rule) {
  const std::string face = raw.label.empty() ? "face " + std::to_string(k + 1) : "face '" + raw.label + "'";
  return {"geometry", "\"" + raw.file + "\"", face + ": " + rule};
}

/// The rule that keeps a part from being mapped; empty when it can be.
std::string broken_rule(const RawPart& raw, const Plane& plane, bool cut) {
  constexpr double tolerance = 1e-6;
  const std::vector<Vec3> points = all_points(raw);
  if (unevenness(points, plane_of(points)) > tolerance) return "a body must be a planar face";
  if (unevenness(points, plane) <= tolerance) return "";
  return cut ? "lies in a plane that is not parallel to the section"
             : "all faces of a scene must lie in parallel planes";
}

}  // namespace

std::vector<Part> map_to_plane(const std::vector<RawPart>& raw, const std::optional<Section>& section) {
  std::vector<base::Issue> issues;
  std::vector<Part> parts;
  std::optional<Plane> plane;
  if (section) plane = plane_across(section->normal.stableNormalized());
  for (std::size_t k = 0; k < raw.size(); ++k) {
    try {
      if (!plane) plane = plane_of(all_points(raw[k]));
      const std::string rule = broken_rule(raw[k], *plane, section.has_value());
      if (!rule.empty()) {
        issues.push_back(issue_of(raw[k], k, rule));
        continue;
      }
      parts.push_back(mapped(raw[k], *plane));
      if (parts.back().loops.empty()) throw base::MeshError("the face has no outline");
      parts.back().file = raw[k].file;
    } catch (const base::MeshError& error) {
      issues.push_back(issue_of(raw[k], k, error.what()));
    }
  }
  if (!issues.empty()) throw base::InputError(issues);
  return parts;
}

}  // namespace reye::cad
