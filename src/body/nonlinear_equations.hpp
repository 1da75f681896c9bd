#pragma once
#include <optional>
#include <string>

#include "base/errors.hpp"
#include "body/columns.hpp"
#include "fem/finite.hpp"
#include "fem/follower.hpp"

/// The equations of a nonlinear body before they are condensed, on its unknowns [y; q].
namespace reye::body {

/// One load of the scene for history factor 1: the part that keeps its direction, and at finite strain the pressure.
struct NonlinearLoad {
  Vector dead;
  std::optional<fem::FollowerPressure> pressure;
};

/// u = u(y, q), r = B^T (f_int - sum factor_i f_i), and the tangent terms that B^T K B lacks.
struct NonlinearEquations {
  ShapePtr shape;
  std::string name;
  fem::Solid solid;
  Columns columns;
  fem::Pattern pattern;
  std::vector<LoadColumn> names;
  std::vector<NonlinearLoad> loads;
  Translation translation, outer;  ///< of all unknowns, of the retained
  std::vector<char> supported;     ///< per cell: whether a support moves a node of it

  NonlinearEquations(ShapePtr shape, const BodyInput& input);

  const mesh::Mesh& mesh() const { return shape->mesh; }
  int interior() const { return columns.interior; }
  bool turns() const { return solid.kinematics == base::Kinematics::finite; }
  bool symmetric() const;  ///< of the tangent

  TwoPart all(const TwoPart& y, const TwoPart& q) const;  ///< [y; q]
  /// Unknowns without rigid translation, which costs no force: everything but positions is computed from them. [README
  /// (8)]
  Vector deformation(const TwoPart& y, const TwoPart& q) const;
  Vector displacement(const Vector& unknowns) const;           ///< 2 per node
  base::SparseMatrix expansion(const Vector& unknowns) const;  ///< B = du/d(y, q)

  /// f_int - sum factor_i f_i on the nodes.
  Vector unbalanced(const fem::InternalForce& f, const Vector& u, const Vector& factors) const;
  void subtract_load_tangent(const Vector& u, const Vector& factors, base::SparseMatrix& K) const;
  /// The term of d^2 u / dtheta^2 on the diagonal of the tangent: the nodes of an edge accelerate towards its centre.
  Vector turning(const Vector& unbalanced, const Vector& unknowns) const;

  /// Runs `task`; a failure of the material names the body.
  template <class Task>
  auto named(Task task) const {
    try {
      return task();
    } catch (const base::SolveError& error) {
      throw base::SolveError("body " + name + ", " + error.what());
    }
  }
};

}  // namespace reye::body
