#include "fem/assemble_loads.hpp"

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "fem/element.hpp"
#include "mesh/measure.hpp"
#include "mesh/quadratic_edge.hpp"

namespace reye::fem {

using base::Vector;
using mesh::Chain;

namespace {

Vector zero(const Mesh& mesh) { return Vector::Zero(2 * static_cast<Eigen::Index>(mesh.X.size())); }

/// Part [a, b] of a facet, in its own coordinate from 0 (first node) to 1 (second).
struct FacetPart {
  int first, second;
  double a, b;
};

bool measured_from_end(const Mesh& mesh, const Chain& chain) {
  const Vec2 &first = mesh.X[chain.front()], &last = mesh.X[chain.back()];
  return last.x() < first.x() || (last.x() == first.x() && last.y() < first.y());
}

/// The interval by the length from the first node of the chain, of length `total`.
std::array<double, 2> along_chain(const Mesh& mesh, const Chain& chain, std::array<double, 2> interval, double total) {
  if (measured_from_end(mesh, chain)) interval = {total - interval[1], total - interval[0]};
  return interval;
}

std::vector<FacetPart> loaded_parts(const Mesh& mesh, const Chain& chain, std::array<double, 2> interval) {
  std::vector<FacetPart> parts;
  double s = 0.0;
  for (size_t k = 0; k + 1 < chain.size(); ++k) {
    const double h = (mesh.X[chain[k + 1]] - mesh.X[chain[k]]).norm();
    const double a = std::clamp((interval[0] - s) / h, 0.0, 1.0), b = std::clamp((interval[1] - s) / h, 0.0, 1.0);
    if (b > a) parts.push_back({chain[k], chain[k + 1], a, b});
    s += h;
  }
  return parts;
}

/// Two Gauss points: exact for N times a constant traction times r.
void add_part(const Mesh& mesh, Analysis analysis, const BoundaryLoad& load, const FacetPart& part, Vector& f) {
  const Vec2 &X1 = mesh.X[part.first], &X2 = mesh.X[part.second];
  const double h = (X2 - X1).norm();
  const Vec2 t = load.traction_MPa - load.pressure_MPa * base::right_of((X2 - X1) / h);
  for (double sign : {-1.0, 1.0}) {
    const double xi = 0.5 * (part.a + part.b) + sign * 0.5 * (part.b - part.a) / std::sqrt(3.0);
    const double weight = 0.5 * (part.b - part.a) * h * base::out_of_plane(analysis, (1 - xi) * X1.x() + xi * X2.x());
    f.segment<2>(2 * part.first) += (1 - xi) * weight * t;
    f.segment<2>(2 * part.second) += xi * weight * t;
  }
}

mesh::QuadraticEdge edge_at(const Mesh& mesh, const Chain& chain, size_t k) {
  return {mesh.X[chain[k]], mesh.X[chain[k + 1]], mesh.X[chain[k + 2]]};
}

/// The same on a quadratic edge, from parameter a to b in [-1, 1]. Five Gauss points: exact for the pressure.
void add_part(const Mesh& mesh, Analysis analysis, const BoundaryLoad& load, const Chain& chain, size_t k, double a,
              double b, Vector& f) {
  const mesh::QuadraticEdge edge = edge_at(mesh, chain, k);
  for (const auto& [point, share] : mesh::edge_rule()) {
    const double xi = 0.5 * (a + b) + 0.5 * (b - a) * point;
    const Vec2 tangent = edge.tangent(xi);
    const Vec2 t_ds = load.traction_MPa * tangent.norm() - load.pressure_MPa * base::right_of(tangent);
    const double weight = 0.5 * (b - a) * share * base::out_of_plane(analysis, edge.at(xi).x());
    for (int j = 0; j < 3; ++j) f.segment<2>(2 * chain[k + j]) += mesh::QuadraticEdge::shape(xi)[j] * weight * t_ds;
  }
}

/// Adds the load on one chain; false when the interval meets none of it.
bool add_chain(const Mesh& mesh, Analysis analysis, const BoundaryLoad& load, const Chain& chain, Vector& f) {
  const int order = mesh::order(mesh.kind);
  const double total = mesh::length(mesh.X, chain, order);
  const std::array<double, 2> whole{-1.0, total + 1.0};
  const std::array<double, 2> interval = along_chain(mesh, chain, load.interval_mm.value_or(whole), total);
  bool met = false;
  if (order == 1) {
    for (const FacetPart& part : loaded_parts(mesh, chain, interval)) {
      add_part(mesh, analysis, load, part, f);
      met = true;
    }
    return met;
  }
  double s = 0.0;
  for (size_t k = 0; k + 2 < chain.size(); k += 2) {
    const mesh::QuadraticEdge edge = edge_at(mesh, chain, k);
    const double a = edge.parameter_at(interval[0] - s), b = edge.parameter_at(interval[1] - s);
    s += edge.length();
    if (!(b > a)) continue;
    add_part(mesh, analysis, load, chain, k, a, b, f);
    met = true;
  }
  return met;
}

}  // namespace

const mesh::Boundary& boundary_of(const Mesh& mesh, const std::string& name, const std::string& key) {
  const auto found = mesh.boundaries.find(name);
  if (found == mesh.boundaries.end()) throw base::InputError({{key, name, "names no boundary of this body"}});
  return found->second;
}

Vector load_vector(const Mesh& mesh, Analysis analysis, const BoundaryLoad& load) {
  Vector f = zero(mesh);
  bool met = false;
  for (const Chain& chain : boundary_of(mesh, load.edge, "load." + load.name + ".edge"))
    met = add_chain(mesh, analysis, load, chain, f) || met;
  if (!met) throw base::InputError({{"load." + load.name + ".interval_mm", "", "meets no part of the edge"}});
  return f;
}

Vector load_vector(const Mesh& mesh, Analysis, const PointLoad& load) {
  Vector f = zero(mesh);
  f.segment<2>(2 * nearest_node(mesh, load.point_mm)) = load.force_N_per_mm;
  return f;
}

Vector load_vector(const Mesh& mesh, Analysis analysis, const BodyForce& load) {
  Vector f = zero(mesh);
  for (int cell = 0; cell < mesh.cell_count(); ++cell)
    for (const VolumePoint& p : volume_points(mesh, cell, analysis))
      for (int a = 0; a < mesh::nodes_per_cell(mesh.kind); ++a)
        f.segment<2>(2 * mesh.cells[cell][a]) += p.N[a] * p.volume * load.force_N_per_mm3;
  return f;
}

int nearest_node(const Mesh& mesh, const Vec2& point) {
  const auto nearer = [&](const Vec2& a, const Vec2& b) { return (a - point).squaredNorm() < (b - point).squaredNorm(); };
  return static_cast<int>(std::min_element(mesh.X.begin(), mesh.X.end(), nearer) - mesh.X.begin());
}

}  // namespace reye::fem
