#pragma once
#include <cholmod.h>

#include <memory>
#include <span>
#include <vector>

#include "base/linalg.hpp"

namespace reye::algebra {

/// The library's settings and its memory.
class Workspace {
 public:
  Workspace();
  ~Workspace() { cholmod_finish(&common); }
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  /// Throws base::SolveError where the last call failed; `factor`: the one it was about, if any.
  void check(const char* task, const cholmod_factor* factor = nullptr) const;

  cholmod_common common;
};

/// Order of elimination and fill of a pattern, without numbers; never changed, shared by all factors of the pattern.
using Symbolic = std::shared_ptr<cholmod_factor>;

/// What an analysis has counted.
struct Fill {
  double entries = 0.0, flops = 0.0;
};

/// Analyses the upper triangle of K; no function here reads the lower one. `order` empty: AMD with postordering; else
/// the given elimination order, kept as it is. `fill`: receives the size of the factor.
Symbolic analyse(base::SparseMatrix& K, std::span<int> order, Fill* fill = nullptr);

/// Supernodal Cholesky P K P^T = L L^T of a symmetric sparse matrix by CHOLMOD, which is called here alone.
/// Every failure is a base::SolveError.
class Supernodal {
 public:
  Supernodal() = default;
  ~Supernodal() { release(); }
  Supernodal(const Supernodal&) = delete;
  Supernodal& operator=(const Supernodal&) = delete;

  /// To be called before `factorise`, once for each pattern.
  void start(const Symbolic& symbolic);
  /// Numeric factorisation with the pattern it was started with.
  void factorise(base::SparseMatrix& K);

  /// Solves K x = b for all columns of b.
  base::Matrix solve(const base::Matrix& b);
  /// Solves L y = b and L^T y = b in the order of elimination (no permutation).
  base::Vector forward(const base::Vector& b) { return triangular(CHOLMOD_L, b); }
  base::Vector backward(const base::Vector& b) { return triangular(CHOLMOD_Lt, b); }

  /// Elimination order: order()[k] is the row of K eliminated as k-th.
  std::span<const int> order() const;
  base::Vector diagonal() const;  ///< of L, in the order of elimination
  /// Dense lower triangle of the leading `size` of the last `count` rows and columns of L.
  base::Matrix trailing(int count, int size) const;
  /// The last rows of L from `first`, in the last `count` columns: dense.
  base::Matrix trailing_rows(int count, int first) const;
  /// L_cc v and L_cc^T v of the last rows and columns, as many as v has.
  base::Vector times_trailing(const base::Vector& v) const;
  base::Vector times_trailing_transposed(const base::Vector& v) const;

 private:
  base::Vector triangular(int system, const base::Vector& b);
  base::Matrix dense_solve(int system, const double* b, int columns);
  void release();
  template <class Take>
  void for_each_trailing(int count, Take take) const;

  Workspace workspace_;
  cholmod_factor* factor_ = nullptr;
};

/// Fill-reducing order (approximate minimum degree) of the leading `count` rows of K, upper triangle or both.
std::vector<int> minimum_degree(const base::SparseMatrix& K, int count);

/// Fill-reducing order of the same rows by METIS's nested dissection. Neighbouring rows with the same entries, as those
/// of a node, are one point of the graph and follow one another in the order. K: upper triangle.
std::vector<int> nested_dissection(const base::SparseMatrix& K, int count);

}  // namespace reye::algebra
