#include "adapt/solid/keep_content.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "adapt/solid/skin_strip.hpp"
#include "mesh/solid/solid_measure.hpp"
#include "mortar/solid/facet_functions.hpp"

namespace reye::adapt {

namespace {

/// Sum of the area shares of each node over facets; zero at other nodes.
Points3 summed_shares(const Points3& X, const std::vector<mesh::Facet>& facets) {
  Points3 sums(X.size(), Vec3::Zero());
  for (const mesh::Facet& facet : facets) {
    const FacetPoints shares = area_shares(facet.kind, points_of(X, facet));
    for (int a = 0; a < facet.count(); ++a) sums[facet.nodes[a]] += shares.col(a);
  }
  return sums;
}

}  // namespace

void keep_heights(const SkinLocator& other, Points3& X, const std::vector<PatchTriangle>& triangles,
                  const std::vector<char>& movable) {
  Points3 normals(X.size(), Vec3::Zero());
  std::vector<double> height(X.size(), 0.0), area(X.size(), 0.0);
  for (const auto& nodes : triangles) {
    if (std::none_of(nodes.begin(), nodes.end(), [&](int node) { return movable[node]; })) continue;
    const Vec3 &a = X[nodes[0]], &b = X[nodes[1]], &c = X[nodes[2]];
    const Vec3 doubled = (b - a).cross(c - a), n = doubled.normalized();
    for (const auto& [xi, weight] : mortar::triangle_rule(5)) {
      const double N[3]{1.0 - xi.sum(), xi.x(), xi.y()};
      const Vec3 p = N[0] * a + N[1] * b + N[2] * c;
      const double h = (other.nearest(p).at - p).dot(n);
      for (int k = 0; k < 3; ++k) {
        height[nodes[k]] += weight * N[k] * doubled.norm() * h;
        area[nodes[k]] += weight * N[k] * doubled.norm();
      }
    }
    for (int node : nodes) normals[node] += doubled;
  }
  for (std::size_t node = 0; node < X.size(); ++node)
    if (movable[node] && area[node] > 0.0) X[node] += height[node] / area[node] * normals[node].normalized();
}

long double content_of(const Points3& X, const std::vector<mesh::Facet>& skin) {
  const Vec3 o = X[skin.front().nodes[0]];
  long double sum = 0.0L;
  for (const mesh::Facet& facet : skin) {
    double part = 0.0;
    for (const auto& [xi, weight] : mesh::area_rule(facet.kind)) {
      const Vec3 x = mesh::corners_of(X, facet) * mesh::shape_functions(facet.kind, xi);
      part += weight / 3.0 * (x - o).dot(mesh::normal_at(X, facet, xi));
    }
    sum += part;
  }
  return sum;
}

double restore_content(Points3& X, const std::vector<mesh::Facet>& skin, const std::vector<char>& movable,
                       long double content) {
  constexpr int most_steps = 10;
  double length = 0.0, last = std::numeric_limits<double>::infinity();
  for (int step = 0; step < most_steps; ++step) {
    const double missing = static_cast<double>(content - content_of(X, skin));
    if (missing == 0.0 || !(std::abs(missing) < last)) break;  // round-off reached
    last = std::abs(missing);
    const Points3 shares = summed_shares(X, skin);
    double area = 0.0;
    for (std::size_t node = 0; node < X.size(); ++node)
      if (movable[node]) area += shares[node].norm();
    if (!(area > 0.0)) break;
    length += missing / area;
    for (std::size_t node = 0; node < X.size(); ++node)
      if (movable[node]) X[node] += missing / area * shares[node].normalized();
  }
  return length;
}

}  // namespace reye::adapt
