#include "algebra/sparse_lu.hpp"

#include <umfpack.h>

#include <array>
#include <string>

#include "algebra/blas.hpp"
#include "base/errors.hpp"

namespace reye::algebra {

using base::SolveError;
using base::SparseMatrix;
using base::Vector;

namespace {

/// Smallest ratio of pivots of the scaled matrix; below it the solution would have lost all but two digits.
constexpr double smallest_pivot_ratio = 1e-14;

using Control = std::array<double, UMFPACK_CONTROL>;
using Info = std::array<double, UMFPACK_INFO>;

Control control() {
  Control c;
  umfpack_di_defaults(c.data());
  c[UMFPACK_IRSTEP] = 0;  // Newton's next step refines anyway
  return c;
}

void check(int status, const char* task) {
  if (status == UMFPACK_OK) return;
  if (status == UMFPACK_ERROR_out_of_memory) throw SolveError(std::string(task) + ": out of memory");
  if (status == UMFPACK_WARNING_singular_matrix)
    throw SolveError(std::string(task) + ": the matrix is singular; a rigid motion may be unconstrained");
  throw SolveError(std::string(task) + ": UMFPACK status " + std::to_string(status));
}

}  // namespace

void SparseLu::FreeSymbolic::operator()(void* p) const { umfpack_di_free_symbolic(&p); }
void SparseLu::FreeNumeric::operator()(void* p) const { umfpack_di_free_numeric(&p); }

void SparseLu::factorise(const SparseMatrix& A, bool same_pattern) {
  single_thread();
  size_ = static_cast<int>(A.rows());
  numeric_.reset();
  const Control c = control();
  Info info;
  void* made = nullptr;
  if (!same_pattern || !symbolic_) {
    symbolic_.reset();
    const int status = umfpack_di_symbolic(size_, size_, A.outerIndexPtr(), A.innerIndexPtr(), A.valuePtr(), &made,
                                           c.data(), info.data());
    symbolic_.reset(made);
    check(status, "symbolic analysis");
  }
  const int status = umfpack_di_numeric(A.outerIndexPtr(), A.innerIndexPtr(), A.valuePtr(), symbolic_.get(), &made,
                                        c.data(), info.data());
  numeric_.reset(made);
  check(status, "sparse LU");
  if (!(info[UMFPACK_RCOND] > smallest_pivot_ratio))
    throw SolveError("sparse LU: the matrix is singular to working precision; a rigid motion may be unconstrained");
}

Vector SparseLu::solve(const SparseMatrix& A, const Vector& b) const {
  Vector x(size_);
  const Control c = control();
  Info info;
  check(umfpack_di_solve(UMFPACK_A, A.outerIndexPtr(), A.innerIndexPtr(), A.valuePtr(), x.data(), b.data(),
                         numeric_.get(), c.data(), info.data()),
        "triangular solve");
  return x;
}

SparseLu::Factors SparseLu::factors() const {
  int l_count = 0, u_count = 0, rows = 0, columns = 0, diagonal = 0, reciprocal = 0;
  check(umfpack_di_get_lunz(&l_count, &u_count, &rows, &columns, &diagonal, numeric_.get()), "factors");
  Factors f{Factors::Rows(size_, size_), Factors::Rows(size_, size_), std::vector<int>(static_cast<size_t>(size_)),
            std::vector<int>(static_cast<size_t>(size_)), Vector(size_)};
  f.lower.resizeNonZeros(l_count);
  f.upper_transposed.resizeNonZeros(u_count);
  check(umfpack_di_get_numeric(f.lower.outerIndexPtr(), f.lower.innerIndexPtr(), f.lower.valuePtr(),
                               f.upper_transposed.outerIndexPtr(), f.upper_transposed.innerIndexPtr(),
                               f.upper_transposed.valuePtr(), f.row.data(), f.column.data(), nullptr, &reciprocal,
                               f.scale.data(), numeric_.get()),
        "factors");
  if (!reciprocal) f.scale = f.scale.cwiseInverse();
  return f;
}

}  // namespace reye::algebra
