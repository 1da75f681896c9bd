#pragma once
#include <cmath>
#include <stdexcept>
#include <vector>

#include "algebra/factor.hpp"
#include "base/linalg.hpp"

/// A line contact of two half-planes of one material, with friction, under a constant normal force P and a cyclic
/// tangential force +-Q < mu P, and what it wears. It shares nothing with Reye's own contact: an independent reference.
///
/// Equal materials do not couple: pressure p moves the surfaces apart, shear q along one another by the same law,
///     u(x) = -2 / (pi E*) int p(s) ln|x - s| ds + constant,   1 / E* = 2 (1 - nu^2) / E                         (1)
///     pressed:  gap = shape + u[p] - approach >= 0,  p >= 0,  p gap = 0,  int p = P                             (2)
///     sheared:  slip = drift - u[q] >= 0,  q <= mu p,  (mu p - q) slip = 0,  int q = Q                          (3)
///
/// *Energy.* Between -Q and Q the change of q is bounded by 2 mu p, so that by (3), which is of first degree in
/// (q, mu p, Q, slip), a point slips by twice the slip s of a first loading to Q, there and back: 4 s a cycle, against
/// mu p. Reye's law takes alpha per work, of both bodies together:
///     dw/dN = 4 alpha mu p s                                                                                    (4)
/// *Slip.* With r = mu p - q, (3) is (2) for r / mu on the shape -u[p] at the load P - Q / mu; and where p > 0, (2)
/// says -u[p] = shape - approach. Hence (Ciavarella 1998, Jaeger 1998) s = mu G, where G is the gap of the same worn
/// shape pressed by P - Q / mu, and
///     dw/dN = 4 alpha mu^2 p G                                                                                  (5)
/// *Limit.* Where G = 0 nothing wears, so the pressure of P - Q / mu never changes: G = G_0 + w, and the stick zone is
/// that of the unworn contact for ever. Wear ends when p G = 0: all of P within the stick zone, which is the limit
/// profile of Ciavarella and Hills (1999).
namespace reye::half_plane {

using base::Matrix;
using base::Vector;

/// The points of one half of a symmetric contact, evenly spaced from x = 0. Tractions are linear between them.
struct Grid {
  Vector x;
  Vector width;  ///< integral of each point's hat and of its mirror image
  Matrix u;      ///< (1) of unit tractions at each point and its mirror image
};

/// The integral of hat and logarithm is exact: hat'' = (delta(-h) - 2 delta(0) + delta(h)) / h, and x^2 ln|x| / 2 - 3
/// x^2 / 4 is the second integral of ln|x|.
inline Grid make_grid(double half_width, int cells, double E_star) {
  const double h = half_width / cells;
  const auto twice = [](double x) { return x == 0.0 ? 0.0 : x * x * (0.5 * std::log(std::abs(x)) - 0.75); };
  const auto hat = [&](double x) {
    return -2.0 / (M_PI * E_star) * (twice(x + h) - 2.0 * twice(x) + twice(x - h)) / h;
  };
  Grid grid{Vector::LinSpaced(cells + 1, 0.0, half_width), Vector::Constant(cells + 1, 2.0 * h),
            Matrix(cells + 1, cells + 1)};
  grid.width[0] = h;
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j <= cells; ++j)
      grid.u(i, j) = hat(grid.x[i] - grid.x[j]) + (j == 0 ? 0.0 : hat(grid.x[i] + grid.x[j]));
  return grid;
}

struct Pressed {
  Vector p;  ///< at the points
  Vector gap;
  double approach = 0.0;
};

/// (2) with a layer in the gap whose thickness grows by `soft` times the pressure; only points where `may` is positive
/// can touch.
inline Pressed press(const Grid& grid, const Vector& shape, double load, const Vector& soft, const Vector& may) {
  const auto n = static_cast<int>(grid.x.size());
  std::vector<char> touches(n);
  for (int i = 0; i < n; ++i) touches[i] = may[i] > 0.0;
  for (int iteration = 0; iteration < 200; ++iteration) {
    std::vector<int> in;
    for (int i = 0; i < n; ++i)
      if (touches[i]) in.push_back(i);
    const auto m = static_cast<int>(in.size());
    Matrix A = Matrix::Zero(m + 1, m + 1);
    A.topLeftCorner(m, m) = grid.u(in, in);
    A.topLeftCorner(m, m).diagonal() += soft(in);
    A.col(m).head(m).setConstant(-1.0);
    A.row(m).head(m) = grid.width(in);
    Vector b(m + 1);
    b << -shape(in), load;
    const Vector solution = algebra::solve_dense(A, b);
    Pressed found{Vector::Zero(n), {}, solution[m]};
    found.p(in) = solution.head(m);
    found.gap = grid.u * found.p + shape + soft.cwiseProduct(found.p) - Vector::Constant(n, found.approach);
    bool changed = false;
    for (int i = 0; i < n; ++i) {
      const bool touch = touches[i] ? found.p[i] > 0.0 : may[i] > 0.0 && found.gap[i] < 0.0;
      changed = changed || touch != static_cast<bool>(touches[i]);
      touches[i] = touch;
    }
    if (changed) continue;
    found.gap(in).setZero();
    return found;
  }
  throw std::runtime_error("half-plane: the contact zone does not settle");
}

inline Pressed press(const Grid& grid, const Vector& shape, double load) {
  return press(grid, shape, load, Vector::Zero(shape.size()), Vector::Ones(shape.size()));
}

struct Sheared {
  Vector q;
  Vector slip;  ///< where nothing touches: how far the surfaces pass one another
};

/// (3), first loading: the friction that is left, limit - q, takes the place of the pressure in (2).
inline Sheared shear(const Grid& grid, const Vector& limit, double force) {
  const Vector zero = Vector::Zero(limit.size());
  const auto left = press(grid, -grid.u * limit, grid.width.dot(limit) - force, zero, limit);
  return {limit - left.p, left.gap};
}

struct Load {
  double P, Q, mu;
};

struct Worn {
  Vector depth;    ///< of both bodies together
  Vector p, slip;  ///< half way through the last step: pressure, and the amplitude s of the slip
};

/// The depth after `wear` = alpha N [mm^2/N], by the implicit midpoint rule in steps that grow linearly: (4) with the
/// pressure of the middle in the gap's own equations (`soft`) and the slip found by repetition.
inline Worn wear(const Grid& grid, const Vector& shape, const Load& load, double wear, int steps) {
  const auto n = shape.size();
  Worn state{Vector::Zero(n), {}, {}};
  const Vector all = Vector::Ones(n);
  state.slip = shear(grid, load.mu * press(grid, shape, load.P).p, load.Q).slip;
  for (int k = 0; k < steps; ++k) {
    const double step = wear * (2.0 * k + 1.0) / (static_cast<double>(steps) * steps);
    Vector gained = Vector::Zero(n), before;
    for (int repeat = 0; repeat == 0 || (gained - before).cwiseAbs().maxCoeff() > 1e-6 * gained.maxCoeff(); ++repeat) {
      if (repeat == 50) throw std::runtime_error("half-plane: the slip of a step does not settle");
      before = gained;
      const Vector soft = 2.0 * step * load.mu * state.slip;
      state.p = press(grid, shape + state.depth, load.P, soft, all).p;
      gained = 2.0 * soft.cwiseProduct(state.p);
      state.slip = shear(grid, load.mu * state.p, load.Q).slip;
    }
    state.depth += gained;
  }
  return state;
}

/// Area worn off, both halves.
inline double area(const Grid& grid, const Vector& depth) { return grid.width.dot(depth); }

}  // namespace reye::half_plane
