#pragma once
#include <array>
#include <span>

#include "base/linalg.hpp"
#include "mesh/solid/solid_mesh.hpp"

/// Shape functions of facets in space, none negative, adding up to one, and rules of quadrature. Reference shapes:
/// triangle (0,0) (1,0) (0,1), square [-1, 1]^2.
namespace reye::mortar {

using base::Vec2;

/// One number per point of a facet; entries beyond its points are zero.
using FacetValues = std::array<double, mesh::most_facet_nodes>;

/// N_j(xi): hats on tri3, bilinear on quad4, Bernstein polynomials of degree 2 on tri6.
inline FacetValues skin_functions(mesh::FacetKind kind, const Vec2& xi) {
  const double r = xi.x(), s = xi.y(), q = 1.0 - r - s;
  if (kind == mesh::FacetKind::tri3) return {q, r, s};
  if (kind == mesh::FacetKind::quad4)
    return {0.25 * (1 - r) * (1 - s), 0.25 * (1 + r) * (1 - s), 0.25 * (1 + r) * (1 + s), 0.25 * (1 - r) * (1 + s)};
  return {q * q, r * r, s * s, 2 * q * r, 2 * r * s, 2 * s * q};
}

/// dN_j/dr and dN_j/ds, where xi = (r, s).
struct FacetSlopes {
  FacetValues dr, ds;
};

inline FacetSlopes skin_slopes(mesh::FacetKind kind, const Vec2& xi) {
  const double r = xi.x(), s = xi.y(), q = 1.0 - r - s;
  if (kind == mesh::FacetKind::tri3) return {{-1, 1, 0}, {-1, 0, 1}};
  if (kind == mesh::FacetKind::quad4)
    return {{-0.25 * (1 - s), 0.25 * (1 - s), 0.25 * (1 + s), -0.25 * (1 + s)},
            {-0.25 * (1 - r), -0.25 * (1 + r), 0.25 * (1 + r), 0.25 * (1 - r)}};
  return {{-2 * q, 2 * r, 0, 2 * (q - r), 2 * s, -2 * s}, {-2 * q, 0, 2 * s, -2 * r, 2 * r, 2 * (q - s)}};
}

/// f(r, s) = c_0 + c_1 r + c_2 s + c_3 r^2 + c_4 r s + c_5 s^2 of values at the points of a facet: as its shape
/// functions have it, at a fraction of their cost. T: Vec2, Vec3.
template <class T>
struct FacetPolynomial {
  std::array<T, 6> c;

  T at(const Vec2& xi) const {
    const double r = xi.x(), s = xi.y();
    return c[0] + r * (c[1] + r * c[3] + s * c[4]) + s * (c[2] + s * c[5]);
  }
  T dr(const Vec2& xi) const { return c[1] + 2.0 * xi.x() * c[3] + xi.y() * c[4]; }
  T ds(const Vec2& xi) const { return c[2] + xi.x() * c[4] + 2.0 * xi.y() * c[5]; }
};

/// `value(j)`: at point j.
template <class T, class Value>
FacetPolynomial<T> facet_polynomial(mesh::FacetKind kind, Value value) {
  const T a = value(0), b = value(1), c = value(2), zero = T::Zero();
  if (kind == mesh::FacetKind::tri3) return {{a, b - a, c - a, zero, zero, zero}};
  const T d = value(3);
  if (kind == mesh::FacetKind::quad4)
    return {
        {0.25 * (a + b + c + d), 0.25 * (b + c - a - d), 0.25 * (c + d - a - b), zero, 0.25 * (a + c - b - d), zero}};
  const T e = value(4), f = value(5);
  return {{a, 2.0 * (d - a), 2.0 * (f - a), a + b - 2.0 * d, 2.0 * (a - d + e - f), a + c - 2.0 * f}};
}

/// The place of point j of a facet on its reference shape; of a control point that of the edge's middle.
Vec2 reference_place(mesh::FacetKind kind, int j);

/// A point of a rule; the weights of a rule add up to one.
struct RulePlace {
  Vec2 xi;
  double weight;
};

/// Rules on the triangle, exact to degree 2 (3 points), 5 (7 points), 6 (12) and 8 (16; Dunavant 1985).
std::span<const RulePlace> triangle_rule(int degree);

/// A rule over a whole facet; the weights add up to the area of the reference shape. tri3: degree 2; quad4: 3 x 3
/// Gauss; tri6: degree 6.
std::span<const RulePlace> facet_rule(mesh::FacetKind kind);

}  // namespace reye::mortar
