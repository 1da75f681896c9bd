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
  Reduction(const System& system, const Reach& reach);

  int size() const { return columns_.size(); }
  int index(int column) const { return columns_.index[column]; }  ///< reduced index of a global column, -1 out of reach
  int column(int index) const { return columns_.column[index]; }  ///< global column of a reduced one
  int first(int body) const { return columns_.first[body]; }      ///< reduced index of a body's first kept column

  Vector restrict_to(const Vector& q) const;
  /// Forces of all loads, f' on the kept columns; remembers the displacements out of reach for `expand`. The loads of
  /// bodies that turn depend on the rotation: `turning_load`.
  Vector loads(const System& system, const std::vector<Vector>& load_factors);
  const body::TurningLoad& turning_load(int body) const { return parts_[body].load; }
  const body::Turning* turning(int body) const { return parts_[body].turning ? &*parts_[body].turning : nullptr; }
  const Matrix& stiffness(int body) const { return parts_[body].stiffness(); }  ///< empty but for linear bodies
  /// A choice of the kept columns of a linear body.
  Condensed part(int body, std::vector<int> near, std::vector<int> far) const {
    return parts_[body].part(std::move(near), std::move(far));
  }
  /// Kept columns of a linear body in its frame, without its rigid translation: S' needs no more, and is rounded less.
  Vector deformation(int body, const base::TwoPart& reduced) const;
  base::TwoPart of_body(int body, const base::TwoPart& reduced) const;
  /// All global columns from the kept ones; `scatter` leaves those out of reach at zero.
  base::TwoPart expand(const base::TwoPart& reduced) const;
  Vector scatter(const Vector& reduced) const;

 private:
  struct Part : Condensed {
    body::Translation near_translation, far_translation;
    std::optional<body::Turning> turning;
    body::TurningLoad load;  ///< f' of a body that turns
    body::TurningLoad own;   ///< displacements by loads out of reach; where nothing turns all of it is `still`

    base::TwoPart in_frame(base::TwoPart near) const { return turning ? turning->in_frame(std::move(near)) : near; }
  };

  KeptColumns columns_;
  std::vector<int> offset_;
  std::vector<Part> parts_;
};

}  // namespace reye::solver
