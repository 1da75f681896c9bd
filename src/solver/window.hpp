#pragma once
#include "solver/reduction.hpp"

namespace reye::solver {

/// The reduced columns that Newton's matrix is built on: those of nodes that are active, of what they meet and of what
/// shapes them there. Of the others in reach, which contact may come to, the equations are a linear body's alone: they
/// are condensed out exactly, and solved back with each step. The window goes along with the contact.
class Window {
 public:
  void forget() { chosen_ = false; }
  /// Kept while the nodes `needed` lie inside.
  void choose(const System& system, const Reduction& reduction, const Reach& needed);

  int index(int column) const { return columns_.index[column]; }                ///< of a reduced column, -1 outside
  int first(int body) const { return columns_.first[body]; }                    ///< of a body's first column inside
  const Matrix& stiffness(int body) const { return parts_[body].stiffness(); }  ///< empty but for linear bodies

  /// Where a body that turns is linearised: its reduced columns, the forces on its pivot that are out of balance in its
  /// frame, and the rate of its loads with the angle.
  void turn(int body, const Vector& q, const Vector& forces, const Vector& rate);
  /// Makes the transposed stiffness of a body inside its transposed tangent, where it turns.
  void add_turning(int body, Eigen::Ref<Matrix> transposed) const;

  /// Right-hand side inside, from that on the reduced columns; remembers the rest for `expand`.
  Vector load(const Vector& b);
  Vector expand(const Vector& inside) const;

 private:
  bool chosen_ = false;
  Reach reach_;
  KeptColumns columns_;             ///< of the reduced ones
  std::vector<int> first_reduced_;  ///< per body
  struct Part : Condensed {
    Vector own;                                   ///< what the right-hand side moves outside
    std::optional<body::Turning> whole, turning;  ///< on all reduced columns, on those inside
    Vector q, forces;                             ///< where it is linearised
    Condensed::Load rate;
  };
  std::vector<Part> parts_;
};

}  // namespace reye::solver
