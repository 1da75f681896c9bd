#pragma once
#include <vector>

#include "body/turning.hpp"
#include "solver/condensed.hpp"
#include "solver/kept_columns.hpp"
#include "solver/reach.hpp"

namespace reye::solver {

/// The system on the columns of the reach and of the supports; columns of contact nodes out of reach are condensed out
/// of linear bodies. Rigid and nonlinear bodies keep all their columns.
class Reduction {
 public:
  Reduction() = default;
  /// `moving`: contact moves along the bodies, so that one choice of columns follows another.
  Reduction(const System& system, const Reach& reach, bool moving);

  int size() const { return columns_.size(); }
  int index(int column) const { return columns_.index[column]; }  ///< reduced index of a global column, -1 out of reach
  int column(int index) const { return columns_.column[index]; }  ///< global column of a reduced one
  int first(int body) const { return columns_.first[body]; }      ///< reduced index of a body's first kept column

  Vector restrict_to(const Vector& q) const;
  /// Loads as the kept columns see them.
  struct Loads {
    Vector forces;                           ///< f' of bodies that do not turn
    std::vector<body::TurningLoad> turning;  ///< per body: f' of one that turns, which depends on its rotation
    std::vector<body::TurningLoad> own;      ///< per body: displacements out of reach; where nothing turns all `still`
  };
  Loads loads(const System& system, const std::vector<Vector>& load_factors) const;
  const body::Turning* turning(int body) const { return parts_[body].turning ? &*parts_[body].turning : nullptr; }
  const Matrix& stiffness(int body) const { return parts_[body].stiffness(); }  ///< empty but for linear bodies
  /// A choice of the kept columns of a linear body.
  Condensed part(int body, std::vector<int> near, std::vector<int> far) const {
    return parts_[body].part(std::move(near), std::move(far));
  }
  /// Kept columns of a linear body in its frame, without its rigid translation: S' needs no more, and is rounded less.
  Vector deformation(int body, const base::TwoPart& reduced) const;
  base::TwoPart of_body(int body, const base::TwoPart& reduced) const;
  /// All global columns from the kept ones, under these loads; `scatter` leaves those out of reach at zero.
  base::TwoPart expand(const base::TwoPart& reduced, const Loads& loads) const;
  Vector scatter(const Vector& reduced) const;

 private:
  struct Part : Condensed {
    body::Translation near_translation, far_translation;
    std::optional<body::Turning> turning;

    base::TwoPart in_frame(base::TwoPart near) const { return turning ? turning->in_frame(std::move(near)) : near; }
  };

  KeptColumns columns_;
  std::vector<int> offset_;
  std::vector<Part> parts_;
};

}  // namespace reye::solver
