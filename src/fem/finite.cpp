#include "fem/finite.hpp"

#include "fem/finite_cells.hpp"

namespace reye::fem {

using base::Matrix;
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
    const auto point = [&](const auto& p, const auto&, int number) {
      const PlasticState& old = state_of(before.history, number);
      PlasticState after = old;
      const auto s = stress_at<Strain>(solid, bar, p.x, old, may_yield ? &after : nullptr);
      if (may_yield) (*yields)[now] |= after.accumulated > old.accumulated;
      Strain::add_force(p, Stresses<Strain>(p.volume * s), fe);
    };
    for_each_cell<Strain, n>(
        mesh, solid, u, before.F0, begin, point, [&](int cell, const auto&) { add_force(mesh, cell, fe, f); }, wanted);
  });
}

namespace {

/// Of a cell as `with_types` computes it.
int cell_dofs(const Mesh& mesh) { return mesh::order(mesh.kind) == 1 ? 8 : 16; }

}  // namespace

Matrix cell_tangents(const Mesh& mesh) {
  const int size = cell_dofs(mesh);
  return Matrix::Zero(size * size, mesh.cell_count());
}

void renew(const Mesh& mesh, const Solid& solid, const Vector& u, const GaussState& before,
           std::span<const char> wanted, Matrix& of_cells) {
  const bool bar = barred(solid, mesh.kind);
  with_types(mesh, solid, [&]<class Strain, int n>(Strain, std::integral_constant<int, n>) {
    Eigen::Matrix<double, 2 * n, 2 * n> Ke;
    const auto point = [&](const auto& p, const auto& samples, int number) {
      const auto D = slope_at<Strain>(solid, bar, p.x, state_of(before.history, number));
      const auto& dx = Strain::derivative(samples, p);
      const Eigen::Matrix<double, Strain::stresses, 2 * n> ds = p.volume * D.lazyProduct(dx);
      Ke += dx.template topRows<Strain::stresses>().transpose().lazyProduct(ds);
    };
    const auto keep = [&](int cell, const auto&) { of_cells.col(cell) = Ke.reshaped(); };
    for_each_cell<Strain, n>(
        mesh, solid, u, before.F0, [&](int) { Ke.setZero(); }, point, keep, wanted);
  });
}

void assemble(const Mesh& mesh, const Matrix& of_cells, std::span<const char> wanted, const Pattern& pattern,
              SparseMatrix& K) {
  K.coeffs().setZero();
  const int count = mesh::nodes_per_cell(mesh.kind), size = cell_dofs(mesh);
  for (int cell = 0; cell < mesh.cell_count(); ++cell)
    if (wanted.empty() || wanted[cell])
      pattern.add_cell(of_cells.col(cell).reshaped(size, size), mesh.cells[cell], count, K);
}

}  // namespace reye::fem
