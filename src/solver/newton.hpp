#pragma once
#include <string>
#include <vector>

#include "solver/active_set_watch.hpp"
#include "solver/condense.hpp"
#include "solver/nonlinear_bodies.hpp"
#include "solver/reduction.hpp"

namespace reye::solver {

struct NewtonOptions {
  int max_iterations = 30;
  double force_tolerance = 1e-10;      ///< of the largest force in the system
  double condition_tolerance = 1e-9;   ///< of the largest multiplier
  bool limit_reach = true;             ///< condense out contact nodes that are far from contact
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

/// Semi-smooth Newton (primal-dual active set) for one increment. Nonlinear bodies are linear ones that are renewed:
/// contact settles on their linearisation, then they are linearised anew where it left them, until both are met. Each
/// renewal is a Newton step of the whole, with the active set of its end. Work space is kept between calls; so are the
/// reach and the last increment, which steer but do not decide the result: `reset` forgets them.
class Newton {
 public:
  explicit Newton(NewtonOptions options = {}) : options_(options) {}

  /// From the accepted state `before` to equilibrium under `controls`. A failure is a result with a reason.
  SolveResult solve(const System& system, const SolverState& before, const Controls& controls);

  /// To be called where the system changes, and at every block start.
  void reset();

 private:
  enum class Fit { good, too_narrow };
  struct ContactNode {
    int contact = -1, node = -1;
  };
  void choose_reach(const System& system, const SolverState& before, bool everything);
  SolveResult iterate(const System& system, const SolverState& before, const Controls& controls, bool predicted);
  void begin(const System& system, const SolverState& before, const Controls& controls);
  void place(const System& system, const Vector& q, bool everything);
  Vector residual(const System& system, const Controls& controls, const Vector& q) const;
  const Matrix& stiffness(std::size_t body) const;
  Iteration measure(const System& system, const Controls& controls, const Vector& q, bool fresh);
  int decide(int iteration, bool predicted, Allowed allowed);
  ActiveSetWatch::Set active_set() const;
  Vector step(const System& system, const Controls& controls, const Vector& q);
  Fit accept(const System& system, const Vector& q, SolveResult& result);
  bool inside_reach(const System& system, int contact) const;
  /// A secondary node in words; an empty text without one.
  std::string named(const System& system, ContactNode node) const;
  std::string least_balanced(const System& system) const;
  std::string no_convergence(const System& system, const std::vector<Iteration>& table, bool circles) const;

  NewtonOptions options_;
  Reach reach_;
  Reduction reduction_;
  bool reach_chosen_ = false;
  Vector last_step_;                            ///< dq of the last accepted increment
  NonlinearBodies nonlinear_;
  std::vector<contact::Interface> interfaces_;
  Multipliers lambda_;
  std::vector<Sides> sides_;
  std::vector<std::vector<PlacedNode>> nodes_;  ///< per contact: secondary nodes, then primary
  Condenser condenser_;
  Vector structural_, loads_;              ///< on the reduced columns
  // For the report of a failure:
  int unbalanced_ = -1;                    ///< reduced column with the largest unbalanced force, -1: inside a body
  ContactNode unmet_;                      ///< the condition that was met worst
  ContactNode asking_;                     ///< the first node that asked for another status in the last decision
};

}  // namespace reye::solver
