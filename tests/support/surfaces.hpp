#pragma once
#include <cmath>
#include <random>

#include "mortar/integrate.hpp"

/// Facing polylines and their mortar integrals added up, for tests of mortar, contact and solver.
namespace reye::support {

using base::Matrix;
using base::Points;
using base::Vec2;
using base::Vector;

/// A repeatable number in [-1, 1].
inline double noise(std::mt19937& random) {
  return 2.0 * static_cast<double>(random()) / static_cast<double>(std::mt19937::max()) - 1.0;
}

inline Vec2 turned(const Vec2& x, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * x.x() - s * x.y(), s * x.x() + c * x.y()};
}

/// The secondary side has its body below and runs from x = 3 to x = 1; the primary side lies above it.
struct FacingOptions {
  int secondary = 5;  ///< number of facets
  int primary = 7;
  int secondary_order = 1;
  int primary_order = 1;
  double bend = 0.1;     ///< height of the curve that both follow [mm]
  double jitter = 0.25;  ///< nodes leave even spacing by this share of it
  double gap = 0.02;
  double from = -0.1;  ///< ends of the primary side in units of the secondary one, 0 at x = 1
  double to = 1.1;
  double angle = 0.0;    ///< current positions are those on X, strained and then turned by this [rad]
  double strain = 0.02;  ///< scatter of displacements [mm]
  unsigned seed = 1;
  base::Analysis analysis = base::Analysis::plane_strain;
  base::Kinematics measure = base::Kinematics::small;
};

struct Facing {
  mortar::Surface secondary, primary;
  Points xs, xm;
  base::Analysis analysis = base::Analysis::plane_strain;
  base::Kinematics measure = base::Kinematics::small;
};

/// With order 2 every second point is the middle of a curved facet.
inline mortar::Surface polyline(const Points& X, base::Analysis analysis = base::Analysis::plane_strain,
                                int order = 1) {
  mesh::Chain chain;
  for (std::size_t i = 0; i < X.size(); ++i) chain.push_back(static_cast<int>(i));
  std::vector<int> nodes;
  return mortar::make_surface(X, {chain}, analysis, nodes, order);
}

inline Facing facing(const FacingOptions& o) {
  std::mt19937 random(o.seed);
  const auto line = [&](int facets, int order, double first, double last, double height) {
    Points X;
    const int steps = facets * order;
    for (int i = 0; i <= steps; ++i) {
      const double shift = i == 0 || i == steps ? 0.0 : o.jitter / order * noise(random);
      const double t = first + (last - first) * (i + shift) / steps;
      X.push_back({1.0 + 2.0 * t, o.bend * std::sin(3.0 * t + o.seed) + height});
    }
    return X;
  };
  const auto moved = [&](Points X) {
    for (Vec2& x : X) x = turned(x + o.strain * Vec2(noise(random), noise(random)), o.angle);
    return X;
  };
  Facing f;
  f.secondary = polyline(line(o.secondary, o.secondary_order, 1.0, 0.0, 0.0), o.analysis, o.secondary_order);
  f.primary = polyline(line(o.primary, o.primary_order, o.from, o.to, o.gap), o.analysis, o.primary_order);
  f.xs = moved(f.secondary.X);
  f.xm = moved(f.primary.X);
  f.analysis = o.analysis;
  f.measure = o.measure;
  return f;
}

/// The placement of both sides with no motion in the increment and no cut node; `f` must outlive it.
inline mortar::Placement placed(const Facing& f) {
  mortar::Placement p;
  p.secondary = &f.secondary;
  p.primary = &f.primary;
  p.xs = p.xs_before = f.xs;
  p.xm = p.xm_before = f.xm;
  p.cut.assign(f.xs.size(), 0);
  p.analysis = f.analysis;
  p.measure = f.measure;
  p.search = 0.5;
  return p;
}

/// The integrals of one facet in the order of the rows of FacetRecord::slope.
inline std::vector<double> outputs(const mortar::FacetRecord& r) {
  std::vector<double> v(r.outputs());
  for (int j = 0; j < r.count; ++j) {
    v[r.D(j)] = r.value.D[j];
    for (int k = 0; k < r.count; ++k)
      if (k != j) v[r.off(j, k)] = r.value.off[j][k];
    v[r.gap(j)] = r.value.gap[j];
    v[r.offset(j)] = r.value.offset[j].x;
    v[r.offset(j) + 1] = r.value.offset[j].y;
    v[r.drift(j)] = r.value.drift[j].x;
    v[r.drift(j) + 1] = r.value.drift[j].y;
    for (int l = 0; l < static_cast<int>(r.primaries.size()); ++l) {
      v[r.M(j, l)] = r.value.M[j][l];
      v[r.cover(j, l)] = r.value.cover[j][l];
    }
  }
  return v;
}

/// Integrals added up per secondary node (rows) and primary node.
struct Sums {
  Vector D, gap;
  Matrix off, offset, drift, M, cover;  ///< off: rows and columns secondary nodes

  Vector flat() const {
    Vector all(D.size() * (6 + D.size() + 2 * M.cols()));
    all << D, off.reshaped(), gap, offset.reshaped(), drift.reshaped(), M.reshaped(), cover.reshaped();
    return all;
  }
};

/// Adds up `of(record)`, a number per output: values, or derivatives along a direction.
template <class Of>
Sums added(const mortar::Placement& p, const std::vector<mortar::FacetRecord>& records, Of of) {
  const int ns = p.secondary->node_count(), nm = p.primary->node_count();
  Sums s{Vector::Zero(ns),    Vector::Zero(ns),     Matrix::Zero(ns, ns), Matrix::Zero(ns, 2),
         Matrix::Zero(ns, 2), Matrix::Zero(ns, nm), Matrix::Zero(ns, nm)};
  for (const auto& r : records) {
    const auto v = of(r);
    const auto& facet = p.secondary->facets[r.facet];
    for (int j = 0; j < r.count; ++j) {
      const int node = facet[j];
      s.D[node] += v[r.D(j)];
      for (int k = 0; k < r.count; ++k)
        if (k != j) s.off(node, facet[k]) += v[r.off(j, k)];
      s.gap[node] += v[r.gap(j)];
      s.offset.row(node) += Vec2(v[r.offset(j)], v[r.offset(j) + 1]).transpose();
      s.drift.row(node) += Vec2(v[r.drift(j)], v[r.drift(j) + 1]).transpose();
      for (int l = 0; l < static_cast<int>(r.primaries.size()); ++l) {
        s.M(node, r.primaries[l]) += v[r.M(j, l)];
        s.cover(node, r.primaries[l]) += v[r.cover(j, l)];
      }
    }
  }
  return s;
}

inline Sums integrals(const mortar::Placement& p) {
  mortar::Integrator integrator;
  return added(p, integrator.values(p), outputs);
}

/// Moves both sides along `direction` (secondary dofs first).
inline mortar::Placement moved_along(mortar::Placement p, const Vector& direction, double step) {
  for (std::size_t k = 0; k < p.xs.size(); ++k) p.xs[k] += step * direction.segment<2>(2 * k);
  for (std::size_t k = 0; k < p.xm.size(); ++k) p.xm[k] += step * direction.segment<2>(p.secondary_dofs() + 2 * k);
  return p;
}

inline Vector random_direction(int size, unsigned seed) {
  std::mt19937 random(seed);
  Vector d(size);
  for (double& x : d) x = noise(random);
  return d;
}

}  // namespace reye::support
