#include "algebra/ranks.hpp"

#define OMPI_SKIP_MPICXX  // its C++ interface asks for a library of its own
#include <dmumps_c.h>
#include <mpi.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

#include "algebra/blas.hpp"
#include "algebra/supernodal.hpp"
#include "base/errors.hpp"
#include "base/formatted.hpp"

namespace reye::algebra {

using base::Matrix;
using base::SolveError;
using base::SparseMatrix;
using base::Vector;

namespace {

/// Jobs of MUMPS, by its own numbers, and the end.
enum class Job { end = 0, analyse = 1, factorise = 2, solve = 3, initialise = -1, release = -2 };

/// What the first rank asks of the others: a job for the factor with a number.
struct Order {
  Job job = Job::end;
  int factor = 0;
};

/// Processes are a matter of the whole program, as cores are (base/cores.hpp).
int joined = 1, here = 1;
int made = 0;       // factors, by which their numbers differ
std::mutex asking;  // MPI and MUMPS take one call at a time

/// Waits without keeping a core busy: the others have nothing to do for most of a run.
void broadcast(Order& order) {
  MPI_Request request;
  std::array<int, 2> words{static_cast<int>(order.job), order.factor};
  MPI_Ibcast(words.data(), 2, MPI_INT, 0, MPI_COMM_WORLD, &request);
  auto pause = std::chrono::microseconds(10);
  for (int arrived = 0; MPI_Test(&request, &arrived, MPI_STATUS_IGNORE), !arrived;) {
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, std::chrono::microseconds(1000));
  }
  order = {Job(words[0]), words[1]};
}

int& icntl(DMUMPS_STRUC_C& id, int k) { return id.icntl[k - 1]; }

/// The part of one rank in a factor.
struct Part {
  DMUMPS_STRUC_C id{};

  void play(Job job) {
    if (job == Job::initialise) {
      id.par = 1;
      id.sym = 1;
      id.comm_fortran = MPI_Comm_c2f(MPI_COMM_WORLD);
    }
    id.job = static_cast<int>(job);
    dmumps_c(&id);
    if (job != Job::initialise) return;
    for (int k : {1, 2, 3}) icntl(id, k) = -1;  // silent: failures are read from infog
    icntl(id, 4) = 0;
    icntl(id, 8) = 0;  // no scaling: pivots are those of the matrix
    icntl(id, 14) = 30;
  }
};

void serve() {
  single_thread();
  std::map<int, Part> parts;
  for (Order order;;) {
    broadcast(order);
    if (order.job == Job::end) return;
    parts[order.factor].play(order.job);
    if (order.job == Job::release) parts.erase(order.factor);
  }
}

/// Variables of a program that mpirun has started as one of several.
constexpr std::array told{"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_SIZE"};

SolveError not_definite() {
  return SolveError(
      "sparse Cholesky on several ranks: the matrix is not positive definite; a rigid motion may be unconstrained");
}

}  // namespace

int ranks() { return joined; }
int ranks_here() { return here; }

Ranks::Ranks() {
  bool several = false;
  for (const char* name : told) several = several || std::getenv(name);
  if (!several) return;
  int given = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &given);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &joined);
  MPI_Comm machine;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  MPI_Comm_size(machine, &here);
  MPI_Comm_free(&machine);
  if (rank == 0) {
    for (const char* name : told) ::unsetenv(name);  // programs that this one starts are none of the ranks
    return;
  }
  serve();
  served_ = true;
  MPI_Finalize();
}

Ranks::~Ranks() {
  int begun = 0;
  MPI_Initialized(&begun);
  if (served_ || !begun) return;
  Order order;
  broadcast(order);
  MPI_Finalize();
  joined = here = 1;
}

struct RankedFactor::Impl {
  mutable Part part;
  int number = 0, size = 0, retained = 0;
  std::vector<int> row, column, last, place;
  std::vector<double> value;
  Matrix S;

  void play(Job job) const {
    Order order{job, number};
    broadcast(order);
    part.play(job);
  }

  /// All entries with 1-based rows and columns; positions of the retained ones.
  void read(const SparseMatrix& upper) {
    row.reserve(static_cast<std::size_t>(upper.nonZeros()));
    column.reserve(row.capacity());
    value.reserve(row.capacity());
    for (int j = 0; j < upper.outerSize(); ++j)
      for (SparseMatrix::InnerIterator it(upper, j); it; ++it) {
        row.push_back(static_cast<int>(it.row()) + 1);
        column.push_back(j + 1);
        value.push_back(it.value());
      }
    for (int c = size - retained; c < size; ++c) last.push_back(c + 1);
    const std::vector<int> order = nested_dissection(upper, size - retained);
    place.resize(static_cast<std::size_t>(size));
    for (int k = 0; k < size; ++k) place[k < size - retained ? order[k] : k] = k + 1;
    S = Matrix::Zero(retained, retained);
    auto& id = part.id;
    id.n = size;
    id.nnz = static_cast<MUMPS_INT8>(value.size());
    icntl(id, 7) = 1;  // its own orders fill half as much again
    id.perm_in = place.data();
    id.irn = row.data();
    id.jcn = column.data();
    id.a = value.data();
    icntl(id, 19) = retained > 0 ? 1 : 0;
    id.size_schur = retained;
    id.listvar_schur = last.data();
    id.schur = S.data();
  }

  void make() {
    play(Job::analyse);
    check("analysis");
    play(Job::factorise);
    while (part.id.infog[0] == -8 || part.id.infog[0] == -9) {  // its estimate of work space was too small
      icntl(part.id, 14) *= 2;
      play(Job::factorise);
    }
    check("factorisation");
    if (part.id.infog[11] > 0) throw not_definite();           // negative pivots
    S.triangularView<Eigen::StrictlyLower>() = S.transpose();  // it writes the lower triangle by rows
    const auto drop = [](auto& list) { std::decay_t<decltype(list)>().swap(list); };
    drop(place);
    drop(row);
    drop(column);
    drop(value);
  }

  void check(const char* what) const {
    const int code = part.id.infog[0], detail = part.id.infog[1];
    if (code == -13 || code == -19 || code == -7)
      throw SolveError(base::formatted("%d ranks have too little memory for the %s of %d dofs", joined, what, size));
    if (code == -10 || code == -40) throw not_definite();
    if (code < 0) throw SolveError(base::formatted("MUMPS: %s failed with %d (%d)", what, code, detail));
  }

  /// MUMPS does not refuse a last pivot of pure round-off: the solution for K_ii times ones must be ones to four
  /// digits, as many as one process asks of its pivots (smallest_pivot_share in factor.cpp).
  void check_accuracy(const SparseMatrix& upper) const {
    Vector ones = Vector::Ones(size);
    ones.tail(retained).setZero();
    Vector f = upper.selfadjointView<Eigen::Upper>() * ones;
    f.tail(retained).setZero();
    if (!((solved(std::move(f)) - ones).head(size - retained).cwiseAbs().maxCoeff() < 1e-4))
      throw SolveError(
          "sparse Cholesky on several ranks: the matrix is singular to working precision; a rigid motion may be "
          "unconstrained");
  }

  Vector solved(Vector f) const {
    part.id.rhs = f.data();
    part.id.nrhs = 1;
    part.id.lrhs = size;
    play(Job::solve);
    check("solution");
    return f;
  }
};

RankedFactor::RankedFactor(const SparseMatrix& upper, int retained) : impl_(std::make_unique<Impl>()) {
  const std::lock_guard lock(asking);
  single_thread();
  impl_->number = ++made;
  impl_->size = static_cast<int>(upper.rows());
  impl_->retained = retained;
  impl_->play(Job::initialise);
  try {
    impl_->read(upper);
    impl_->make();
    impl_->check_accuracy(upper);
  } catch (...) {
    impl_->play(Job::release);
    throw;
  }
}

RankedFactor::~RankedFactor() {
  const std::lock_guard lock(asking);
  impl_->play(Job::release);
}

Matrix RankedFactor::take_schur() { return std::move(impl_->S); }

Vector RankedFactor::solve_interior(Vector f_i) const {
  const std::lock_guard lock(asking);
  const Eigen::Index interior = f_i.size();
  f_i.conservativeResize(impl_->size);
  f_i.tail(impl_->retained).setZero();
  return impl_->solved(std::move(f_i)).head(interior);
}

}  // namespace reye::algebra
