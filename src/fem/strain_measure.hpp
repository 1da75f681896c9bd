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
/// result is work conjugate to the leading entries of x. A sample of them holds x and `volume`, weight * det J * (1 or
/// 2 pi r), the content of unstressed material; `add_force` adds (dx/du)^T s, `derivative` is dx/du of the cell.
namespace reye::fem {

/// A cell with n nodes (4 in first order, 8 in second; unused ones zero): positions on X and displacements.
template <int n>
struct CellState {
  Eigen::Matrix<double, n, 2> X = Eigen::Matrix<double, n, 2>::Zero();
  Eigen::Matrix<double, 2 * n, 1> u = Eigen::Matrix<double, 2 * n, 1>::Zero();
};

/// F0 of the Gauss points of a cell, or none.
using CellPrestrain = std::span<const material::Gradient<double>>;

/// At most four Gauss points of a cell.
template <class Sample>
struct Samples {
  std::array<Sample, 4> points;
  int count = 0;
};

inline bool barred(const Solid& solid, mesh::CellKind kind) {
  return solid.cure && kind == mesh::CellKind::quad4 && solid.analysis != Analysis::plane_stress;
}

/// x = (eps_11, eps_22, gamma_12, eps_33) = B u with the B of `strain_points`; stress sigma.
struct SmallStrain {
  static constexpr int inputs = 4, stresses = 4;

  template <int n>
  struct Sample {
    Eigen::Matrix<double, 4, 1> x;
    Eigen::Matrix<double, 4, 2 * n> B;
    double volume = 0.0;
  };

  template <int n>
  static Samples<Sample<n>> samples(const Mesh& mesh, int cell, const Solid& solid, const CellState<n>& state,
                                    CellPrestrain) {
    const CellStrains<n> strains = strain_points<n>(mesh, cell, solid.analysis, solid.cure);
    Samples<Sample<n>> s;
    for (s.count = 0; s.count < strains.count; ++s.count) {
      auto& p = s.points[s.count];
      p.B = strains.points[s.count].B;
      p.x = p.B.lazyProduct(state.u);
      p.volume = strains.points[s.count].volume;
    }
    return s;
  }

  template <int n>
  static void add_force(const Sample<n>& p, const Eigen::Matrix<double, 4, 1>& s, Eigen::Matrix<double, 2 * n, 1>& f) {
    f += p.B.transpose().lazyProduct(s);
  }

  template <int n>
  static const Eigen::Matrix<double, 4, 2 * n>& derivative(const Samples<Sample<n>>&, const Sample<n>& p) {
    return p.B;
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

  /// dN/dX and N/R of the nodes of a cell at one of its points; the latter zero but in axisymmetry.
  template <int n>
  struct Gradients {
    Eigen::Matrix<double, n, 2> dN;
    Eigen::Matrix<double, n, 1> ring;

    material::Gradient<double> of(const Eigen::Matrix<double, 2 * n, 1>& u) const {
      material::Gradient<double> H{};
      for (int a = 0; a < n; ++a) {
        H[0] += u[2 * a] * dN(a, 0);
        H[1] += u[2 * a] * dN(a, 1);
        H[2] += u[2 * a + 1] * dN(a, 0);
        H[3] += u[2 * a + 1] * dN(a, 1);
        H[4] += u[2 * a] * ring[a];
      }
      return H;
    }

    /// Adds the forces on the nodes that do the work of Q on H.
    void add_transposed(const material::Gradient<double>& Q, Eigen::Matrix<double, 2 * n, 1>& f) const {
      for (int a = 0; a < n; ++a) {
        f[2 * a] += Q[0] * dN(a, 0) + Q[1] * dN(a, 1) + Q[4] * ring[a];
        f[2 * a + 1] += Q[2] * dN(a, 0) + Q[3] * dN(a, 1);
      }
    }
  };

  template <int n>
  struct Sample {
    Eigen::Matrix<double, 6, 1> x;
    double volume = 0.0;
    Gradients<n> at;
    const material::Gradient<double>* F0 = nullptr;  ///< none where X is unstressed
  };

  /// J0 at the centre as a function of u: its derivative is (H at the centre)^T `cofactor`.
  template <int n>
  struct CellSamples : Samples<Sample<n>> {
    Gradients<n> centre{Eigen::Matrix<double, n, 2>::Zero(), Eigen::Matrix<double, n, 1>::Zero()};
    material::Gradient<double> cofactor{};
  };

  template <int n>
  static CellSamples<n> samples(const Mesh& mesh, int cell, const Solid& solid, const CellState<n>& state,
                                CellPrestrain F0) {
    CellSamples<n> s;
    for (const RulePoint& point : tabulated_rule(mesh.kind)) {
      auto& p = s.points[s.count++];
      p.volume = gradients(cell, solid.analysis, state, point, p.at);
      const auto H = p.at.of(state.u);
      p.x << H[0], H[1], H[2], H[3], H[4], 0.0;
    }
    const double growth = F0.empty() ? 1.0 : start_unstressed(solid.analysis, F0, s);
    if (barred(solid, mesh.kind)) add_centre(cell, solid, state, growth, s);
    return s;
  }

  /// (H F0)^T P is H^T (P F0^T).
  template <int n>
  static void add_force(const Sample<n>& p, const Eigen::Matrix<double, 5, 1>& P, Eigen::Matrix<double, 2 * n, 1>& f) {
    if (!p.F0) return p.at.add_transposed({P[0], P[1], P[2], P[3], P[4]}, f);
    const auto& F = *p.F0;
    p.at.add_transposed({P[0] * F[0] + P[1] * F[1], P[0] * F[2] + P[1] * F[3], P[2] * F[0] + P[3] * F[1],
                         P[2] * F[2] + P[3] * F[3], P[4] * F[4]},
                        f);
  }

  template <int n>
  static Eigen::Matrix<double, 6, 2 * n> derivative(const CellSamples<n>& cell, const Sample<n>& p) {
    Eigen::Matrix<double, 6, 2 * n> dx;
    Eigen::Matrix<double, 2 * n, 1> row;
    for (int i = 0; i < 5; ++i) {
      Eigen::Matrix<double, 5, 1> unit = Eigen::Matrix<double, 5, 1>::Unit(i);
      row.setZero();
      add_force<n>(p, unit, row);
      dx.row(i) = row;
    }
    row.setZero();
    cell.centre.add_transposed(cell.cofactor, row);
    dx.row(5) = row;
    return dx;
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
  /// Returns the volume weight.
  template <int n>
  static double gradients(int cell, Analysis analysis, const CellState<n>& state, const RulePoint& point,
                          Gradients<n>& at) {
    const auto dN_dxi = point.dN_dxi.template topRows<n>();
    const Eigen::Matrix2d J = dN_dxi.transpose().lazyProduct(state.X);  // row i: dX/dxi_i
    const double det = J.determinant();
    if (!(det > 0.0)) throw base::MeshError("cell " + std::to_string(cell) + " has a Jacobian that is not positive");
    at.dN = dN_dxi.lazyProduct(Eigen::Matrix2d(J.inverse().transpose()));
    const double R = point.N.template head<n>().dot(state.X.col(0));
    if (analysis == Analysis::axisymmetric)
      at.ring = point.N.template head<n>() / R;
    else
      at.ring.setZero();
    return point.at.weight * det * base::out_of_plane(analysis, R);
  }

  /// Content per content of unstressed material; the thickness of plane stress is counted as it was unstressed.
  static double content(Analysis analysis, const material::Gradient<double>& F0) {
    return material::plane_determinant(F0) * (analysis == Analysis::plane_stress ? 1.0 : F0[4]);
  }

  /// Makes (I + H) F0 - I = H F0 + F0 - I of H. Returns the growth of the cell from unstressed to X.
  template <int n>
  static double start_unstressed(Analysis analysis, CellPrestrain F0, CellSamples<n>& s) {
    double on_X = 0.0, unstressed = 0.0;
    for (int g = 0; g < s.count; ++g) {
      const auto& F = F0[g];
      auto& p = s.points[g];
      p.F0 = &F;
      const auto start = material::without_unit(F);
      const double H11 = p.x[0], H12 = p.x[1], H21 = p.x[2], H22 = p.x[3];
      p.x[0] = H11 * F[0] + H12 * F[2] + start[0];
      p.x[1] = H11 * F[1] + H12 * F[3] + start[1];
      p.x[2] = H21 * F[0] + H22 * F[2] + start[2];
      p.x[3] = H21 * F[1] + H22 * F[3] + start[3];
      p.x[4] = p.x[4] * F[4] + start[4];
      on_X += p.volume;
      p.volume /= content(analysis, F);
      unstressed += p.volume;
    }
    return on_X / unstressed;
  }

  /// J0 - 1, equal at all points, and its derivative.
  template <int n>
  static void add_centre(int cell, const Solid& solid, const CellState<n>& state, double growth, CellSamples<n>& s) {
    gradients(cell, solid.analysis, state, centre_of_quad4(), s.centre);
    const auto H = s.centre.of(state.u), F = material::with_unit(H);
    s.cofactor = {F[4] * F[3], -F[4] * F[2], -F[4] * F[1], F[4] * F[0], material::plane_determinant(F)};
    for (double& entry : s.cofactor) entry *= growth;
    for (int g = 0; g < s.count; ++g) s.points[g].x[5] = growth * material::dilation(H) + (growth - 1.0);
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
