#include "fit/markov.hpp"

#include <cmath>

namespace reye::fit {

namespace {

template <int D>
using Square = Eigen::Matrix<double, D, D>;

/// State (u, u'/lambda, u''/lambda^2) of a Matern process; N = companion + 1 is nilpotent, so that its exponential
/// is a polynomial.
template <int D>
struct Process {
  Square<D> N = Square<D>::Zero(), stationary = Square<D>::Identity();
  Process() {
    if constexpr (D == 2) N << 1, 1, -1, -1;
    if constexpr (D == 3) {
      N << 1, 1, 0, 0, 1, 1, -1, -3, -2;
      stationary << 1, 0, -1.0 / 3, 0, 1.0 / 3, 0, -1.0 / 3, 0, 1;
    }
  }
  Square<D> transition(double s) const {
    Square<D> T = Square<D>::Identity();
    if constexpr (D > 1) T += s * N;
    if constexpr (D > 2) T += 0.5 * s * s * N * N;
    return std::exp(-s) * T;
  }
};

template <int D>
Whitened filter(const Blocks& blocks, double lambda, double nugget, Matrix columns) {
  const Process<D> process;
  const Eigen::Index rows = columns.rows();
  Eigen::Matrix<double, D, Eigen::Dynamic> state = Eigen::Matrix<double, D, Eigen::Dynamic>::Zero(D, columns.cols());
  Square<D> P = process.stationary, T = process.transition(0.0), Q = Square<D>::Zero();
  Eigen::Matrix<double, D, 1> gain;
  double step = -1.0, variance = 0.0, logs = 0.0;
  bool steady = false;  // the gain no longer changes while distance and count do not
  Eigen::RowVectorXd innovation(columns.cols());
  for (Eigen::Index i = 0; i < rows; ++i) {
    if (!steady) {
      gain = P.col(0);
      const double before = variance;
      variance = gain[0] + nugget / blocks.count[i];
      gain /= variance;
      P -= gain * P.row(0);
      steady = i > 0 && std::abs(variance - before) < 1e-10 * variance;
    }
    innovation = columns.row(i) - state.row(0);
    columns.row(i) = innovation / std::sqrt(variance);
    logs += std::log(variance);
    state += gain * innovation;
    if (i + 1 == rows) break;
    const double next = lambda * (blocks.at[i + 1] - blocks.at[i]).norm();
    if (std::abs(next - step) > 1e-6 * step || blocks.count[i + 1] != blocks.count[i]) steady = false;
    if (next != step) {
      T = process.transition(next);
      Q = process.stationary - T * process.stationary * T.transpose();
      step = next;
    }
    state = (T * state).eval();
    if (!steady) P = (T * P * T.transpose() + Q).eval();
  }
  return {std::move(columns), logs};
}

}  // namespace

Whitened whiten_along(const Blocks& blocks, const Noise& noise, Matrix columns) {
  const double lambda = std::sqrt(2.0 * noise.order + 1.0) / noise.length_mm;
  if (noise.order == 0) return filter<1>(blocks, lambda, noise.nugget, std::move(columns));
  if (noise.order == 1) return filter<2>(blocks, lambda, noise.nugget, std::move(columns));
  return filter<3>(blocks, lambda, noise.nugget, std::move(columns));
}

}  // namespace reye::fit
