#pragma once

namespace reye::solver {

/// Decides when Newton may take chord steps with the matrix of an earlier iteration: building and factorising a new one
/// costs several times as much as the residuals. It may while no node changes status and every step takes the error to
/// a tenth.
class ChordRule {
 public:
  /// To be called in every iteration before its step, with the error of the state and the number of nodes that changed
  /// status.
  bool allows(double error, int changes) {
    const bool allowed = changes == 0 && error < 0.1 * last_;
    last_ = error;
    return allowed;
  }

 private:
  double last_ = 0.0;  ///< without a matrix nothing is allowed
};

}  // namespace reye::solver
