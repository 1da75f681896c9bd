#pragma once
#include <vector>

#include "body/solid/rigid_modes.hpp"
#include "body/solid/solid_columns.hpp"
#include "body/solid/solid_matrices.hpp"

namespace reye::body {

/// What the columns of a supported solid are to its points, its free motions and what drives it; known before its
/// stiffness.
struct SolidRows {
  SolidColumns columns;
  base::SparseMatrix of_unknown;     ///< retained points from own retained dofs and active motions
  base::SparseMatrix of_prescribed;  ///< and from prescribed motions
  bool plain = true;                 ///< retained points are the first unknowns
  Modes free;                        ///< motions that nothing holds, about a centre
  Matrix modes;                      ///< unknowns of these
  std::vector<Vector> loads;         ///< per driven value: forces on y, empty where it is no load
  Matrix pushed;                     ///< forces of driven values on the unknowns without loads, x driven
  Matrix prescribed;                 ///< values of prescribed motions, x driven

  /// `driven`: the values that drive the body; `centre`: of the free motions.
  SolidRows(const SolidInput& input, const std::vector<SolidPlace>& places, const std::vector<int>& retained,
            const std::vector<Driven>& driven, const Vec3& centre);

  int last() const { return columns.dofs.size() - columns.interior; }  ///< columns that a factor retains
  /// K of the columns with the springs of supports, upper triangle.
  base::SparseMatrix stiffness(const SolidInput& input) const;
  /// Retained columns that springs as stiff as the body hold while it is factorised: what is prescribed, and as many
  /// unknowns as there are free modes, so chosen that the modes differ in them. Forces that are in balance with a load
  /// leave these without force. Throws base::SolveError where too few nodes are retained.
  std::vector<int> held() const;

 private:
  void set_retained_motion(const std::vector<int>& retained);
  void set_free_modes(const SolidInput& input, const std::vector<SolidPlace>& places, const Vec3& centre);
  void set_driven(const SolidInput& input, const std::vector<Driven>& driven);
};

}  // namespace reye::body
