#pragma once
#include <string>
#include <vector>

#include "solver/solid/increment_state.hpp"
#include "solver/solid/reduced_system.hpp"

namespace reye::solver {

/// An increment while it is being solved.
class SolidIterate {
 public:
  SolidIterate(const SolidSystem& system, const SolidState& old, const SolidTarget& target, SolidStart start);

  /// Integrates where the points are now.
  void integrate();
  /// Decides which points are open, stick or slip, and puts the shear of slipping ones onto the cone along their
  /// direction; true where any point changed.
  bool classify();
  /// Largest violation of a condition, and of the balance of free motions.
  struct Error {
    double traction_MPa = 0.0;  ///< violation of conditions
    double largest_MPa = 0.0;   ///< traction
    double balance = 0.0;       ///< imbalance over the sum of forces
  };
  Error error() const;
  /// One Newton step. Throws base::SolveError.
  void step();
  /// Shear that was kept while normal contact settled is let go.
  void let_shear_go();
  bool shear_is_kept() const { return keep_shear_; }
  /// How often a body that is free to move was found to touch nothing.
  int came_apart() const { return came_apart_; }

  SolidSolution take();
  double mortar_s = 0.0, interface_s = 0.0;

 private:
  using Status = contact::SkinStatus;
  void evaluate();
  void seed();
  bool project();
  std::vector<ReducedRow> rows() const;
  void add_rows(int contact, int point, std::vector<ReducedRow>& rows) const;
  double step_share(const std::vector<ReducedRow>& rows, const ReducedStep& step, const TurningTangent& tangent) const;
  void apply(const std::vector<ReducedRow>& rows, const ReducedStep& step, double share);
  void drive();
  void stand();
  SolidMotion motion() const { return {force_, now_.s, now_.a, standing_.poses}; }
  double friction(int contact) const { return keep_shear_ ? 0.0 : target_.friction[contact]; }
  Status decide(int contact, int point) const;

  const SolidSystem& system_;
  const SolidState& old_;
  const SolidTarget& target_;
  SolidState now_;
  std::vector<mortar::SkinPairs> pairs_;
  std::vector<contact::SkinPlace> place_;
  std::vector<std::vector<contact::SkinNode>> nodes_;
  Standing standing_;
  Vector force_;
  bool keep_shear_ = false, stick_all_ = false;
  int came_apart_ = 0;
};

}  // namespace reye::solver
