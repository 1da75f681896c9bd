#pragma once
#include <string>
#include <vector>

#include "solver/reduction.hpp"

namespace reye::solver {

/// The nonlinear bodies of a system while one increment is solved: linear ones that are renewed.   [README (4)]
/// Holds their interiors and their last linearisation, about an anchor. All calls but `begin` and `any` refer to the
/// increment that `begin` started; its arguments must live as long.
class NonlinearBodies {
 public:
  /// Starts from the accepted state; a guess predicts its end, `share` > 0 continues by that share of the last
  /// increment.
  void begin(const System& system, const SolverState& before, const Controls& controls, const Reduction& reduction,
             const Guess* guess, double share);

  bool any() const { return any_; }
  /// Whether a global column belongs to one of them.
  bool own(int column) const;

  /// Tangent and residual at the reduced q and the interiors. Throws base::SolveError when an element has turned inside
  /// out or a stress cannot be found.
  void linearise(const base::TwoPart& q, const Multipliers& lambda, body::Tangent tangent);
  /// The tangent at q where `renew` has measured. Where symmetric parts are asked for, a body gets the exact tangent if
  /// most of what is unbalanced inside it is what its last symmetric part has left out, and that is not little of what
  /// it was made for. Errors as above.
  void linearise_again(const base::TwoPart& q, const Multipliers& lambda, body::Tangent tangent);
  /// Moves the interiors after the change of q since the anchor and measures the imbalance there; where that fails, or
  /// the imbalance is far larger, half the step is tried, and so on. The tangent stays. Returns why no step succeeds,
  /// or nothing.
  std::string renew(base::TwoPart& q, Multipliers& lambda);

  /// The anchor is q from now on, which the bodies have been measured at: it has other columns than then.
  void columns_changed(const base::TwoPart& q) { anchor_ = q; }

  /// S of a body; null when it is not nonlinear.
  const Matrix* tangent(int body) const;
  /// v of q - q_anchor of a body: its part without rigid translation.
  Vector deformation(int body, const base::TwoPart& q) const;
  /// Adds r + S v of a body.
  void add_residual(int body, const Vector& v, Vector& r) const;
  double inside_imbalance() const;  ///< largest r_i at the anchor
  double force_scale() const;       ///< largest force of a cell at the anchor
  /// Largest displacement of a body at the anchor but for its translation.
  double deformation(int body) const { return linearised_[static_cast<std::size_t>(body)].deformation; }
  std::string least_balanced() const;  ///< where the largest r_i is, in words

  /// Interiors after the increment that led to the global q, per body.
  std::vector<body::Interior> accepted(const base::TwoPart& q) const;
  /// Keeps the step of the interiors for the next `begin`.
  void remember(const SolverState& after);
  void forget();

 private:
  template <class Work>
  void for_each(Work work) const;  ///< work(b, body) of every nonlinear body
  void measure(const base::TwoPart& q, const Multipliers& lambda);
  using Linearised = body::NonlinearBody::Linearised;
  const body::NonlinearBody* body(std::size_t b) const { return std::get_if<body::NonlinearBody>(&system_->bodies[b]); }
  template <class Columns>
  auto part(const body::NonlinearBody& body, std::size_t b, const Columns& q) const {
    return q.segment(reduction_->first(static_cast<int>(b)), body.dofs());
  }

  const System* system_ = nullptr;
  const SolverState* before_ = nullptr;
  const Controls* controls_ = nullptr;
  const Reduction* reduction_ = nullptr;
  bool any_ = false;
  std::vector<base::TwoPart> interior_;  ///< y per body, empty but for nonlinear ones
  std::vector<Vector> last_step_;        ///< of the interiors in the last accepted increment
  std::vector<Linearised> linearised_;   ///< about the anchor
  std::vector<double> linearised_of_;    ///< per body: its imbalance where its tangent was made
  base::TwoPart anchor_;
  Multipliers anchor_lambda_;
};

}  // namespace reye::solver
