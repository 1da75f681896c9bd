#include "algebra/factor_cost.hpp"

#include "algebra/schur_analysis.hpp"

namespace reye::algebra {

FactorCost factor_cost(SparseMatrix graph, int retained, int block) {
  std::vector<int> order = retained_last(graph, retained, Ordering::nested_dissection);
  Fill fill;
  analyse(graph, order, &fill);
  const double b = block;
  return {b * b * fill.entries, b * b * b * fill.flops};
}

}  // namespace reye::algebra
