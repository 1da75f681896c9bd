#pragma once
#include <memory>
#include <vector>

#include "algebra/ordering.hpp"
#include "base/linalg.hpp"

namespace reye::algebra {

using base::Matrix;
using base::SparseMatrix;
using base::Vector;

/// The symbolic analysis of a matrix: a handle, shared by factors of a pattern; may be empty.
struct SchurAnalysis;
using SchurAnalysisPtr = std::shared_ptr<const SchurAnalysis>;

/// Symmetric positive (semi-)definite K, split into interior i (first) and retained c (the last `retained`
/// rows), factorised once with c kept last and a positive shift sigma = diag K_cc added to that diagonal:
///   S = K_cc - K_ci K_ii^-1 K_ic = L_cc L_cc^T - sigma        (theory: exact whatever rigid motion is free)
/// The symbolic analysis is kept: `refactor` with the same pattern reuses it, and so does a factor that is given it.
/// Where the shift is on chosen rows alone, S + sigma is inverted from L_cc, and S itself is not made.
class SchurFactor {
 public:
  /// K: n x n, its upper triangle is read; a temporary is released before the factor is made. `known`:
  /// the analysis of another factor, used where it fits. Throws base::SolveError when K_ii is not positive definite.
  SchurFactor(SparseMatrix K, int retained, SchurAnalysisPtr known = {}, Ordering ordering = Ordering::minimum_degree);
  /// The shift on these rows, counted from the first one retained. Throws base::SolveError where S + sigma is not
  /// definite, too.
  SchurFactor(SparseMatrix K, int retained, Ordering ordering, std::vector<int> shifted);
  ~SchurFactor();
  SchurFactor(SchurFactor&&) noexcept;
  SchurFactor& operator=(SchurFactor&&) noexcept;

  void refactor(const SparseMatrix& K);
  void refactor(const SparseMatrix& K, std::vector<int> shifted);
  const SchurAnalysisPtr& analysis() const;  ///< empty where nothing is eliminated
  int size() const;
  int retained() const;
  const Matrix& schur() const;  ///< retained x retained, symmetric, both triangles; empty with a shift on chosen rows

  /// The leading rows and columns of S + sigma, inverted.
  struct Inverse {
    Matrix C;                ///< both triangles
    double condition = 0.0;  ///< largest product of a diagonal entry of C and that of the matrix
  };
  /// With a shift on chosen rows: once, of the first `count` rows retained. Throws base::SolveError where the matrix is
  /// not definite.
  Inverse take_inverse(int count);
  /// With a shift on chosen rows, before `take_inverse`: the last rows of S, from one on; few, else `schur` is cheaper.
  Matrix schur_rows(int first) const;

  /// f_c - K_ci K_ii^-1 f_i for a full load vector f (size n): one forward solve.
  Vector condense(const Vector& f) const;
  /// (K + sigma) x = b of the leading rows, as many as b has: all of the interior at least. Where `has_whole`.
  Vector solve_leading(const Vector& b) const;
  /// Whether L of all rows is here: not where several processes hold it, or nothing was eliminated.
  bool has_whole() const;
  /// The full solution (size n) for loads f and known retained values u_c.
  Vector recover(const Vector& f, const Vector& u_c) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Processes that hold the factor of a solid with so many rows to eliminate: all ranks (ranks.hpp), or one where it is
/// small.
int ranks_of(int interior);

/// Plain sparse Cholesky of a symmetric positive definite matrix, factor kept.
class Cholesky {
 public:
  explicit Cholesky(const SparseMatrix& K);
  ~Cholesky();
  Cholesky(Cholesky&&) noexcept;
  Cholesky& operator=(Cholesky&&) noexcept;
  Matrix solve(const Matrix& rhs) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// LU of a dense square matrix with partial pivoting (LAPACK), rows and columns scaled before. Work space is kept.
class DenseFactor {
 public:
  /// Takes the storage of A, whose content is then undefined. Throws base::SolveError when A is singular to working
  /// precision.
  void factor(Matrix& A);

  /// x of A x = b, or of A^T x = b. Throws base::SolveError when x is not finite.
  Vector solve(const Vector& b) const { return solve(b, "N"); }
  Matrix solve_columns(Matrix B) const;  ///< A^-1 B
  Vector solve_transposed(const Vector& b) const { return solve(b, "T"); }

 private:
  Vector solve(const Vector& b, const char* trans) const;
  Matrix LU_;
  Vector rows_, columns_, work_;
  std::vector<int> pivots_, iwork_;
};

/// Cholesky factor of a dense symmetric positive definite matrix (LAPACK).
class DenseCholesky {
 public:
  DenseCholesky() = default;
  /// Throws base::SolveError when A is not definite.
  explicit DenseCholesky(Matrix A);

  Vector solve(Vector b) const;
  /// Puts A^-1 B in place of B and returns B^T A^-1 B, symmetric bit by bit.
  Matrix condense(Matrix& B) const;
  double log_determinant() const;  ///< of A

 private:
  Matrix L_;
};

/// Replaces a dense symmetric positive definite matrix by its inverse, both triangles.
/// Throws base::SolveError when A is not definite.
void invert(Matrix& A);
/// As `invert`; throws base::SolveError also where A is definite by round-off alone, as a stiffness is that nothing
/// holds: its inverse has to return a vector to eight digits.
void invert_held(Matrix& A);
/// Replaces the Cholesky factor L of A, a lower triangle, by A^-1, both triangles.
void invert_from_factor(Matrix& L);
/// Puts the lower triangle of a square matrix into its upper one.
void mirror_lower(Matrix& A);

/// Solves the dense square system A x = b; A is overwritten.
/// Throws base::SolveError when A is singular to working precision or x is not finite.
Vector solve_dense(Matrix& A, const Vector& b);

}  // namespace reye::algebra
