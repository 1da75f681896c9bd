#include "adapt/solid/skin_strip.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "mortar/solid/facet_functions.hpp"

namespace reye::adapt {

namespace {

/// A point of quadrature of a facet with its functions there.
struct FacetSample {
  double weight;
  mesh::FacetValues N, share;
  mesh::FacetGradients dN;
};

/// Exact for the products of normals (degree 2) with N (2) on tri6, of bilinear ones on quad4.
std::vector<FacetSample> sampled_facet(mesh::FacetKind kind) {
  std::vector<FacetSample> samples;
  for (const auto& [xi, weight] : mesh::area_rule(kind)) {
    const auto share = mortar::skin_functions(kind, xi);
    samples.push_back(
        {weight, mesh::shape_functions(kind, xi), mesh::FacetValues(share.data()), mesh::shape_gradients(kind, xi)});
  }
  return samples;
}

const std::vector<FacetSample>& samples_of(mesh::FacetKind kind) {
  using enum mesh::FacetKind;
  static const std::vector<FacetSample> triangle = sampled_facet(tri3), square = sampled_facet(quad4),
                                        curved = sampled_facet(tri6);
  return kind == tri3 ? triangle : kind == quad4 ? square : curved;
}

Vec3 normal_of(const FacetPoints& x, const FacetSample& sample) {
  const Eigen::Matrix<double, 3, 2> tangents = x * sample.dN;
  return tangents.col(0).cross(tangents.col(1));
}

/// Unit normal at a node.
Vec3 normal_at_node(mesh::FacetKind kind, const FacetPoints& x, int a) {
  const Eigen::Matrix<double, 3, 2> tangents = x * mesh::shape_gradients(kind, mesh::reference_node(kind, a));
  return tangents.col(0).cross(tangents.col(1)).normalized();
}

}  // namespace

FacetPoints points_of(const Points3& values, const mesh::Facet& facet) {
  FacetPoints points = FacetPoints::Zero();
  for (int a = 0; a < facet.count(); ++a) points.col(a) = values[facet.nodes[a]];
  return points;
}

double swept_volume(mesh::FacetKind kind, const FacetPoints& x, const FacetPoints& d) {
  const FacetPoints half = x + 0.5 * d, whole = x + d;
  double sum = 0.0;
  for (const FacetSample& sample : samples_of(kind)) {
    const Vec3 n = (normal_of(x, sample) + 4.0 * normal_of(half, sample) + normal_of(whole, sample)) / 6.0;
    sum -= sample.weight * Vec3(d * sample.N).dot(n);
  }
  return sum;
}

double strip_volume(const Points3& X, const std::vector<mesh::Facet>& facets, const Points3& step, double factor) {
  double sum = 0.0;
  for (const mesh::Facet& facet : facets)
    sum += swept_volume(facet.kind, points_of(X, facet), factor * points_of(step, facet));
  return sum;
}

double strip_between(const Points3& before, const Points3& after, const std::vector<mesh::Facet>& facets) {
  double sum = 0.0;
  for (const mesh::Facet& facet : facets) {
    const FacetPoints x = points_of(before, facet);
    sum += swept_volume(facet.kind, x, points_of(after, facet) - x);
  }
  return sum;
}

FacetPoints area_shares(mesh::FacetKind kind, const FacetPoints& x) {
  FacetPoints shares = FacetPoints::Zero();
  if (kind != mesh::FacetKind::tri6) {
    for (const FacetSample& sample : samples_of(kind))
      shares += sample.weight * normal_of(x, sample) * sample.share.transpose();
    return shares;
  }
  mesh::FacetValues areas = mesh::FacetValues::Zero();
  for (const FacetSample& sample : samples_of(kind))
    areas += sample.weight * normal_of(x, sample).norm() * sample.share;
  for (int a = 0; a < mesh::facet_nodes(kind); ++a) shares.col(a) = areas[a] * normal_at_node(kind, x, a);
  return shares;
}

double smallest_height(mesh::FacetKind kind, const FacetPoints& x) {
  const int n = mesh::facet_corners(kind);
  double longest = 0.0;
  for (int a = 0; a < n; ++a) longest = std::max(longest, (x.col((a + 1) % n) - x.col(a)).norm());
  const Vec3 doubled = n == 4 ? Vec3((x.col(2) - x.col(0)).cross(x.col(3) - x.col(1)))
                              : Vec3((x.col(1) - x.col(0)).cross(x.col(2) - x.col(0)));
  const double height = (n == 4 ? 0.5 : 1.0) * doubled.norm() / longest;
  return kind == mesh::FacetKind::tri6 ? 0.5 * height : height;
}

}  // namespace reye::adapt
