#pragma once
#include "solver/nonlinear_bodies.hpp"

namespace reye::solver {

/// The reduced columns that Newton's matrix is built on: those of active nodes, of the nodes they meet and of those
/// that shape the surface there. The equations of the others in reach are those of a body alone, linear or linearised:
/// they are condensed out exactly, and recovered with each step. The window moves with the contact.
class Window {
 public:
  void forget() { chosen_ = false; }
  /// Nonlinear bodies have other tangents.
  void tangents_changed() { renewed_ = false; }
  /// Chooses the window; the present one is kept while the nodes `needed` lie inside.
  void choose(const System& system, const Reduction& reduction, const NonlinearBodies& nonlinear, const Reach& needed);

  int index(int column) const { return columns_.index[column]; }                ///< of a reduced column, -1 outside
  int first(int body) const { return columns_.first[body]; }                    ///< of a body's first column inside
  const Matrix& stiffness(int body) const { return parts_[body].stiffness(); }  ///< empty where rigid

  /// The state at which a body that turns is linearised: its reduced columns, the unbalanced forces on its pivot in its
  /// frame, and the rate of its loads with the angle.
  void turn(int body, const Vector& q, const Vector& forces, const Vector& rate);
  /// Makes the transposed stiffness of a body inside its transposed tangent, where it turns.
  void add_turning(int body, Eigen::Ref<Matrix> transposed) const;

  /// A right-hand side on the reduced columns as the window sees it.
  struct Load {
    Vector inside;
    std::vector<Vector> own;  ///< per body: displacements outside
  };
  Load load(const Vector& b) const;
  /// A step on the reduced columns, from that inside and the right-hand side that it is by.
  Vector expand(const Vector& inside, const Load& load) const;

 private:
  void renew(const System& system, const NonlinearBodies& nonlinear);

  bool chosen_ = false, renewed_ = false;
  Reach reach_;
  KeptColumns columns_;             ///< of the reduced ones
  std::vector<int> first_reduced_;  ///< per body
  struct Part : Condensed {
    std::optional<body::Turning> whole, turning;  ///< on all reduced columns, on those inside
    Vector q, forces;                             ///< where it is linearised
    Condensed::Load rate;
  };
  std::vector<Part> parts_;
  std::vector<KeptColumns::Split> split_;  ///< per body
};

}  // namespace reye::solver
