#include <gmsh.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "cad/gmsh/model.hpp"

namespace reye::cad {

namespace {

constexpr int knots_per_curve = 1025;  // odd: a knot in the middle of symmetric curves

std::vector<Vec3> triples(const std::vector<double>& flat) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i + 2 < flat.size(); i += 3) points.emplace_back(flat[i], flat[i + 1], flat[i + 2]);
  return points;
}

/// Distance of the points from the chord between the first and the last.
bool is_straight(const std::vector<Vec3>& points) {
  const Vec3 chord = points.back() - points.front();
  const Vec3 halfway = points[points.size() / 2] - points.front();
  if (chord.norm() <= 1e-9 * halfway.norm()) return false;  // closed
  return std::all_of(points.begin(), points.end(), [&](const Vec3& p) {
    return chord.cross(p - points.front()).norm() <= 1e-9 * chord.squaredNorm();
  });
}

/// Whether all points have one distance from the centre of the circle through three of them. Files that write
/// every curve as a spline (IGES) hold circles too.
bool is_circular(const std::vector<Vec3>& points) {
  const Vec3 &a = points.front(), &b = points[points.size() / 3], &c = points[2 * points.size() / 3];
  const Vec3 u = b - a, v = c - a, normal = u.cross(v);
  if (normal.norm() < 1e-9 * u.norm() * v.norm()) return false;
  const Vec3 to_centre =
      (v.squaredNorm() * normal.cross(u) + u.squaredNorm() * v.cross(normal)) / (2.0 * normal.squaredNorm());
  const double radius = to_centre.norm();
  return std::all_of(points.begin(), points.end(),
                     [&](const Vec3& p) { return std::abs((p - a - to_centre).norm() - radius) < 1e-7 * radius; });
}

RawCurve read_curve(int tag) {
  RawCurve curve;
  curve.tag = tag;
  curve.names = physical_names(1, tag);
  std::string type;
  gmsh::model::getType(1, tag, type);
  std::vector<double> lower, upper, flat, slopes, parameters;
  gmsh::model::getParametrizationBounds(1, tag, lower, upper);
  const int pieces = type == "Line" ? 1 : knots_per_curve - 1;
  for (int i = 0; i <= pieces; ++i) parameters.push_back(lower[0] + (upper[0] - lower[0]) * i / pieces);
  gmsh::model::getValue(1, tag, parameters, flat);
  gmsh::model::getDerivative(1, tag, parameters, slopes);
  curve.points = triples(flat);
  curve.directions = triples(slopes);
  if (type == "Line" || is_straight(curve.points)) {
    curve.points = {curve.points.front(), curve.points.back()};
    curve.directions.assign(2, curve.points.back() - curve.points.front());
  } else {
    curve.type = is_circular(curve.points) ? EdgeType::circle : EdgeType::spline;
  }
  for (std::size_t i = 0; i < curve.directions.size(); ++i)  // the derivative of a spline may vanish at its ends
    if (!(curve.directions[i].norm() > 1e-12 * (curve.points.back() - curve.points.front()).norm()))
      curve.directions[i] = curve.points[std::min(i + 1, curve.points.size() - 1)] - curve.points[i > 0 ? i - 1 : 0];
  return curve;
}

/// Points of a face of unknown kind, for the test of planarity.
std::vector<Vec3> points_on(int face) {
  std::string type;
  gmsh::model::getType(2, face, type);
  if (type.starts_with("Plane")) return {};
  std::vector<double> lower, upper, parameters, flat;
  gmsh::model::getParametrizationBounds(2, face, lower, upper);
  for (double u : {0.1, 0.3, 0.5, 0.7, 0.9})
    for (double v : {0.1, 0.3, 0.5, 0.7, 0.9})
      parameters.insert(parameters.end(), {lower[0] + u * (upper[0] - lower[0]), lower[1] + v * (upper[1] - lower[1])});
  gmsh::model::getValue(2, face, parameters, flat);
  return triples(flat);
}

/// Adds the outline of a face; a curve that occurs a second time lies inside the part and is removed.
void add_face(RawPart& part, int face) {
  gmsh::vectorpair boundary;
  gmsh::model::getBoundary({{2, face}}, boundary, false, false, false);
  for (const auto& [dim, tag] : boundary) {
    const int wanted = tag;
    const auto same = std::find_if(part.curves.begin(), part.curves.end(),
                                   [&](const RawCurve& curve) { return curve.tag == wanted; });
    if (same == part.curves.end())
      part.curves.push_back(read_curve(tag));
    else
      part.curves.erase(same);
  }
  const std::vector<Vec3> points = points_on(face);
  part.surface_points.insert(part.surface_points.end(), points.begin(), points.end());
}

}  // namespace

std::set<std::string> physical_names(int dim, int tag) {
  std::set<std::string> names;
  std::vector<int> groups;
  gmsh::model::getPhysicalGroupsForEntity(dim, tag, groups);
  for (int group : groups) {
    std::string name;
    gmsh::model::getPhysicalName(dim, group, name);
    names.insert(name.empty() ? std::to_string(group) : name);
  }
  return names;
}

std::string imported_label(int dim, int tag) {
  std::string path;
  gmsh::model::getEntityName(dim, tag, path);
  return path.substr(path.find_last_of('/') + 1);
}

std::vector<Face> free_faces() {
  gmsh::vectorpair surfaces;
  gmsh::model::getEntities(surfaces, 2);
  std::vector<Face> faces;
  for (const auto& [dim, tag] : surfaces) {
    std::vector<int> solids, curves;
    gmsh::model::getAdjacencies(dim, tag, solids, curves);
    if (!solids.empty()) continue;
    const std::set<std::string> names = physical_names(dim, tag);
    faces.push_back({tag, names.empty() ? imported_label(dim, tag) : *names.begin(), !names.empty()});
  }
  return faces;
}

std::vector<RawPart> parts_from_faces(const std::vector<Face>& faces) {
  std::vector<RawPart> parts;
  for (const Face& face : faces) {
    auto part = std::find_if(parts.begin(), parts.end(),
                             [&](const RawPart& p) { return face.group && p.group && p.label == face.label; });
    if (part == parts.end()) part = parts.insert(parts.end(), RawPart{{}, face.label, face.group, {}, {}, {}});
    add_face(*part, face.tag);
  }
  return parts;
}

}  // namespace reye::cad
