#include <gtest/gtest.h>

#include "algebra/decompose.hpp"
#include "base/linalg.hpp"
#include "solver/active_set_watch.hpp"

namespace {

using namespace reye;
using base::Matrix;
using base::Vector;
using contact::ContactStatus;
using solver::ActiveSetWatch;

/// 0 <= x, M x + q >= 0, x . (M x + q) = 0: the set of x > 0 where no node asks for a change, or none after 50 steps.
struct Complementarity {
  Matrix M;
  Vector q;
  ActiveSetWatch::Set set;
  ActiveSetWatch watch;

  Vector solution() const {
    Matrix A = Matrix::Identity(q.size(), q.size());
    Vector b = Vector::Zero(q.size());
    for (Eigen::Index i = 0; i < q.size(); ++i)
      if (set[i] == ContactStatus::stick) {
        A.row(i) = M.row(i);
        b[i] = -q[i];
      }
    return algebra::least_squares(A, b);
  }

  bool settles(bool watched) {
    for (int step = 0; step < 50; ++step) {
      const Vector x = solution(), y = M * x + q;
      int changes = 0;
      for (Eigen::Index i = 0; i < q.size(); ++i) {
        const auto wanted = x[i] > y[i] ? ContactStatus::stick : ContactStatus::inactive;
        if (wanted == set[i] || (watched && watch.cycling() && changes > 0)) continue;
        set[i] = wanted;
        ++changes;
      }
      if (changes == 0) return true;
      watch.add(set);
      if (watched && watch.stuck()) return false;
    }
    return false;
  }
};

/// Three contacts that answer each other in a ring: the active set comes back every third step for ever, though M is a
/// P-matrix (Ben Gharbia and Gilbert).
Complementarity ring() {
  Complementarity c;
  c.M = Matrix::Identity(3, 3);
  for (int i = 0; i < 3; ++i) c.M(i, (i + 2) % 3) = 2.0;
  c.q = Vector::Constant(3, -1.0);
  c.set = {ContactStatus::stick, ContactStatus::inactive, ContactStatus::inactive};
  return c;
}

// An active set that goes round in circles must be noticed and come to the one solution, node by node.
TEST(active_set_watch, cycle_of_a_p_matrix_is_broken) {
  EXPECT_FALSE(ring().settles(false));
  auto c = ring();
  EXPECT_TRUE(c.settles(true));
  EXPECT_TRUE(c.watch.cycling());
  EXPECT_LT((c.solution() - Vector::Constant(3, 1.0 / 3.0)).norm(), 1e-14);
}

// Where no set fits at all, continuing node by node must end by saying so.
TEST(active_set_watch, no_solution_is_told) {
  Complementarity c;
  c.M = Matrix::Constant(1, 1, -1.0);
  c.q = Vector::Constant(1, -1.0);
  c.set = {ContactStatus::inactive};
  EXPECT_FALSE(c.settles(true));
  EXPECT_TRUE(c.watch.stuck());
}

// Sets that do not come back must not be taken for a cycle, nor one that rests.
TEST(active_set_watch, silent_while_the_set_moves_on) {
  auto c = ring();
  c.M = Matrix::Identity(3, 3);
  EXPECT_TRUE(c.settles(true));
  for (int i = 0; i < 5; ++i) c.watch.add(c.set);
  EXPECT_FALSE(c.watch.cycling());
}

}  // namespace
