#include "fem/finite.hpp"

#include <cassert>
#include <type_traits>

#include "base/formatted.hpp"
#include "fem/nodal_average.hpp"
#include "fem/strain_measure.hpp"

namespace reye::fem {

using base::Dual;
using base::SparseMatrix;
using base::Vector;
using material::PlasticState;

namespace {

template <class Strain>
using Inputs = Eigen::Matrix<double, Strain::inputs, 1>;

template <class Strain>
using Stresses = Eigen::Matrix<double, Strain::stresses, 1>;

/// Stress and its derivative by the inputs.
template <class Strain>
struct Slope {
  Stresses<Strain> s;
  Eigen::Matrix<double, Strain::stresses, Strain::inputs> D;
};

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

template <class Strain>
Slope<Strain> slope_at(const Solid& solid, bool bar, const Inputs<Strain>& x, const PlasticState& before) {
  constexpr int inputs = Strain::inputs;
  std::array<Dual<inputs>, inputs> variable;
  for (int j = 0; j < inputs; ++j) variable[j] = Dual<inputs>::variable(x[j], j);
  const auto s = Strain::stress(solid, bar, variable, before, nullptr);
  Slope<Strain> slope;
  for (int i = 0; i < Strain::stresses; ++i) {
    slope.s[i] = s[i].v;
    for (int j = 0; j < inputs; ++j) slope.D(i, j) = s[i].d[j];
  }
  return slope;
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
base::SolveError located(const Mesh& mesh, int cell, int point, const base::SolveError& error) {
  const NodeValues N = shape_functions(mesh.kind, stiffness_rule(mesh.kind)[point].xi);
  Vec2 at = Vec2::Zero();
  for (int a = 0; a < mesh::nodes_per_cell(mesh.kind); ++a) at += N[a] * mesh.X[mesh.cells[cell][a]];
  const std::string place =
      base::formatted("cell %d, Gauss point %d at (%.4g, %.4g) mm: ", cell, point, at.x(), at.y());
  return base::SolveError(place + std::string(error.what()));
}

/// For every cell: begin(), then for each Gauss point point(sample, its number in the cell, its number in the mesh),
/// then end(cell, samples).
template <class Strain, int n, class Begin, class Point, class End>
void for_each_cell(const Mesh& mesh, const Solid& solid, const Vector& u, const CellPrestrain F0, Begin begin,
                   Point point, End end) {
  const size_t per_cell = F0.empty() ? 0 : stiffness_rule(mesh.kind).size();
  int number = 0;
  for (int cell = 0; cell < mesh.cell_count(); ++cell) {
    const auto samples = Strain::template samples<n>(mesh, cell, solid, cell_state<n>(mesh, cell, u),
                                                     F0.subspan(cell * per_cell, per_cell));
    begin();
    for (int g = 0; g < samples.count; ++g) {
      try {
        point(samples.points[g], g, number++);
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

const PlasticState& state_of(std::span<const PlasticState> history, int number) {
  static const PlasticState none;
  return history.empty() ? none : history[number];
}

template <class CellForce>
void add_force(const Mesh& mesh, int cell, const CellForce& fe, InternalForce& f) {
  for (int a = 0; a < mesh::nodes_per_cell(mesh.kind); ++a)
    f.total.segment<2>(2 * mesh.cells[cell][a]) += fe.template segment<2>(2 * a);
  f.largest = std::max(f.largest, fe.cwiseAbs().maxCoeff());
}

void clear(const Mesh& mesh, InternalForce& f) {
  f.total.setZero(2 * mesh.node_count());
  f.largest = 0.0;
}

}  // namespace

bool Solid::has_history() const { return std::holds_alternative<material::HenckyJ2>(material); }

bool Solid::symmetric(mesh::CellKind kind) const {
  const auto* hencky = std::get_if<material::Hencky>(&material);
  return kinematics == base::Kinematics::small || !(barred(*this, kind) || (hencky && hencky->cauchy));
}

History virgin(const Mesh& mesh, const Solid& solid) {
  return History(solid.has_history() ? mesh.cells.size() * stiffness_rule(mesh.kind).size() : 0);
}

void internal_force(const Mesh& mesh, const Solid& solid, const Vector& u, const GaussState& before, InternalForce& f) {
  clear(mesh, f);
  const bool bar = barred(solid, mesh.kind);
  with_types(mesh, solid, [&]<class Strain, int n>(Strain, std::integral_constant<int, n>) {
    Eigen::Matrix<double, 2 * n, 1> fe;
    for_each_cell<Strain, n>(
        mesh, solid, u, before.F0, [&] { fe.setZero(); },
        [&](const auto& p, int, int number) {
          const auto s = stress_at<Strain>(solid, bar, p.x, state_of(before.history, number));
          fe.noalias() += p.dx.template topRows<Strain::stresses>().transpose() * (p.volume * s);
        },
        [&](int cell, const auto&) { add_force(mesh, cell, fe, f); });
  });
}

void tangent(const Mesh& mesh, const Solid& solid, const Vector& u, const GaussState& before, const Pattern& pattern,
             InternalForce& f, SparseMatrix& K) {
  clear(mesh, f);
  K.coeffs().setZero();
  const bool bar = barred(solid, mesh.kind);
  const int count = mesh::nodes_per_cell(mesh.kind);
  with_types(mesh, solid, [&]<class Strain, int n>(Strain, std::integral_constant<int, n>) {
    Eigen::Matrix<double, 2 * n, 1> fe;
    Eigen::Matrix<double, 2 * n, 2 * n> Ke;
    const auto begin = [&] {
      fe.setZero();
      Ke.setZero();
    };
    const auto point = [&](const auto& p, int, int number) {
      const auto slope = slope_at<Strain>(solid, bar, p.x, state_of(before.history, number));
      const Eigen::Matrix<double, Strain::stresses, 2 * n> ds = p.volume * (slope.D * p.dx);
      const auto work = p.dx.template topRows<Strain::stresses>().transpose();
      fe.noalias() += work * (p.volume * slope.s);
      Ke.noalias() += work * ds;
    };
    for_each_cell<Strain, n>(mesh, solid, u, before.F0, begin, point, [&](int cell, const auto&) {
      add_force(mesh, cell, fe, f);
      pattern.add_cell(Ke, mesh.cells[cell], count, K);
    });
  });
}

History updated(const Mesh& mesh, const Solid& solid, const Vector& u, const GaussState& before) {
  History after(before.history.begin(), before.history.end());
  if (after.empty()) return after;
  const bool bar = barred(solid, mesh.kind);
  with_types(mesh, solid, [&]<class Strain, int n>(Strain, std::integral_constant<int, n>) {
    for_each_cell<Strain, n>(
        mesh, solid, u, before.F0, [] {},
        [&](const auto& p, int, int number) {
          stress_at<Strain>(solid, bar, p.x, before.history[number], &after[number]);
        },
        [](int, const auto&) {});
  });
  return after;
}

namespace {

/// Calls at(inputs of the law, Gauss point, its number in the mesh) for every Gauss point.
template <class At>
void for_each_point(const Mesh& mesh, const Solid& solid, const Vector& u, const CellPrestrain F0, At at) {
  const bool bar = barred(solid, mesh.kind);
  with_types(mesh, solid, [&]<class Strain, int n>(Strain, std::integral_constant<int, n>) {
    const auto point = [&](const auto& p, int, int number) { at(Strain::seen(bar, as_array<Strain>(p.x)), p, number); };
    for_each_cell<Strain, n>(
        mesh, solid, u, F0, [] {}, point, [](int, const auto&) {});
  });
}

}  // namespace

ElasticStates elastic_states(const Mesh& mesh, const Solid& solid, const Vector& u, const GaussState& now) {
  ElasticStates states;
  if (now.history.empty()) return states;
  for_each_point(mesh, solid, u, now.F0, [&](const auto& seen, const auto&, int number) {
    states.push_back(material::elastic_state(solid.material, solid.analysis, seen, now.history[number]));
  });
  return states;
}

History compatible(const Mesh& mesh, const Solid& solid, const Vector& u, const Prestrain& F0,
                   const ElasticStates& states) {
  History history;
  if (states.empty()) return history;
  for_each_point(mesh, solid, u, F0, [&](const auto& seen, const auto&, int number) {
    history.push_back(material::plastic_state(solid.analysis, seen, states[number]));
  });
  return history;
}

double strain_energy(const Mesh& mesh, const Solid& solid, const Vector& u, const GaussState& now) {
  double energy = 0.0;
  for_each_point(mesh, solid, u, now.F0, [&](const auto& seen, const auto& point, int number) {
    energy +=
        point.volume * material::strain_energy(solid.material, solid.analysis, seen, state_of(now.history, number));
  });
  return energy;
}

Prestrain deformation(const Mesh& mesh, const Solid& solid, const Vector& u, const Prestrain& F0) {
  assert(solid.kinematics == base::Kinematics::finite);
  Prestrain F;
  const bool bar = barred(solid, mesh.kind);
  const auto run = [&]<int n>(std::integral_constant<int, n>) {
    for_each_cell<FiniteStrain, n>(
        mesh, solid, u, F0, [] {},
        [&](const auto& p, int, int) { F.push_back(FiniteStrain::seen(bar, as_array<FiniteStrain>(p.x))); },
        [](int, const auto&) {});
  };
  mesh::order(mesh.kind) == 1 ? run(std::integral_constant<int, 4>{}) : run(std::integral_constant<int, 8>{});
  return F;
}

NodalState nodal_state(const Mesh& mesh, const Solid& solid, const Vector& u, const GaussState& gauss) {
  NodalAverage<5> average(mesh);
  const bool bar = barred(solid, mesh.kind);
  with_types(mesh, solid, [&]<class Strain, int n>(Strain, std::integral_constant<int, n>) {
    Eigen::Matrix<double, 5, 4> values = Eigen::Matrix<double, 5, 4>::Zero();  // column: Gauss point
    const auto point = [&](const auto& p, int g, int number) {
      const PlasticState& state = state_of(gauss.history, number);
      const Stress sigma = Strain::cauchy(solid, bar, as_array<Strain>(p.x), state);
      values.col(g) << sigma[0], sigma[1], sigma[2], sigma[3], state.accumulated;
    };
    for_each_cell<Strain, n>(
        mesh, solid, u, gauss.F0, [] {}, point,
        [&](int cell, const auto& samples) {
          double volume = 0.0;
          for (int g = 0; g < samples.count; ++g) volume += samples.points[g].volume;
          average.add(cell, values, volume);
        });
  });
  NodalState result;
  for (const auto& value : average.values()) {
    result.stress.push_back({value[0], value[1], value[2], value[3]});
    result.plastic_strain.push_back(value[4]);
  }
  return result;
}

}  // namespace reye::fem
