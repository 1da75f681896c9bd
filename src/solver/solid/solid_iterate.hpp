#pragma once
#include <string>
#include <vector>

#include "solver/solid/increment_state.hpp"
#include "solver/solid/near_facets.hpp"
#include "solver/solid/reduced_system.hpp"
#include "solver/solid/worn_contact.hpp"

namespace reye::solver {

/// An increment while it is being solved.
class SolidIterate {
 public:
  SolidIterate(const SolidSystem& system, const SolidState& old, const SolidTarget& target, SolidStart start);

  /// Integrates where the points are now: all facets at first, later those that may be in contact.
  void integrate();
  /// Evaluates the conditions where the points are now, with the integrals at hand.
  void evaluate();
  /// Decides which points are open, stick or slip, and puts the shear of slipping ones onto the cone along their
  /// direction; true where any point changed, or should. `with_care`: only those change that are due the most.
  bool classify(bool with_care = false);
  /// Largest violation of a condition, and of the balance of free motions.
  struct Error {
    double traction_MPa = 0.0;  ///< violation of conditions
    double largest_MPa = 0.0;   ///< traction
    double balance = 0.0;       ///< imbalance over the sum of forces
  };
  Error error() const;
  /// One Newton step; the integrals are to follow. `same_matrix`: with the matrix of the last step where that had the
  /// same unknowns. `near` the solution it is made twice, the second time with the normals where the first one led.
  /// Throws base::SolveError.
  void step(bool same_matrix, bool near);
  /// Shear that was kept while normal contact settled is let go: every closed point sticks at first.
  void let_shear_go();
  bool shear_is_kept() const { return keep_shear_; }
  /// How often a body that is free to move was found to touch nothing.
  int came_apart() const { return came_apart_; }

  /// Once solved to the tolerance: a last step with the matrix at hand, if there is one, and with the integrals held.
  /// It costs a tenth of an iteration, and a hundredth of the error is left.
  void finish();
  SolidSolution take();
  double mortar_s = 0.0, interface_s = 0.0;

 private:
  using Status = contact::SkinStatus;
  void wear();
  void seed();
  bool project();
  std::vector<ReducedRow> rows() const;
  std::vector<WearRow> wear_rows(const std::vector<ReducedRow>& rows) const;
  bool wears() const;
  void turn_tractions(std::size_t contact, const std::vector<contact::SkinFrame>& before);
  void turn_normals();
  void apply(const std::vector<ReducedRow>& rows);
  Vector moved_by(const std::vector<ReducedRow>& rows, const ReducedStep& step) const;
  double step_share(const Vector& moved) const;
  void drive();
  void keep_whole();
  void stand();
  SolidMotion motion() const { return {force_, now_.s, now_.a, standing_.poses}; }
  double friction(int contact) const { return keep_shear_ ? 0.0 : target_.friction[contact]; }
  Status decide(int contact, int point) const;
  double due(int contact, int point, Status now, Status fresh) const;
  void keep_what_rests(std::vector<std::vector<Status>>& fresh) const;
  void change_with_care(std::vector<std::vector<Status>>& fresh) const;

  const SolidSystem& system_;
  const SolidState& old_;
  const SolidTarget& target_;
  SolidState now_;
  std::vector<mortar::SkinPairs> pairs_;
  std::vector<contact::SkinPlace> place_;
  std::vector<WholeIntegrals> whole_;  ///< per contact
  std::vector<std::vector<contact::SkinNode>> nodes_;
  std::vector<WornContact> worn_;  ///< per contact
  Standing standing_;
  Vector force_;
  TurningTangent tangent_;  ///< of the matrix that is held
  ReducedSystem reduced_;
  bool keep_shear_ = false, stick_all_ = false;
  bool as_before_ = false;  ///< what was closed stays closed until a step was made
  int came_apart_ = 0;
};

}  // namespace reye::solver
