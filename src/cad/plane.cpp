#include "cad/plane.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "cad/own_mesh.hpp"

namespace reye::cad {

namespace {

std::vector<Vec3> all_points(const RawPart& raw) {
  std::vector<Vec3> points = raw.mesh.nodes;
  for (const RawCurve& curve : raw.curves) points.insert(points.end(), curve.points.begin(), curve.points.end());
  points.insert(points.end(), raw.surface_points.begin(), raw.surface_points.end());
  return points;
}

template <class Measure>
Vec3 farthest(const std::vector<Vec3>& points, Measure measure) {
  return *std::max_element(points.begin(), points.end(),
                           [&](const Vec3& a, const Vec3& b) { return measure(a) < measure(b); });
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

/// What is wrong with the k-th face of a scene.
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
  return cut ? "lies in a plane that is not parallel to the section" : "all faces of a scene must lie in parallel planes";
}

}  // namespace

Plane plane_across(Vec3 normal) {
  for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ())})
    if (std::abs(normal.dot(axis)) > 1.0 - 1e-14) normal = axis;
  if (normal.z() == 1.0) return {};
  if (std::abs(normal.z()) < 1e-9) {
    const Vec3 e2 = Vec3::UnitZ();
    Vec3 e1 = e2.cross(normal).normalized();
    if (e1.x() < -1e-9 || (e1.x() < 1e-9 && e1.y() < 0.0)) e1 = -e1;
    return {e1, e2};
  }
  if (normal.z() < 0.0) normal = -normal;
  const Vec3 along = std::abs(normal.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
  const Vec3 e1 = (along - along.dot(normal) * normal).normalized();
  return {e1, normal.cross(e1)};
}

Plane plane_of(const std::vector<Vec3>& points) {
  if (points.empty()) throw base::MeshError("the face has no outline");
  const Vec3 origin = points.front();
  const Vec3 far = farthest(points, [&](const Vec3& p) { return (p - origin).squaredNorm(); }) - origin;
  const Vec3 wide = farthest(points, [&](const Vec3& p) { return far.cross(p - origin).squaredNorm(); }) - origin;
  const Vec3 normal = far.cross(wide);
  if (!(normal.norm() > 1e-12 * far.squaredNorm())) throw base::MeshError("the face has no area");
  return plane_across(normal.normalized());
}

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
