#include "cad/gmsh/section.hpp"

#include <gmsh.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/errors.hpp"
#include "cad/gmsh/session.hpp"
#include "cad/part/text.hpp"

namespace reye::cad {

namespace {

namespace occ = gmsh::model::occ;

std::string label_of(int solid) {
  const std::set<std::string> names = physical_names(3, solid);
  return names.empty() ? imported_label(3, solid) : *names.begin();
}

/// A square of the plane, larger than the solid's share of it.
int plane_face(const Section& section, int solid) {
  Vec3 low, high;
  occ::getBoundingBox(3, solid, low.x(), low.y(), low.z(), high.x(), high.y(), high.z());
  const Vec3 normal = section.normal.stableNormalized();
  const Vec3 middle = 0.5 * (low + high);
  const Vec3 centre = middle + (section.point_mm - middle).dot(normal) * normal;
  const Vec3 e1 = normal.unitOrthogonal() * (high - low).norm();
  const Vec3 e2 = normal.cross(e1);
  std::vector<int> points, lines;
  for (const Vec3& p : {Vec3(centre - e1 - e2), Vec3(centre + e1 - e2), Vec3(centre + e1 + e2), Vec3(centre - e1 + e2)})
    points.push_back(occ::addPoint(p.x(), p.y(), p.z()));
  for (int k = 0; k < 4; ++k) lines.push_back(occ::addLine(points[k], points[(k + 1) % 4]));
  return occ::addPlaneSurface({occ::addCurveLoop(lines)});
}

std::vector<Face> cut(const Section& section, int solid, const std::string& label) {
  gmsh::vectorpair pieces;
  std::vector<gmsh::vectorpair> origins;
  occ::intersect({{3, solid}}, {{2, plane_face(section, solid)}}, pieces, origins, -1, false, true);
  std::vector<Face> faces;
  for (const auto& [dim, tag] : pieces)
    if (dim == 2) faces.push_back({tag, label, false});
  return faces;
}

/// Smallest and largest p . normal of the solid [mm]: the box of a copy that is turned until the normal is z.
std::pair<double, double> extent_along(const Vec3& normal, int solid) {
  gmsh::vectorpair copy;
  occ::copy({{3, solid}}, copy);
  const Vec3 about = normal.cross(Vec3::UnitZ());
  const double sine = about.norm();
  const Vec3 axis = sine > 0.0 ? Vec3(about / sine) : Vec3::UnitX();
  occ::rotate(copy, 0, 0, 0, axis.x(), axis.y(), axis.z(), std::atan2(sine, normal.z()));
  Vec3 low, high;
  occ::getBoundingBox(3, copy[0].second, low.x(), low.y(), low.z(), high.x(), high.y(), high.z());
  occ::remove(copy, true);
  const auto rounded = [](double z) { return std::round(z * 1e6) * 1e-6; };  // boxes are padded by 1e-7
  return {rounded(low.z()), rounded(high.z())};
}

[[noreturn]] void refuse_miss(const Section& section, const gmsh::vectorpair& solids,
                              const std::vector<std::string>& labels, const std::string& file) {
  constexpr std::size_t shown = 12;
  const Vec3 normal = section.normal.stableNormalized(), &p = section.point_mm;
  std::string list;
  for (std::size_t k = 0; k < std::min(shown, solids.size()); ++k) {
    const auto [low, high] = extent_along(normal, solids[k].second);
    list += (k ? ", " : "") + (labels[k].empty() ? "solid " + std::to_string(k + 1) : "'" + labels[k] + "'") +
            " from " + text(low) + " to " + text(high);
  }
  if (solids.size() > shown) list += " and " + std::to_string(solids.size() - shown) + " more";
  throw base::InputError({{"section.point_mm", "[" + text(p.x()) + ", " + text(p.y()) + ", " + text(p.z()) + "]",
                           "the plane, at " + text(p.dot(normal)) + " mm along its normal, misses every solid of " +
                               std::filesystem::path(file).filename().string() + ": " + list}});
}

}  // namespace

bool can_be_cut() {
  gmsh::vectorpair all, known;
  gmsh::model::getEntities(all, 3);
  occ::getEntities(known, 3);
  return all == known;
}

std::vector<Face> faces_of_section(const Section& section, const std::string& file) {
  const Silence silence;
  gmsh::vectorpair solids;
  gmsh::model::getEntities(solids, 3);
  std::vector<std::string> labels;
  for (const auto& [dim, solid] : solids) labels.push_back(label_of(solid));
  std::vector<Face> faces;
  for (std::size_t k = 0; k < solids.size(); ++k)
    for (Face& face : cut(section, solids[k].second, labels[k])) faces.push_back(std::move(face));
  if (faces.empty()) refuse_miss(section, solids, labels, file);
  occ::synchronize();
  return faces;
}

}  // namespace reye::cad
