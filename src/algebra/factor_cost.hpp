#pragma once
#include "base/linalg.hpp"

namespace reye::algebra {

/// What a factorisation with `retained` rows last would take.
struct FactorCost {
  double entries = 0.0;  ///< of L
  double flops = 0.0;
};
/// From the graph of nodes alone (upper triangle, the nodes retained last), each of `block` dofs: nested dissection and
/// symbolic analysis.
FactorCost factor_cost(base::SparseMatrix graph, int retained, int block);

}  // namespace reye::algebra
