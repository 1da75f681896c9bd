#pragma once
#include <algorithm>
#include <vector>

#include "fem/stiffness.hpp"
#include "sim/problem/problem.hpp"
#include "sim/problem/state.hpp"

/// Common parts of the benches that count in plain factorisations.
namespace reye::bench {

inline double median(std::vector<double> v) {
  const auto middle = v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2);
  std::nth_element(v.begin(), middle, v.end());
  return *middle;
}

/// The stiffness of a body in its present shape; a millionth of its diagonal holds the rigid motions.
inline base::SparseMatrix held_stiffness(const sim::Problem& problem, const sim::State& state, int body) {
  const auto& input = problem.inputs[body];
  auto K = fem::stiffness(state.shapes[body]->mesh, input.material, problem.scene.analysis, input.b_bar);
  const double mean = K.diagonal().mean();
  for (Eigen::Index i = 0; i < K.rows(); ++i) K.coeffRef(i, i) += 1e-6 * mean;
  return K;
}

}  // namespace reye::bench
