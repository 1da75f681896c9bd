#pragma once
#include <vector>

#include "solver/active_set_watch.hpp"
#include "solver/chord_rule.hpp"
#include "solver/nonlinear_bodies.hpp"
#include "solver/reduction.hpp"
#include "solver/report.hpp"

namespace reye::solver {

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
  void choose_reach(const System& system, const SolverState& before, bool everything);
  SolveResult iterate(const System& system, const SolverState& before, const Controls& controls, bool predicted);
  void begin(const System& system, const SolverState& before, const Controls& controls);
  void place(const System& system, const Vector& q, bool everything);
  Vector residual(const System& system, const Controls& controls, const Vector& q) const;
  const Matrix& stiffness(std::size_t body) const;
  Iteration measure(const System& system, const Controls& controls, const Vector& q, bool fresh);
  int decide(int iteration, bool predicted, Allowed allowed);
  ActiveSetWatch::Set active_set() const;
  bool touching() const;
  Vector step(const System& system, const Controls& controls, const Vector& q, bool chord);
  Fit accept(const System& system, const Vector& q, SolveResult& result);

  NewtonOptions options_;
  Reach reach_;
  Reduction reduction_;
  bool reach_chosen_ = false;
  Vector last_step_;                            ///< dq of the last accepted increment
  NonlinearBodies nonlinear_;
  std::vector<contact::Interface> interfaces_;
  Multipliers lambda_;
  std::vector<Sides> sides_, start_;            ///< where the surface nodes are, and where the increment found them
  std::vector<std::vector<PlacedNode>> nodes_;  ///< per contact: secondary nodes, then primary
  Condenser condenser_;
  Vector balance_, loads_, arm_;           ///< on the reduced columns
  Suspects suspects_;
};

}  // namespace reye::solver
