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

void internal_force(const Mesh& mesh, const Solid& solid, const Vector& u, const GaussState& before, InternalForce& f,
                    std::vector<char>* yields, std::span<const char> wanted) {
  clear(mesh, f);
  if (yields) yields->assign(mesh.cells.size(), 0);
  const bool bar = barred(solid, mesh.kind), may_yield = yields && !before.history.empty();
  with_types(mesh, solid, [&]<class Strain, int n>(Strain, std::integral_constant<int, n>) {
    Eigen::Matrix<double, 2 * n, 1> fe;
    int now = 0;
    const auto begin = [&](int cell) {
      now = cell;
      fe.setZero();
    };
    const auto point = [&](const auto& p, int, int number) {
      const PlasticState& old = state_of(before.history, number);
      PlasticState after = old;
      const auto s = stress_at<Strain>(solid, bar, p.x, old, may_yield ? &after : nullptr);
      if (may_yield) (*yields)[now] |= after.accumulated > old.accumulated;
      fe += p.dx.template topRows<Strain::stresses>().transpose().lazyProduct(p.volume * s);
    };
    for_each_cell<Strain, n>(
        mesh, solid, u, before.F0, begin, point, [&](int cell, const auto&) { add_force(mesh, cell, fe, f); }, wanted);
  });
}

void tangent(const Mesh& mesh, const Solid& solid, const Vector& u, const GaussState& before, const Pattern& pattern,
             SparseMatrix& K, std::span<const char> wanted) {
  K.coeffs().setZero();
  const bool bar = barred(solid, mesh.kind);
  const int count = mesh::nodes_per_cell(mesh.kind);
  with_types(mesh, solid, [&]<class Strain, int n>(Strain, std::integral_constant<int, n>) {
    Eigen::Matrix<double, 2 * n, 2 * n> Ke;
    const auto point = [&](const auto& p, int, int number) {
      const auto D = slope_at<Strain>(solid, bar, p.x, state_of(before.history, number));
      const Eigen::Matrix<double, Strain::stresses, 2 * n> ds = p.volume * D.lazyProduct(p.dx);
      Ke += p.dx.template topRows<Strain::stresses>().transpose().lazyProduct(ds);
    };
    for_each_cell<Strain, n>(
        mesh, solid, u, before.F0, [&](int) { Ke.setZero(); }, point,
        [&](int cell, const auto&) { pattern.add_cell(Ke, mesh.cells[cell], count, K); }, wanted);
  });
}

}  // namespace reye::fem
