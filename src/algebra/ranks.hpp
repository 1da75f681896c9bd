#pragma once
#include <memory>

#include "base/linalg.hpp"

/// Factors that several processes hold together, where one machine's memory or time does not suffice: a distributed
/// engine (MUMPS over MPI) behind the same Schur complement. Built with REYE_MPI only; else there is one rank.
namespace reye::algebra {

/// Processes that factorise together: 1 unless a `Ranks` lives that was started under mpirun.
int ranks();
int ranks_here();  ///< of them, those on this machine

/// Joins the processes that mpirun has started, until destroyed; does nothing where it has started none. The first one
/// runs the program; the others serve its factors in the constructor, which returns when the first one is done.
class Ranks {
 public:
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  bool served() const { return served_; }  ///< this process was one of the others: its work is done

 private:
  bool served_ = false;
};

/// Symmetric K with a positive definite interior i (first) and retained rows c (last), factorised by all ranks. Asked
/// from the first rank alone, from any of its threads. Throws base::SolveError where K_ii is not definite or memory
/// does not suffice.
class RankedFactor {
 public:
  /// K: its upper triangle, n x n.
  RankedFactor(const base::SparseMatrix& upper, int retained);
  ~RankedFactor();
  RankedFactor(const RankedFactor&) = delete;
  RankedFactor& operator=(const RankedFactor&) = delete;

  base::Matrix take_schur();                            ///< S = K_cc - K_ci K_ii^-1 K_ic, once
  base::Vector solve_interior(base::Vector f_i) const;  ///< K_ii^-1 f_i

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace reye::algebra
