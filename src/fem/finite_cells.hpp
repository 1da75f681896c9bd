#pragma once
#include <array>
#include <span>
#include <type_traits>

#include "base/formatted.hpp"
#include "fem/strain_measure.hpp"

/// Internal to `finite`: loops over the cells and Gauss points of a mesh, with the strain measure as a type.
namespace reye::fem {

using base::Dual;
using base::Vector;
using material::PlasticState;

template <class Strain>
using Inputs = Eigen::Matrix<double, Strain::inputs, 1>;

template <class Strain>
using Stresses = Eigen::Matrix<double, Strain::stresses, 1>;

template <class Strain>
using Slope = Eigen::Matrix<double, Strain::stresses, Strain::inputs>;

template <class Strain>
std::array<double, Strain::inputs> as_array(const Inputs<Strain>& x) {
  std::array<double, Strain::inputs> a;
  for (int i = 0; i < Strain::inputs; ++i) a[i] = x[i];
  return a;
}

template <class Strain>
Stresses<Strain> stress_at(const Solid& solid, bool bar, const Inputs<Strain>& x, const PlasticState& before,
                           PlasticState* after = nullptr) {
  const auto s = Strain::stress(solid, bar, as_array<Strain>(x), before, after);
  return Eigen::Map<const Stresses<Strain>>(s.data());
}

/// The derivative of the stress by the inputs.
template <class Strain>
Slope<Strain> slope_at(const Solid& solid, bool bar, const Inputs<Strain>& x, const PlasticState& before) {
  constexpr int inputs = Strain::inputs;
  std::array<Dual<inputs>, inputs> variable;
  for (int j = 0; j < inputs; ++j) variable[j] = Dual<inputs>::variable(x[j], j);
  const auto s = Strain::stress(solid, bar, variable, before, nullptr);
  Slope<Strain> D;
  for (int i = 0; i < Strain::stresses; ++i)
    for (int j = 0; j < inputs; ++j) D(i, j) = s[i].d[j];
  return D;
}

template <int n>
CellState<n> cell_state(const Mesh& mesh, int cell, const Vector& u) {
  CellState<n> state;
  for (int a = 0; a < mesh::nodes_per_cell(mesh.kind); ++a) {
    const int node = mesh.cells[cell][a];
    state.X.row(a) = mesh.X[node];
    state.u.template segment<2>(2 * a) = u.segment<2>(2 * node);
  }
  return state;
}

/// "cell 7, Gauss point 2 at (0.25, 1.5) mm: ..."
inline base::SolveError located(const Mesh& mesh, int cell, int point, const base::SolveError& error) {
  const NodeValues N = shape_functions(mesh.kind, stiffness_rule(mesh.kind)[point].xi);
  Vec2 at = Vec2::Zero();
  for (int a = 0; a < mesh::nodes_per_cell(mesh.kind); ++a) at += N[a] * mesh.X[mesh.cells[cell][a]];
  const std::string place =
      base::formatted("cell %d, Gauss point %d at (%.4g, %.4g) mm: ", cell, point, at.x(), at.y());
  return base::SolveError(place + std::string(error.what()));
}

/// For every cell, or those with `wanted`: begin(cell), then for each Gauss point point(sample, samples of the cell,
/// its number in the mesh), then end(cell, samples).
template <class Strain, int n, class Begin, class Point, class End>
void for_each_cell(const Mesh& mesh, const Solid& solid, const Vector& u, const CellPrestrain F0, Begin begin,
                   Point point, End end, std::span<const char> wanted = {}) {
  const size_t in_cell = stiffness_rule(mesh.kind).size(), per_cell = F0.empty() ? 0 : in_cell;
  for (int cell = 0; cell < mesh.cell_count(); ++cell) {
    if (!wanted.empty() && !wanted[cell]) continue;
    const auto samples = Strain::template samples<n>(mesh, cell, solid, cell_state<n>(mesh, cell, u),
                                                     F0.subspan(cell * per_cell, per_cell));
    begin(cell);
    for (int g = 0; g < samples.count; ++g) {
      try {
        point(samples.points[g], samples, cell * static_cast<int>(in_cell) + g);
      } catch (const base::SolveError& error) {
        throw located(mesh, cell, g, error);
      }
    }
    end(cell, samples);
  }
}

/// Calls run(strain measure, number of nodes) with both as types.
template <class Run>
void with_types(const Mesh& mesh, const Solid& solid, Run run) {
  constexpr std::integral_constant<int, 4> four;
  constexpr std::integral_constant<int, 8> eight;
  const bool first = mesh::order(mesh.kind) == 1;
  if (solid.kinematics == base::Kinematics::small)
    first ? run(SmallStrain{}, four) : run(SmallStrain{}, eight);
  else
    first ? run(FiniteStrain{}, four) : run(FiniteStrain{}, eight);
}

inline const PlasticState& state_of(std::span<const PlasticState> history, int number) {
  static const PlasticState none;
  return history.empty() ? none : history[number];
}

}  // namespace reye::fem
