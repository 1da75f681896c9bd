#pragma once
#include <limits>

#include "solver/chord_rule.hpp"
#include "solver/increment.hpp"

namespace reye::solver {

/// Options of one attempt at an increment: its start, and whether factorised matrices and tangents are kept, and
/// derivatives left out, while that is worth it.
struct Attempt {
  contact::Start from;
  bool chords;
};

/// One attempt at an increment: the iterations from one start to a state, or to the reason of the failure. A path is
/// followed once.
class NewtonPath {
 public:
  NewtonPath(Increment& increment, const NewtonOptions& options, const System& system, const SolverState& before,
             const Controls& controls, const Attempt& attempt);

  /// `narrowing`: the reach may be narrowed around the active nodes.
  SolveResult follow(bool narrowing);

 private:
  bool begin();
  void iterate();
  void decide();
  void extend();
  bool finite();
  bool astray();
  bool stands_still();
  void judge_compliance();
  StepMatrix next_matrix();
  bool may_keep_matrix();
  double asked() const;
  bool met();
  bool settled_enough() const;
  void accept();
  void renew(bool settled);
  bool linearise();
  void step(bool on_nearest = false);
  void end(Failure failure, std::string reason);

  bool fresh() const {
    return !increment_.nonlinear() || since_ == 0;
  }  ///< the residual is that of the nonlinear bodies, not of their linearisation
  bool renewed() const { return since_ == 0 && renewals_ > 0; }
  int stage() const { return late_ ? options_.max_iterations : iteration_; }
  double error() const;  ///< of the tolerances

  Increment& increment_;
  const NewtonOptions& options_;
  const System& system_;
  const SolverState& before_;
  const Controls& controls_;
  const Attempt attempt_;

  SolveResult result_;
  bool ended_ = false, narrowing_ = false;
  base::TwoPart q_;
  Iteration row_;  ///< of this iteration
  ActiveSetWatch watch_;
  bool cycling_ = false;      ///< the active set cycles: it changes in one node alone
  bool late_ = false;         ///< decisions follow the rules of late iterations
  int iteration_ = 0;         ///< since the bodies were renewed; counts towards `last_`
  int since_ = 0;             ///< iterations on the tangents that bodies have
  int last_ = 0, limit_ = 0;  ///< iterations at most; of them on one tangent
  int few_ = 0;               ///< iterations in a row in which a few nodes change
  int renewals_ = 0, follows_ = 0;
  int kept_nearest_ = 0;        ///< times that a node was kept in contact though all opened
  bool settled_ = true;         ///< before the last renewal contact had settled
  double renewed_force_ = 0.0;  ///< imbalance after the last renewal
  int still_ = 0;               ///< renewals in a row that changed nothing
  double imbalance_ = 0.0;      ///< of bodies and contact when the bodies were last measured, as a share of the forces
  ChordRule matrices_{0.1}, tangents_{0.03};
  bool chord_ = false;  ///< this step keeps the matrix
  StepMatrix last_matrix_ = StepMatrix::exact;
  bool exact_ = false;       ///< no step in compliance form any more
  double last_error_ = 0.0;  ///< before the last step
  bool keeps_tangent_ = false, on_kept_tangent_ = false;
  double least_ = std::numeric_limits<double>::infinity();  ///< least imbalance so far
};

}  // namespace reye::solver
