#include "mortar/solid/facet_geometry.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "base/errors.hpp"

namespace reye::mortar {

namespace {

using mesh::Facet;
using mesh::FacetKind;

/// The points beside corner j, against and along the facet's sense; a tangent leads to each.
std::array<int, 2> beside_corner(FacetKind kind, int j) {
  if (kind == FacetKind::tri3) return {(j + 2) % 3, (j + 1) % 3};
  if (kind == FacetKind::quad4) return {(j + 3) % 4, (j + 1) % 4};
  return {3 + (j + 2) % 3, 3 + j};
}

/// The weight of a facet's normal at its point j: the angle between its edges there.
double angle_at(const Facet& facet, const Points3& x, int j) {
  if (j >= mesh::facet_corners(facet.kind)) return std::numbers::pi;
  const auto [before, after] = beside_corner(facet.kind, j);
  const Vec3 a = x[facet.nodes[after]] - x[facet.nodes[j]], b = x[facet.nodes[before]] - x[facet.nodes[j]];
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// What a facet adds to the normal of one of its points.
struct NormalShare {
  int point, group;
  bool faces;
  Vec3 n;
};

std::vector<NormalShare> normal_shares(const Skin& skin, const std::vector<char>& faces) {
  std::vector<NormalShare> shares;
  for (std::size_t f = 0; f < skin.facets.size(); ++f) {
    const Facet& facet = skin.facets[f];
    for (int j = 0; j < facet.count(); ++j) {
      Vec3 n = area_vector_at(facet, skin.x, reference_place(facet.kind, j));
      if (!(n.norm() > 0.0)) n = unit_normal(facet, skin.x);
      shares.push_back({facet.nodes[j], facet.group, faces[f] != 0, angle_at(facet, skin.x, j) * n.normalized()});
    }
  }
  std::stable_sort(shares.begin(), shares.end(), [](const NormalShare& a, const NormalShare& b) {
    return a.point != b.point ? a.point < b.point : a.group < b.group;
  });
  return shares;
}

Vec3 unit_or_zero(const Vec3& n) {
  const double length = n.norm();
  return length > 0.0 ? Vec3(n / length) : Vec3(Vec3::Zero());
}

/// The normal of one point from its shares, sorted by group.
Vec3 mean_of_groups(std::span<const NormalShare> shares) {
  Vec3 facing = Vec3::Zero(), all = Vec3::Zero();
  for (std::size_t i = 0; i < shares.size();) {
    Vec3 sum = Vec3::Zero();
    bool faces = false;
    const int group = shares[i].group;
    for (; i < shares.size() && shares[i].group == group; ++i) {
      sum += shares[i].n;
      faces = faces || shares[i].faces;
    }
    all += unit_or_zero(sum);
    if (faces) facing += unit_or_zero(sum);
  }
  return unit_or_zero(facing.squaredNorm() > 0.0 ? facing : all);
}

}  // namespace

Vec3 area_vector_at(const Facet& facet, const Points3& x, const Vec2& xi) {
  const auto [dr, ds] = skin_slopes(facet.kind, xi);
  Vec3 along_r = Vec3::Zero(), along_s = Vec3::Zero();
  for (int j = 0; j < facet.count(); ++j) {  // from one point, so that nothing cancels
    const Vec3 from = x[facet.nodes[j]] - x[facet.nodes[0]];
    along_r += dr[j] * from;
    along_s += ds[j] * from;
  }
  return along_r.cross(along_s);
}

Vec3 unit_normal(const Facet& facet, const Points3& x) {
  Vec3 sum = Vec3::Zero();
  if (facet.kind != FacetKind::tri6)  // constant, or bilinear about its mean
    sum = area_vector_at(facet, x, {0.0, 0.0});
  else
    for (const auto& [xi, weight] : triangle_rule(2)) sum += weight * area_vector_at(facet, x, xi);
  const double length = sum.norm();
  if (!(length > 0.0)) {
    const Vec3 at = x[facet.nodes[0]];
    throw base::MeshError("a facet of a contact has no area, at x = " + std::to_string(at.x()) +
                          ", y = " + std::to_string(at.y()) + ", z = " + std::to_string(at.z()) + " mm");
  }
  return sum / length;
}

Points3 facet_normals(const Skin& skin) {
  Points3 normals;
  normals.reserve(skin.facets.size());
  for (const Facet& facet : skin.facets) normals.push_back(unit_normal(facet, skin.x));
  return normals;
}

base::Vector facet_areas(const Skin& skin) {
  base::Vector areas = base::Vector::Zero(static_cast<Eigen::Index>(skin.facets.size()));
  for (std::size_t f = 0; f < skin.facets.size(); ++f)
    for (const auto& [xi, weight] : facet_rule(skin.facets[f].kind))
      areas[static_cast<Eigen::Index>(f)] += weight * area_vector_at(skin.facets[f], skin.x, xi).norm();
  return areas;
}

base::Vector nodal_areas(const Skin& skin) {
  base::Vector areas = base::Vector::Zero(static_cast<Eigen::Index>(skin.x.size()));
  for (const Facet& facet : skin.facets)
    for (const auto& [xi, weight] : facet_rule(facet.kind)) {
      const auto N = skin_functions(facet.kind, xi);
      const double area = weight * area_vector_at(facet, skin.measured(), xi).norm();
      for (int j = 0; j < facet.count(); ++j) areas[facet.nodes[j]] += N[j] * area;
    }
  return areas;
}

Points3 nodal_normals(const Skin& skin, const std::vector<char>& faces) {
  Points3 normals(skin.x.size(), Vec3::Zero());
  const auto shares = normal_shares(skin, faces);
  for (std::size_t i = 0; i < shares.size();) {
    std::size_t end = i;
    while (end < shares.size() && shares[end].point == shares[i].point) ++end;
    normals[shares[i].point] = mean_of_groups(std::span(shares).subspan(i, end - i));
    i = end;
  }
  return normals;
}

}  // namespace reye::mortar
