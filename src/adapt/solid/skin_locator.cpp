#include "adapt/solid/skin_locator.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <stdexcept>
#include <vector>

#include "mortar/solid/facet_functions.hpp"

namespace reye::adapt {

namespace {

using NearKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using NearTriangle = NearKernel::Triangle_3;
using NearPrimitive = CGAL::AABB_triangle_primitive<NearKernel, std::vector<NearTriangle>::const_iterator>;
using NearTree = CGAL::AABB_tree<CGAL::AABB_traits<NearKernel, NearPrimitive>>;

NearKernel::Point_3 near_point(const Vec3& x) { return {x.x(), x.y(), x.z()}; }

/// A triangle of a facet by the reference coordinates of its corners.
struct ReferenceTriangle {
  std::array<Vec2, 3> xi;
};

std::vector<ReferenceTriangle> reference_triangles(mesh::FacetKind kind) {
  if (kind == mesh::FacetKind::tri3) return {{{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)}}};
  if (kind == mesh::FacetKind::quad4)
    return {{{Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1)}}, {{Vec2(-1, -1), Vec2(1, 1), Vec2(-1, 1)}}};
  constexpr int n = 4;
  std::vector<ReferenceTriangle> all;
  const auto at = [&](int i, int j) { return Vec2(1.0 * i / n, 1.0 * j / n); };
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      all.push_back({{at(i, j), at(i + 1, j), at(i, j + 1)}});
      if (i + j + 1 < n) all.push_back({{at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}});
    }
  return all;
}

/// The reference coordinates kept within the reference shape.
Vec2 kept_within(mesh::FacetKind kind, Vec2 xi) {
  if (kind == mesh::FacetKind::quad4) return xi.cwiseMax(-1.0).cwiseMin(1.0);
  if (const double over = xi.sum() - 1.0; over > 0.0) xi -= Vec2::Constant(0.5 * over);
  xi = xi.cwiseMax(0.0);
  return xi.sum() > 1.0 ? Vec2(xi / xi.sum()) : xi;
}

Eigen::Matrix<double, 3, 2> tangents_at(const mortar::Skin& skin, int facet, const Vec2& xi) {
  const auto& f = skin.facets[facet];
  const auto slopes = mortar::skin_slopes(f.kind, xi);
  Eigen::Matrix<double, 3, 2> J = Eigen::Matrix<double, 3, 2>::Zero();
  for (int a = 0; a < f.count(); ++a) {
    J.col(0) += slopes.dr[a] * skin.x[f.nodes[a]];
    J.col(1) += slopes.ds[a] * skin.x[f.nodes[a]];
  }
  return J;
}

SkinFoot foot_at(const mortar::Skin& skin, int facet, const Vec2& xi, const Vec3& p) {
  const Vec3 at = place_on(skin, facet, xi);
  return {facet, xi, at, (at - p).norm()};
}

/// From a place of a facet on to the nearest one of it.
SkinFoot refined(const mortar::Skin& skin, SkinFoot best, const Vec3& p) {
  Vec2 xi = best.xi;
  for (int step = 0; step < 20; ++step) {
    const auto J = tangents_at(skin, best.facet, xi);
    const Eigen::Matrix2d metric = J.transpose() * J;
    if (!(metric.determinant() > 0.0)) break;
    const Vec2 next = kept_within(skin.facets[best.facet].kind,
                                  xi + metric.inverse() * (J.transpose() * (p - place_on(skin, best.facet, xi))));
    const double change = (next - xi).norm();
    xi = next;
    if (const SkinFoot foot = foot_at(skin, best.facet, xi, p); foot.distance < best.distance) best = foot;
    if (change < 1e-14) break;
  }
  return best;
}

}  // namespace

struct SkinLocator::Tree {
  const mortar::Skin& skin;
  std::vector<NearTriangle> triangles;
  std::vector<std::pair<int, ReferenceTriangle>> of;  ///< facet, and which part of it
  NearTree tree;
};

SkinLocator::SkinLocator(const mortar::Skin& skin) : tree_(new Tree{skin, {}, {}, {}}) {
  if (skin.facets.empty()) throw std::logic_error("a surface without facets has no nearest place");
  for (int f = 0; f < static_cast<int>(skin.facets.size()); ++f)
    for (const ReferenceTriangle& part : reference_triangles(skin.facets[f].kind)) {
      const auto corner = [&](int k) { return near_point(place_on(skin, f, part.xi[k])); };
      tree_->triangles.emplace_back(corner(0), corner(1), corner(2));
      tree_->of.emplace_back(f, part);
    }
  tree_->tree.insert(tree_->triangles.cbegin(), tree_->triangles.cend());
  tree_->tree.build();
}

SkinLocator::~SkinLocator() = default;
SkinLocator::SkinLocator(SkinLocator&&) noexcept = default;

SkinFoot SkinLocator::nearest(const Vec3& p) const {
  const auto [point, primitive] = tree_->tree.closest_point_and_primitive(near_point(p));
  const auto place = primitive - tree_->triangles.cbegin();
  const auto& [facet, part] = tree_->of[place];
  const auto& corners = tree_->triangles[place];
  const auto vec = [](const NearKernel::Point_3& q) { return Vec3(q.x(), q.y(), q.z()); };
  const Vec3 o = vec(corners[0]), a = vec(corners[1]) - o, b = vec(corners[2]) - o, at = vec(point) - o, n = a.cross(b);
  const double r = n.dot(at.cross(b)) / n.squaredNorm(), s = n.dot(a.cross(at)) / n.squaredNorm();
  const Vec2 xi = part.xi[0] + r * (part.xi[1] - part.xi[0]) + s * (part.xi[2] - part.xi[0]);
  const mesh::FacetKind kind = tree_->skin.facets[facet].kind;
  const SkinFoot foot = foot_at(tree_->skin, facet, kept_within(kind, xi), p);
  return kind == mesh::FacetKind::tri3 ? foot : refined(tree_->skin, foot, p);
}

Vec3 place_on(const mortar::Skin& skin, int facet, const Vec2& xi) {
  const auto& f = skin.facets[facet];
  const auto N = mortar::skin_functions(f.kind, xi);
  Vec3 x = Vec3::Zero();
  for (int a = 0; a < f.count(); ++a) x += N[a] * skin.x[f.nodes[a]];
  return x;
}

}  // namespace reye::adapt
