#pragma once

namespace reye::solver {

/// Decides when Newton may take chord steps with the matrix of an earlier iteration: building and factorising a new one
/// costs several times as much as the residuals. It may while no node changes status and every step takes the error to
/// a given share.
class ChordRule {
 public:
  explicit ChordRule(double share) : share_(share) {}

  /// To be called in every iteration before its step, with the error of the state and the number of nodes that changed
  /// status.
  bool allows(double error, int changes) {
    const bool allowed = changes == 0 && error < share_ * last_;
    last_ = error;
    return allowed;
  }

  void forget() { last_ = 0.0; }

 private:
  double share_;
  double last_ = 0.0;  ///< without a matrix nothing is allowed
};

}  // namespace reye::solver
