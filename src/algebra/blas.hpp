#pragma once

// The few BLAS and LAPACK routines used (Fortran calling convention, column-major, 32-bit integers).
extern "C" {
void openblas_set_num_threads(int count);
int openblas_get_num_threads(void);
void omp_set_max_active_levels(int count);
int omp_get_max_active_levels(void);
void dlauum_(const char* uplo, const int* n, double* a, const int* lda, int* info);
void dgemm_(const char* transa, const char* transb, const int* m, const int* n, const int* k, const double* alpha,
            const double* a, const int* lda, const double* b, const int* ldb, const double* beta, double* c,
            const int* ldc);
void dgemv_(const char* trans, const int* m, const int* n, const double* alpha, const double* a, const int* lda,
            const double* x, const int* incx, const double* beta, double* y, const int* incy);
void dsyrk_(const char* uplo, const char* trans, const int* n, const int* k, const double* alpha, const double* a,
            const int* lda, const double* beta, double* c, const int* ldc);
void dtrsm_(const char* side, const char* uplo, const char* transa, const char* diag, const int* m, const int* n,
            const double* alpha, const double* a, const int* lda, double* b, const int* ldb);
void dpotrf_(const char* uplo, const int* n, double* a, const int* lda, int* info);
void dpotri_(const char* uplo, const int* n, double* a, const int* lda, int* info);
void dpotrs_(const char* uplo, const int* n, const int* nrhs, const double* a, const int* lda, double* b,
             const int* ldb, int* info);
void dgetrf_(const int* m, const int* n, double* a, const int* lda, int* pivots, int* info);
void dlaswp_(const int* columns, double* a, const int* lda, const int* first, const int* last, const int* pivots,
             const int* step);
void dgetrs_(const char* trans, const int* n, const int* nrhs, const double* a, const int* lda, const int* pivots,
             double* b, const int* ldb, int* info);
void dsyev_(const char* jobz, const char* uplo, const int* n, double* a, const int* lda, double* w, double* work,
            const int* lwork, int* info);
void dgesvd_(const char* jobu, const char* jobvt, const int* m, const int* n, double* a, const int* lda, double* s,
             double* u, const int* ldu, double* vt, const int* ldvt, double* work, const int* lwork, int* info);
void dgelsy_(const int* m, const int* n, const int* nrhs, double* a, const int* lda, double* b, const int* ldb,
             int* pivots, const double* rcond, int* rank, double* work, const int* lwork, int* info);
void dgeqp3_(const int* m, const int* n, double* a, const int* lda, int* pivots, double* tau, double* work,
             const int* lwork, int* info);
void dgecon_(const char* norm, const int* n, const double* a, const int* lda, const double* anorm, double* rcond,
             double* work, int* iwork, int* info);
}

namespace reye::algebra {

/// BLAS and CHOLMOD on the thread that calls: on shared cores more threads cost up to ten times the time, and results
/// then depend on their number. CHOLMOD's parallel regions ask for four threads each, one region per supernode,
/// whatever OMP_NUM_THREADS says: where no level may be active, the caller alone executes them (a fifth of the
/// time of a short run). To be called before any factorisation; later calls cost nothing.
inline void single_thread() {
  static thread_local const bool done = (openblas_set_num_threads(1), omp_set_max_active_levels(0), true);
  (void)done;
}

/// BLAS and CHOLMOD on one thread until it is destroyed, when the numbers before it hold again: for a program that
/// computes with them for itself, too.
class SingleThread {
 public:
  SingleThread() : blas_(openblas_get_num_threads()), levels_(omp_get_max_active_levels()) {
    single_thread();  // it does its work once in a thread, and later calls of others must not do it
    openblas_set_num_threads(1);
    omp_set_max_active_levels(0);
  }
  ~SingleThread() {
    openblas_set_num_threads(blas_);
    omp_set_max_active_levels(levels_);
  }
  SingleThread(const SingleThread&) = delete;
  SingleThread& operator=(const SingleThread&) = delete;

 private:
  int blas_, levels_;
};

}  // namespace reye::algebra
