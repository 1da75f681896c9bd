#include <cassert>

#include "fem/finite.hpp"
#include "fem/finite_cells.hpp"
#include "fem/nodal_average.hpp"

namespace reye::fem {

History updated(const Mesh& mesh, const Solid& solid, const Vector& u, const GaussState& before) {
  History after(before.history.begin(), before.history.end());
  if (after.empty()) return after;
  const bool bar = barred(solid, mesh.kind);
  with_types(mesh, solid, [&]<class Strain, int n>(Strain, std::integral_constant<int, n>) {
    for_each_cell<Strain, n>(
        mesh, solid, u, before.F0, [](int) {},
        [&](const auto& p, const auto&, int number) {
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
    const auto point = [&](const auto& p, const auto&, int number) {
      at(Strain::seen(bar, as_array<Strain>(p.x)), p, number);
    };
    for_each_cell<Strain, n>(
        mesh, solid, u, F0, [](int) {}, point, [](int, const auto&) {});
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
        mesh, solid, u, F0, [](int) {},
        [&](const auto& p, const auto&, int) { F.push_back(FiniteStrain::seen(bar, as_array<FiniteStrain>(p.x))); },
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
    int g = 0;
    const auto point = [&](const auto& p, const auto&, int number) {
      const PlasticState& state = state_of(gauss.history, number);
      const Stress sigma = Strain::cauchy(solid, bar, as_array<Strain>(p.x), state);
      values.col(g++) << sigma[0], sigma[1], sigma[2], sigma[3], state.accumulated;
    };
    for_each_cell<Strain, n>(
        mesh, solid, u, gauss.F0, [&](int) { g = 0; }, point,
        [&](int cell, const auto& samples) {
          double volume = 0.0;
          for (int k = 0; k < samples.count; ++k) volume += samples.points[k].volume;
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
