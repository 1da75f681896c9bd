#pragma once
#include <string>
#include <vector>

#include "solver/system.hpp"

namespace reye::solver {

struct NewtonOptions {
  int max_iterations = 30;
  double force_tolerance = 1e-10;      ///< of the largest force in the system
  double condition_tolerance = 1e-9;   ///< of the largest multiplier
};

/// One row of a Newton table.
struct Iteration {
  double force = 0.0;      ///< largest unbalanced force over the largest force
  double condition = 0.0;  ///< largest unmet condition, as a traction over the largest multiplier
  int changes = 0;         ///< nodes whose status changed
};

struct SolveReport {
  bool converged = false;
  std::string reason;  ///< empty when converged
  std::vector<Iteration> table;
  int solves = 0;
};

struct SolveResult {
  SolverState state;
  SolveReport report;
};

/// Semi-smooth Newton (primal-dual active set) for one increment. Work space is kept between calls.
class Newton {
 public:
  explicit Newton(NewtonOptions options = {}) : options_(options) {}

  /// From the accepted state `before` to equilibrium under `controls`. A failure is a result with a reason.
  SolveResult solve(const System& system, const SolverState& before, const Controls& controls);

  const std::vector<contact::Interface>& interfaces() const { return interfaces_; }

 private:
  void begin(const System& system, const SolverState& before, const Controls& controls);
  void place(const System& system, const Vector& q);
  Iteration measure(const System& system, const Controls& controls, const Vector& q);
  void assemble(const System& system, const Controls& controls, const Vector& q);
  void add_contact_tangent(const System& system, int contact, const Vector& q);
  void eliminate(const System& system, int contact, const Vector& q);
  void fix(const Controls& controls);
  void recover(int contact, const Vector& dq);

  NewtonOptions options_;
  std::vector<contact::Interface> interfaces_;
  std::vector<contact::Linearised> linearised_;
  std::vector<std::vector<Vec2>> lambda_;
  Matrix At_;   ///< transposed system matrix: one equation per column
  Vector b_, structural_;
  struct Elimination {
    Matrix slope;                ///< d(lambda)/dq, one component per column
    Vector constant;
    std::vector<int> place;      ///< first column of a node, -1 when inactive
  };
  std::vector<Elimination> elimination_;
  struct Node {
    body::NodePosition position;
    int shift = 0;               ///< of its body's columns in q
  };
  std::vector<std::vector<Node>> nodes_;  ///< per contact: secondary nodes, then primary
};

}  // namespace reye::solver
