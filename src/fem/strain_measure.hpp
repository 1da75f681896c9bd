#pragma once
#include <Eigen/Core>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <span>
#include <string>

#include "base/errors.hpp"
#include "fem/element.hpp"
#include "fem/solid.hpp"
#include "fem/stiffness.hpp"
#include "material/energy.hpp"
#include "material/stress.hpp"

/// The two strain measures of a cell, each one list of inputs x(u) per Gauss point and one stress function of x whose
/// result is work conjugate to the leading entries of x.
namespace reye::fem {

/// A cell with n nodes (4 in first order, 8 in second; unused ones zero): positions on X and displacements.
template <int n>
struct CellState {
  Eigen::Matrix<double, n, 2> X = Eigen::Matrix<double, n, 2>::Zero();
  Eigen::Matrix<double, 2 * n, 1> u = Eigen::Matrix<double, 2 * n, 1>::Zero();
};

/// Inputs at a Gauss point, their derivative by the displacements of the cell, and weight * det J * (1 or 2 pi r), the
/// content of unstressed material.
template <int inputs, int n>
struct Sample {
  Eigen::Matrix<double, inputs, 1> x;
  Eigen::Matrix<double, inputs, 2 * n> dx;
  double volume = 0.0;
};

/// F0 of the Gauss points of a cell, or none.
using CellPrestrain = std::span<const material::Gradient<double>>;

/// At most four Gauss points.
template <int inputs, int n>
struct Samples {
  std::array<Sample<inputs, n>, 4> points;
  int count = 0;
};

inline bool barred(const Solid& solid, mesh::CellKind kind) {
  return solid.cure && kind == mesh::CellKind::quad4 && solid.analysis != Analysis::plane_stress;
}

/// x = (eps_11, eps_22, gamma_12, eps_33) = B u with the B of `strain_points`; stress sigma.
struct SmallStrain {
  static constexpr int inputs = 4, stresses = 4;

  template <int n>
  static Samples<inputs, n> samples(const Mesh& mesh, int cell, const Solid& solid, const CellState<n>& state,
                                    CellPrestrain) {
    const CellStrains<n> strains = strain_points<n>(mesh, cell, solid.analysis, solid.cure);
    Samples<inputs, n> s;
    for (s.count = 0; s.count < strains.count; ++s.count) {
      auto& p = s.points[s.count];
      p.dx = strains.points[s.count].B;
      p.x = p.dx.lazyProduct(state.u);
      p.volume = strains.points[s.count].volume;
    }
    return s;
  }

  template <class T>
  static std::array<T, 4> stress(const Solid& solid, bool, const std::array<T, 4>& x,
                                 const material::PlasticState& before, material::PlasticState* after) {
    return material::stress(solid.material, solid.analysis, x, before, after);
  }

  static Stress cauchy(const Solid& solid, bool, const std::array<double, 4>& x, const material::PlasticState& state) {
    return material::stress(solid.material, solid.analysis, x, state);
  }

  /// The input of the law.
  static const std::array<double, 4>& seen(bool, const std::array<double, 4>& x) { return x; }
};

/// x = (H11, H12, H21, H22, H33, J0 - 1), F = I + H from the unstressed state, F33 = 1 or r/R, J0 = det F at the centre
/// of the cell; stress P. With F0: F = (I + G u) F0 over the content dV / det F0 does the work of P F0^T / det F0 on X,
/// and J0 is det(I + G u) at the centre times the growth of the cell from unstressed to X, (sum dV) / sum(dV / det F0).
/// F-bar evaluates the law at F-bar = s F, s = (J0 / J)^(1/3), F33 included, and does work on the true F over the true
/// volume: P = (J / J0) tau F^-T = P(F-bar) / s^2. At small strain that is B-bar with its value at the centre.   (5)
struct FiniteStrain {
  static constexpr int inputs = 6, stresses = 5;

  template <int n>
  static Samples<inputs, n> samples(const Mesh& mesh, int cell, const Solid& solid, const CellState<n>& state,
                                    CellPrestrain F0) {
    Samples<inputs, n> s;
    for (const RulePoint& point : tabulated_rule(mesh.kind)) add_sample(cell, solid, state, point, s);
    const double growth = F0.empty() ? 1.0 : start_unstressed(solid.analysis, F0, s);
    if (barred(solid, mesh.kind)) add_centre(cell, solid, state, growth, s);
    return s;
  }

  /// The input of the law: F, or F-bar.
  static material::Gradient<double> seen(bool bar, const std::array<double, 6>& x) {
    material::Gradient<double> H = gradient_of(x);
    if (bar) stretch_by(stretch(x), H);
    return material::with_unit(H);
  }

  template <class T>
  static std::array<T, 5> stress(const Solid& solid, bool bar, const std::array<T, 6>& x,
                                 const material::PlasticState& before, material::PlasticState* after) {
    material::Gradient<T> H = gradient_of(x);
    if (!bar) return material::first_piola_from(solid.material, solid.analysis, H, before, after);
    const T s = stretch(x);
    stretch_by(s, H);
    auto P = material::first_piola_from(solid.material, solid.analysis, H, before, after);
    const T back = 1.0 / ((s + 1.0) * (s + 1.0));
    for (T& p : P) p *= back;
    return P;
  }

  /// tau / J, at F-bar.
  static Stress cauchy(const Solid& solid, bool bar, const std::array<double, 6>& x,
                       const material::PlasticState& state) {
    const auto F = seen(bar, x);
    Stress sigma = material::kirchhoff(solid.material, solid.analysis, F, state);
    const double J =
        material::plane_determinant(F) * material::thickness_stretch(solid.material, solid.analysis, F, state);
    for (double& component : sigma) component /= J;
    return sigma;
  }

 private:
  /// Gradient operator (H11, H12, H21, H22, H33) = G u and the volume weight.
  template <int n>
  static double gradient(int cell, Analysis analysis, const CellState<n>& state, const RulePoint& point,
                         Eigen::Matrix<double, 5, 2 * n>& G) {
    const auto dN_dxi = point.dN_dxi.template topRows<n>();
    const Eigen::Matrix2d J = dN_dxi.transpose().lazyProduct(state.X);  // row i: dX/dxi_i
    const double det = J.determinant();
    if (!(det > 0.0)) throw base::MeshError("cell " + std::to_string(cell) + " has a Jacobian that is not positive");
    const Eigen::Matrix<double, n, 2> dN = dN_dxi.lazyProduct(Eigen::Matrix2d(J.inverse().transpose()));
    const double R = point.N.template head<n>().dot(state.X.col(0));
    G.setZero();
    for (int a = 0; a < n; ++a) {
      G(0, 2 * a) = G(2, 2 * a + 1) = dN(a, 0);
      G(1, 2 * a) = G(3, 2 * a + 1) = dN(a, 1);
      if (analysis == Analysis::axisymmetric) G(4, 2 * a) = point.N[a] / R;
    }
    return point.at.weight * det * base::out_of_plane(analysis, R);
  }

  template <int n>
  static void add_sample(int cell, const Solid& solid, const CellState<n>& state, const RulePoint& point,
                         Samples<inputs, n>& s) {
    auto& p = s.points[s.count++];
    Eigen::Matrix<double, 5, 2 * n> G;
    p.volume = gradient(cell, solid.analysis, state, point, G);
    p.x.template head<5>() = G.lazyProduct(state.u);
    p.x[5] = 0.0;
    p.dx.template topRows<5>() = G;
    p.dx.row(5).setZero();
  }

  /// Content per content of unstressed material; the thickness of plane stress is counted as it was unstressed.
  static double content(Analysis analysis, const material::Gradient<double>& F0) {
    return material::plane_determinant(F0) * (analysis == Analysis::plane_stress ? 1.0 : F0[4]);
  }

  /// Makes (I + G u) F0 - I = G u F0 + F0 - I of G u. Returns the growth of the cell from unstressed to X.
  template <int n>
  static double start_unstressed(Analysis analysis, CellPrestrain F0, Samples<inputs, n>& s) {
    double on_X = 0.0, unstressed = 0.0;
    for (int g = 0; g < s.count; ++g) {
      const auto& F = F0[g];
      Eigen::Matrix<double, 5, 5> right = Eigen::Matrix<double, 5, 5>::Zero();
      right.block<2, 2>(0, 0) << F[0], F[2], F[1], F[3];
      right.block<2, 2>(2, 2) = right.block<2, 2>(0, 0);
      right(4, 4) = F[4];
      auto& p = s.points[g];
      p.x.template head<5>() = right.lazyProduct(p.x.template head<5>()).eval();
      const auto start = material::without_unit(F);
      for (int i = 0; i < 5; ++i) p.x[i] += start[i];
      p.dx.template topRows<5>() = right.lazyProduct(p.dx.template topRows<5>()).eval();
      on_X += p.volume;
      p.volume /= content(analysis, F);
      unstressed += p.volume;
    }
    return on_X / unstressed;
  }

  /// J0 - 1 and its derivative, equal at all points.
  template <int n>
  static void add_centre(int cell, const Solid& solid, const CellState<n>& state, double growth,
                         Samples<inputs, n>& s) {
    Eigen::Matrix<double, 5, 2 * n> G;
    gradient(cell, solid.analysis, state, centre_of_quad4(), G);
    material::Gradient<double> H;
    Eigen::Map<Eigen::Matrix<double, 5, 1>>(H.data()) = G.lazyProduct(state.u);
    const auto F = material::with_unit(H);
    Eigen::Matrix<double, 1, 5> cofactor;
    cofactor << F[4] * F[3], -F[4] * F[2], -F[4] * F[1], F[4] * F[0], material::plane_determinant(F);
    const Eigen::Matrix<double, 1, 2 * n> dJ = cofactor.lazyProduct(G);
    for (int g = 0; g < s.count; ++g) {
      s.points[g].x[5] = growth * material::dilation(H) + (growth - 1.0);
      s.points[g].dx.row(5) = growth * dJ;
    }
  }

  template <class T>
  static material::Gradient<T> gradient_of(const std::array<T, 6>& x) {
    return {x[0], x[1], x[2], x[3], x[4]};
  }

  /// s - 1
  template <class T>
  static T stretch(const std::array<T, 6>& x) {
    const T j = material::dilation(gradient_of(x));
    if (!(base::value(j) > -1.0) || !(base::value(x[5]) > -1.0))
      throw base::SolveError("det F is " + std::to_string(base::value(j) + 1.0) + ", at the centre of the cell " +
                             std::to_string(base::value(x[5]) + 1.0));
    return material::cube_root_beyond_unit(T((x[5] - j) / (j + 1.0)));
  }

  /// Makes s F - I of H = F - I, from s - 1.
  template <class T>
  static void stretch_by(const T& s, material::Gradient<T>& H) {
    const auto F = material::with_unit(H);
    for (int i = 0; i < 5; ++i) H[i] += s * F[i];
  }
};

}  // namespace reye::fem
