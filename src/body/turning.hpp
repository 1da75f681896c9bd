#pragma once
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/two_part.hpp"
#include "body/columns.hpp"

/// How a linear body turns: x = c + R(theta) (X + w - c), with w small and in the body's own frame.   [README (9)]
namespace reye::body {

/// Rotation by an angle.
Eigen::Matrix2d rotation(double angle);

/// Its derivative.
Eigen::Matrix2d rotation_rate(double angle);

/// The pivot, about which a body turns.
struct Pivot {
  int support = -1;  ///< a rigid edge, or a point that is held along both axes; -1: contact alone guides the body
  bool names_angle = false;  ///< a rigid edge: its rotation is theta; else w without rotation fixes theta
  Vec2 centre{0.0, 0.0};     ///< c
  double hand = 1.0;         ///< of the support's axes: -1 where the second is the first turned to the right
};

/// The pivot of a body; empty where it keeps its direction, or in axisymmetry. A body turns where no support holds its
/// rotation, except by a motion or a moment of a rigid edge, and no other support of fixed direction acts on it.
std::optional<Pivot> pivot_of(const mesh::Mesh& mesh, const BodyInput& input);

/// The support because of which the rotation of a body is taken as small although nothing holds it; empty where there
/// is none.
std::string keeps_direction(const mesh::Mesh& mesh, const BodyInput& input);

/// Two nodes far apart that nothing touches or holds: where no support names theta, the line between them does not turn
/// in the frame.
std::array<int, 2> chord_nodes(const mesh::Mesh& mesh, const BodyInput& input, const Pivot& pivot);

/// Loads on the columns, in the body's frame: loads that turn with the body, and dead loads at theta = 0 and a quarter
/// turn later.
struct TurningLoad {
  Vector still, along, across;

  Vector at(double angle) const;
  Vector rate(double angle) const;
};

/// A load of the scene as forces on all nodes, for history factor 1: a pressure turns with the body, all else is dead.
TurningLoad nodal_load(const mesh::Mesh& mesh, base::Analysis analysis, const fem::BoundaryLoad& load);
TurningLoad nodal_load(const mesh::Mesh& mesh, base::Analysis analysis, const fem::PointLoad& load);
TurningLoad nodal_load(const mesh::Mesh& mesh, base::Analysis analysis, const fem::BodyForce& load);

/// The columns of a body that turns. Its stiffness acts on w, which equals q except at the pivot, held along axes that
/// do not turn, and at theta, which causes no strain.
struct Turning {
  int angle = -1;                    ///< column of theta
  std::array<int, 2> pivot{-1, -1};  ///< columns of the motions of the pivot; -1: none
  double hand = 1.0;
  Vec2 centre{0.0, 0.0};
  std::vector<std::pair<int, double>>
      chord;  ///< sum of factor q[column] = 0 fixes theta; empty where a support names it

  std::vector<int> named() const;  ///< all columns of this struct: when held, neither the frame nor the body can move
  /// The turning in a choice of columns, which contains all columns of this struct.
  Turning part(const std::vector<int>& columns) const;

  double angle_of(const Vector& q) const { return q[angle]; }
  double chord_of(const Vector& q) const;

  Vector in_frame(const Vector& q) const;
  TwoPart in_frame(TwoPart q) const;                             ///< w of q, as columns
  Vector step_in_frame(const Vector& q, Vector dq) const;        ///< dw of dq at q
  void to_frame(double theta, Eigen::Ref<Vector> forces) const;  ///< forces on q as forces on w
  void to_axes(double theta, Eigen::Ref<Vector> forces) const;   ///< and back
  /// Makes the transposed stiffness of w the transposed tangent of q; `forces` on w are out of balance, `rate` is that
  /// of the loads with theta. The row of theta is the moment, where a support names it.
  void turn(const Vector& q, const Vector& forces, const Vector& rate, Eigen::Ref<Matrix> transposed) const;

 private:
  Eigen::Matrix2d axes(double theta) const;  ///< w of the pivot = axes * its motion
  Vec2 of_pivot(const Vector& q) const { return {q[pivot[0]], q[pivot[1]]}; }
};

}  // namespace reye::body
