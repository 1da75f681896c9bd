#include "fem/finite.hpp"

#include "fem/finite_cells.hpp"

namespace reye::fem {

using base::SparseMatrix;

namespace {

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
        mesh, solid, u, before.F0, [&](int) { fe.setZero(); },
        [&](const auto& p, int, int number) {
          const auto s = stress_at<Strain>(solid, bar, p.x, state_of(before.history, number));
          fe += p.dx.template topRows<Strain::stresses>().transpose().lazyProduct(p.volume * s);
        },
        [&](int cell, const auto&) { add_force(mesh, cell, fe, f); });
  });
}

namespace {

/// What a Gauss point adds to force and stiffness of its cell.
template <class Strain, int n, class Sample>
void add_point(const Solid& solid, bool bar, const Sample& p, const PlasticState& before,
               Eigen::Matrix<double, 2 * n, 1>& fe, Eigen::Matrix<double, 2 * n, 2 * n>& Ke) {
  const auto slope = slope_at<Strain>(solid, bar, p.x, before);
  const Eigen::Matrix<double, Strain::stresses, 2 * n> ds = p.volume * slope.D.lazyProduct(p.dx);
  const auto work = p.dx.template topRows<Strain::stresses>().transpose();
  fe += work.lazyProduct(p.volume * slope.s);
  Ke += work.lazyProduct(ds);
}

}  // namespace

void tangent(const Mesh& mesh, const Solid& solid, const Vector& u, const GaussState& before, const Pattern& pattern,
             InternalForce& f, SparseMatrix& K) {
  clear(mesh, f);
  K.coeffs().setZero();
  const bool bar = barred(solid, mesh.kind);
  const int count = mesh::nodes_per_cell(mesh.kind);
  with_types(mesh, solid, [&]<class Strain, int n>(Strain, std::integral_constant<int, n>) {
    Eigen::Matrix<double, 2 * n, 1> fe;
    Eigen::Matrix<double, 2 * n, 2 * n> Ke;
    const auto begin = [&](int) {
      fe.setZero();
      Ke.setZero();
    };
    const auto point = [&](const auto& p, int, int number) {
      add_point<Strain, n>(solid, bar, p, state_of(before.history, number), fe, Ke);
    };
    for_each_cell<Strain, n>(mesh, solid, u, before.F0, begin, point, [&](int cell, const auto&) {
      add_force(mesh, cell, fe, f);
      pattern.add_cell(Ke, mesh.cells[cell], count, K);
    });
  });
}

void tangent_of(const std::vector<char>& wanted, const Mesh& mesh, const Solid& solid, const Vector& u,
                const GaussState& before, const Pattern& pattern, InternalForce& f, SparseMatrix& K,
                std::vector<char>& yields) {
  clear(mesh, f);
  K.coeffs().setZero();
  yields.assign(mesh.cells.size(), 0);
  const bool bar = barred(solid, mesh.kind), may_yield = !before.history.empty();
  const int count = mesh::nodes_per_cell(mesh.kind);
  with_types(mesh, solid, [&]<class Strain, int n>(Strain, std::integral_constant<int, n>) {
    Eigen::Matrix<double, 2 * n, 1> fe;
    Eigen::Matrix<double, 2 * n, 2 * n> Ke;
    int now = 0;
    const auto begin = [&](int cell) {
      now = cell;
      fe.setZero();
      Ke.setZero();
    };
    const auto point = [&](const auto& p, int, int number) {
      const PlasticState& old = state_of(before.history, number);
      if (wanted[now]) add_point<Strain, n>(solid, bar, p, old, fe, Ke);
      if (wanted[now] && !may_yield) return;
      PlasticState after = old;
      const auto s = stress_at<Strain>(solid, bar, p.x, old, may_yield ? &after : nullptr);
      yields[now] |= after.accumulated > old.accumulated;
      if (!wanted[now]) fe += p.dx.template topRows<Strain::stresses>().transpose().lazyProduct(p.volume * s);
    };
    for_each_cell<Strain, n>(mesh, solid, u, before.F0, begin, point, [&](int cell, const auto&) {
      add_force(mesh, cell, fe, f);
      if (wanted[cell]) pattern.add_cell(Ke, mesh.cells[cell], count, K);
    });
  });
}

}  // namespace reye::fem
