#include "body/nonlinear_equations.hpp"

#include <algorithm>
#include <utility>

#include "fem/assemble_loads.hpp"

namespace reye::body {

using base::SparseMatrix;

namespace {

NonlinearLoad make_load(const mesh::Mesh& mesh, const BodyInput& input, fem::BoundaryLoad load) {
  if (input.kinematics == base::Kinematics::small || load.pressure_MPa == 0.0)
    return {fem::load_vector(mesh, input.analysis, load), {}};
  fem::FollowerPressure pressure(mesh, input.analysis, load);
  load.pressure_MPa = 0.0;
  return {fem::load_vector(mesh, input.analysis, load), std::move(pressure)};
}

std::vector<char> cells_at_supports(const mesh::Mesh& mesh, const Columns& columns) {
  std::vector<char> of_support(static_cast<std::size_t>(columns.interior + columns.retained), 0);
  for (const auto& support : columns.supports)
    of_support[static_cast<std::size_t>(columns.interior + support.column)] = 1;
  std::vector<char> supported(mesh.cells.size(), 0);
  for (std::size_t cell = 0; cell < supported.size(); ++cell)
    for (int a = 0; a < mesh::nodes_per_cell(mesh.kind); ++a)
      for (const Term& term : columns.terms[static_cast<std::size_t>(mesh.cells[cell][a])])
        supported[cell] |= of_support[static_cast<std::size_t>(term.column)];
  return supported;
}

template <class DeadLoad>
NonlinearLoad make_load(const mesh::Mesh& mesh, const BodyInput& input, const DeadLoad& load) {
  return {fem::load_vector(mesh, input.analysis, load), {}};
}

}  // namespace

NonlinearEquations::NonlinearEquations(ShapePtr s, const BodyInput& input)
    : shape(std::move(s)),
      name(input.name),
      solid{input.material, input.analysis, input.kinematics, input.b_bar},
      columns(number_columns(shape->mesh, input)),
      pattern(shape->mesh) {
  const Matrix T = columns.translations(input.analysis);
  translation = Translation(T);
  outer = Translation(T.bottomRows(columns.retained));
  for_each_load(input, [&](const auto& load) {
    names.push_back({load.name, load.history});
    loads.push_back(make_load(shape->mesh, input, load));
  });
  supported = cells_at_supports(shape->mesh, columns);
}

bool NonlinearEquations::symmetric() const {
  const auto follows = [](const NonlinearLoad& load) { return load.pressure.has_value(); };
  return solid.symmetric(mesh().kind) && std::none_of(loads.begin(), loads.end(), follows);
}

TwoPart NonlinearEquations::all(const TwoPart& y, const TwoPart& q) const {
  TwoPart both{Vector(y.size() + q.size()), Vector(y.size() + q.size())};
  both.high << y.high, q.high;
  both.low << y.low, q.low;
  return both;
}

Vector NonlinearEquations::deformation(const TwoPart& y, const TwoPart& q) const {
  return translation.without(all(y, q));
}

Vector NonlinearEquations::displacement(const Vector& unknowns) const {
  Vector u = Vector::Zero(2 * mesh().node_count());
  for (int node = 0; node < mesh().node_count(); ++node)
    for (const Term& term : columns.terms[node])
      u.segment<2>(2 * node) += columns.path(term, unknowns[term.column], turns()).displacement;
  return u;
}

SparseMatrix NonlinearEquations::expansion(const Vector& unknowns) const {
  std::vector<base::Triplet> entries;
  for (int node = 0; node < mesh().node_count(); ++node)
    for (const Term& term : columns.terms[node]) {
      const Vec2 slope = columns.path(term, unknowns[term.column], turns()).slope;
      for (int i : {0, 1}) entries.emplace_back(2 * node + i, term.column, slope[i]);
    }
  SparseMatrix B(2 * mesh().node_count(), columns.interior + columns.retained);
  B.setFromTriplets(entries.begin(), entries.end());
  return B;
}

Vector NonlinearEquations::unbalanced(const fem::InternalForce& f, const Vector& u, const Vector& factors) const {
  Vector r = f.total;
  for (size_t i = 0; i < loads.size(); ++i) {
    r -= factors[i] * loads[i].dead;
    if (loads[i].pressure) loads[i].pressure->add_force(-factors[i], mesh(), u, r);
  }
  return r;
}

void NonlinearEquations::subtract_load_tangent(const Vector& u, const Vector& factors, SparseMatrix& K) const {
  for (size_t i = 0; i < loads.size(); ++i)
    if (loads[i].pressure) loads[i].pressure->add_tangent(-factors[i], mesh(), u, pattern, K);
}

Vector NonlinearEquations::turning(const Vector& unbalanced, const Vector& unknowns) const {
  Vector diagonal = Vector::Zero(unknowns.size());
  if (!turns()) return diagonal;
  for (int node = 0; node < mesh().node_count(); ++node)
    for (const Term& term : columns.terms[node])
      if (columns.turns(term.column))
        diagonal[term.column] +=
            unbalanced.segment<2>(2 * node).dot(columns.path(term, unknowns[term.column], true).curvature);
  return diagonal;
}

}  // namespace reye::body
