#pragma once
#include <array>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "algebra/compliance.hpp"
#include "algebra/factor.hpp"
#include "base/analysis.hpp"
#include "body/control_points.hpp"
#include "body/shape.hpp"
#include "body/supports.hpp"
#include "body/translation.hpp"
#include "fem/loads.hpp"
#include "material/elastic_part.hpp"
#include "material/tensor.hpp"

/// The body operator: a body as contact and solver see it, independent of its kind.
namespace reye::body {

using base::Matrix;
using base::Vec2;
using base::Vector;

/// Displacement of a node: u += q[column] * direction (2 terms for a free node, up to 3 in general).
struct Term {
  int column = -1;
  Vec2 direction{0.0, 0.0};
};

/// A node's place in the contact_nodes() of its body. Its number in the mesh and its place on a surface are ints: the
/// three meet in a contact, and one cannot be taken for another.
enum class ContactIndex : int {};

/// Position of a boundary node and its derivative with respect to q; of a mid node that of its control point. On a
/// linear body that turns dx/dangle has a part beside the terms: forces do no work on it, since the body balances them
/// on X.
struct NodePosition {
  Vec2 x;
  std::array<Term, 4> terms;
  int count = 0;
  int angle = -1;        ///< column of the rotation of a linear body that turns
  Vec2 swing{0.0, 0.0};  ///< dx/dangle beside the terms
  int turned = 4;        ///< from this term on directions turn with the angle
};

struct Turning;
struct TurningLoad;

/// A generalised dof that belongs to a support. Its work-conjugate force is r[column]; the force on the
/// body in x and y is the sum over a support's columns of r[column] * direction (rotation: zero direction).
struct SupportColumn {
  int support = 0;  ///< index into the list of supports given
  int motion = 0;   ///< 0 x, 1 y, 2 rotation
  int column = -1;
  Vec2 direction{0.0, 0.0};
};

/// One load of the scene acting on this body; the factor of its history multiplies it.
struct LoadColumn {
  std::string name;
  std::string history;
};

/// How a multiplier may act at a contact node: on both axes, along one free direction, or not at all.
struct NodeFreedom {
  int free = 2;              ///< number of free directions that no support holds
  Vec2 direction{0.0, 0.0};  ///< the free one when free == 1
};

/// The input of a body: the supports and loads of the scene that act on it, with their edges already resolved to
/// boundaries of the mesh.
struct BodyInput {
  // Compiled once: every file that holds one would else compile them.
  BodyInput();
  BodyInput(const BodyInput&);
  BodyInput(BodyInput&&) noexcept;
  BodyInput& operator=(const BodyInput&);
  BodyInput& operator=(BodyInput&&) noexcept;
  ~BodyInput();

  std::string name;
  material::Material material;
  base::Analysis analysis = base::Analysis::plane_strain;
  base::Kinematics kinematics = base::Kinematics::small;
  bool b_bar = true;  ///< the remedy for volumetric locking: B-bar at small strain, F-bar at finite
  std::vector<Support> supports;
  std::vector<fem::BoundaryLoad> boundary_loads;
  std::vector<fem::PointLoad> point_loads;
  std::vector<fem::BodyForce> body_forces;
  std::vector<std::string> contact_boundaries;  ///< their nodes are retained
  bool keeps_direction =
      false;  ///< bonded to a body that keeps its direction: together they are one body of small strain
  Vec2 centre{
      0.0,
      0.0};  ///< the centre of rotation of a linear body where no support defines it; it does not change with the shape
};

/// Calls take(load) for each load, in the order of `loads()` of the body made from them.
template <class Take>
void for_each_load(const BodyInput& input, Take&& take) {
  for (const auto& load : input.boundary_loads) take(load);
  for (const auto& load : input.point_loads) take(load);
  for (const auto& load : input.body_forces) take(load);
}

/// Linear elastic body of small strain, condensed to its retained dofs q:
/// contact nodes first (in the order of `contact_nodes`), then the columns of its supports, then the angle of a body
/// that turns without a support that names it. A body that can turn (`pivot_of`) does: its strain is small in a frame
/// that turns with it, in which the columns of contact nodes are counted; motions of supports are counted along their
/// own axes.
class LinearBody {
 public:
  /// `known`: the analysis of the body at an earlier shape, reused on the same cells.
  LinearBody(ShapePtr shape, const BodyInput& input, algebra::SchurAnalysisPtr known = {});

  const algebra::SchurAnalysisPtr& analysis() const;  ///< the part that another shape can reuse

  int dofs() const;
  const std::vector<int>& contact_nodes() const;  ///< mesh nodes; of a body that turns two more may follow
  NodePosition position(ContactIndex node, const Vector& q) const;
  NodeFreedom freedom(ContactIndex node) const;
  const std::vector<mesh::LineFacet>& curved_edges() const;  ///< on contact boundaries, mesh nodes
  const Matrix& stiffness() const;                           ///< S, constant, in the body's frame
  std::shared_ptr<const Matrix> shared_stiffness() const;
  /// The inverse that replaces S where contact moves along the body, made on first use; null where the supports, or
  /// the frame of a body that turns, leave a motion free or hold it by round-off alone.
  std::shared_ptr<const algebra::Compliance> compliance() const;
  const Turning* turning() const;       ///< null where the body keeps its direction
  double angle(const Vector& q) const;  ///< rotation of the body; 0 where it keeps its direction
  Vector residual(const Vector& q, const Vector& load_factors) const;  ///< S q - sum factor_i f_hat_i, in the frame
  Matrix tangent(const Vector& q, const Vector& load_factors = {})
      const;  ///< derivative of the residual: S, where the body does not turn
  Vector at_supports(const TwoPart& q,
                     const Vector& load_factors) const;        ///< the residual at the support columns, else 0
  Vector load(const Vector& load_factors) const;               ///< sum factor_i f_hat_i, of a body that does not turn
  TurningLoad turning_load(const Vector& load_factors) const;  ///< the load of a body that turns
  double strain_energy(const Vector& q) const;
  const Translation& translation()
      const;  ///< a translation costs no force: the residual needs `translation().without(q)` alone
  /// Displacement of all mesh nodes.
  std::vector<Vec2> recover(const Vector& q, const Vector& load_factors) const;
  /// Displacement w of all mesh nodes in the body's frame, from which the stress follows.
  std::vector<Vec2> recover_in_frame(const Vector& q, const Vector& load_factors) const;
  const std::vector<SupportColumn>& support_columns() const;
  const std::vector<LoadColumn>& loads() const;
  int full_dofs() const;  ///< before condensation

 private:
  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

/// Sets the columns of the contact nodes in q so that these take the displacements u in the frame (one per contact
/// node) as far as supports leave them free; the support columns of q and its angle are given and stay.
void seat(const LinearBody& body, const std::vector<Vec2>& u, Vector& q);

/// A body without elements: q = (u_x, u_y, theta) of its reference point c (the centre of its first support,
/// edge or point, else of its bounding box); x = c + u + R(theta) (X - c), finite rotation. u_x and u_y are along
/// the axes of that first support (x and y unless it is turned). All three motions are retained; those held by
/// no column have residual q and tangent one: in axisymmetry x and rotation, and the rotation where a node-wise
/// support holds an edge against it.
class RigidBody {
 public:
  RigidBody(ShapePtr shape, const BodyInput& input);

  static constexpr int angle = 2;  ///< column of theta
  int dofs() const { return 3; }
  const std::vector<int>& contact_nodes() const;
  NodePosition position(ContactIndex node, const Vector& q) const;
  NodeFreedom freedom(ContactIndex node) const;
  /// Derivative of `residual`: the change of the moment of dead loads with the rotation (zero without factors),
  /// and one on the diagonal of a motion the body itself holds (see below).
  Matrix tangent(const Vector& q, const Vector& load_factors = {}) const;
  Vector residual(const Vector& q, const Vector& load_factors) const;
  std::vector<Vec2> recover(const Vector& q, const Vector& load_factors) const;
  const std::vector<SupportColumn>& support_columns() const;
  const std::vector<LoadColumn>& loads() const;
  int full_dofs() const { return 3; }

  /// d^2 x / d theta^2 contracted with forces at the contact nodes: the term they add to the tangent at (theta, theta).
  double geometric(const Vector& q, const std::vector<Vec2>& contact_forces) const;

 private:
  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

/// The state of a nonlinear body beside q.
struct Interior {
  TwoPart y;                                    ///< free dofs of the nodes not in contact
  std::vector<material::PlasticState> history;  ///< per Gauss point, cell by cell; empty for an elastic material
  std::vector<material::Gradient<double>> F0;   ///< likewise, from unstressed to X; empty where X is unstressed
};

/// Which tangent a nonlinear body is linearised by. F-bar and follower pressures make it unsymmetric by about stress
/// over modulus; its symmetric part converges nearly as fast, at a third of the cost.
enum class Tangent { exact, symmetric_part };

/// Body of small-strain plasticity or of finite strain, condensed to its retained dofs q like a LinearBody, but at
/// every state. With r = f_int - sum factor_i f_i, split into interior i and retained c,
///   S = K_cc - K_ci K_ii^-1 K_ic,  r_hat = r_c - K_ci K_ii^-1 r_i,  dy = -K_ii^-1 (r_i + K_ic dq),
/// which together are the full Newton step. S need not be symmetric. At finite strain a rigid edge turns by a true
/// rotation and a pressure follows the surface; tractions, point and body forces keep their direction and size.
/// All members throw base::SolveError, naming the body, where a Gauss point cannot take the deformation.
class NonlinearBody {
 public:
  NonlinearBody(ShapePtr shape, const BodyInput& input);

  int dofs() const;
  const std::vector<int>& contact_nodes() const;  ///< mesh nodes
  NodePosition position(ContactIndex node, const Vector& q) const;
  NodeFreedom freedom(ContactIndex node) const;
  const std::vector<SupportColumn>& support_columns() const;
  const std::vector<LoadColumn>& loads() const;
  int full_dofs() const;  ///< before condensation

  const Translation& translation() const;  ///< costs no force, by q alone: S T = 0

  /// Whether the tangent is symmetric: with a law and an element that keep it so (fem::Solid::symmetric), and no
  /// follower pressure.
  bool symmetric() const;

  /// No displacement, virgin material, X unstressed.
  Interior start() const;

  /// This body without yielding: it keeps its plastic strain and responds by its elasticity alone
  /// (material::unyielding).
  NonlinearBody unyielding() const;

  /// The equations at one state, with the factorisation that `interior_step` needs. Reused from call to call: the
  /// memory and the symbolic analysis stay. A copy shares them, so that only the last one linearised is valid.
  struct Linearised {
    Matrix S;
    Vector r;                        ///< r_hat, size dofs()
    double interior_residual = 0.0;  ///< largest entry of r_i
    double force_scale = 0.0;        ///< largest nodal force that the cells exert, before they add up to balance
    double deformation = 0.0;  ///< largest displacement without rigid translation, for the size of rounding errors
    struct Kept;
    std::shared_ptr<Kept> kept;
  };
  /// The symmetric part is factorised where it is definite, else the exact tangent.
  void linearise(const Interior& before, const TwoPart& y, const TwoPart& q, const Vector& load_factors,
                 Linearised& out, Tangent tangent = Tangent::exact) const;
  /// `linearise` at the state where `measure` was called last; `before` is the one of that call.
  void linearise_again(const Interior& before, Linearised& at, Tangent tangent) const;
  /// r at another state, condensed by the tangent of `at`, for chord steps. Needs no factorisation.
  void measure(const Interior& before, const TwoPart& y, const TwoPart& q, const Vector& load_factors,
               Linearised& at) const;
  /// What of `interior_residual` is due to the tangent of `at` being a symmetric part, since it was made there.
  double left_out(const Linearised& at) const;
  Vector interior_step(const Linearised& at, const Vector& dq) const;
  /// What follows does not depend on the states at which it was linearised before.
  static void forget(Linearised& at);
  /// "node 7 at (0.25, 1.5) mm inside body strip": where the largest entry of r_i is.
  std::string least_balanced(const Linearised& at) const;

  /// r_c alone, the forces on the retained dofs. Needs no factorisation.
  Vector retained_residual(const Interior& before, const TwoPart& y, const TwoPart& q,
                           const Vector& load_factors) const;
  /// Of it what supports carry, zero elsewhere: from the cells beside them alone.
  Vector at_supports(const Interior& before, const TwoPart& y, const TwoPart& q, const Vector& load_factors) const;
  /// y with the history that the deformation from `before` to (y, q) leaves.
  Interior accepted(const Interior& before, const TwoPart& y, const TwoPart& q) const;
  /// The new F0 when x = X + u of an accepted state becomes the new X (fem::deformation). Finite strain only.
  std::vector<material::Gradient<double>> deformation(const Interior& now, const TwoPart& q) const;
  /// Per Gauss point of an accepted state what stress and yielding depend on; empty without history.
  std::vector<material::ElasticState> elastic_states(const Interior& now, const TwoPart& q) const;
  /// The history with which the deformation (y, q) from F0 leaves these elastic states (fem::compatible).
  std::vector<material::PlasticState> compatible(const Interior& now, const TwoPart& q,
                                                 const std::vector<material::ElasticState>& states) const;
  /// Elastic strain energy of an accepted state (fem::strain_energy).
  double strain_energy(const Interior& now, const TwoPart& q) const;
  /// Displacement of all mesh nodes.
  std::vector<Vec2> recover(const TwoPart& q, const TwoPart& y) const;

  /// Sets the free columns of q and y so that the nodes take the displacements u (one per mesh node) as far as supports
  /// leave them free; the support columns of q are given and stay.
  void seat(const std::vector<Vec2>& u, Vector& q, TwoPart& y) const;

  /// Per column, the sum over contact nodes of d^2 x / dq^2 . force, which turning rigid edges add to the diagonal of
  /// the tangent (zero at small strain, and where no contact node lies on a rigid edge).
  Vector geometric(const Vector& q, const std::vector<Vec2>& contact_forces) const;

 private:
  struct Impl;
  explicit NonlinearBody(std::shared_ptr<const Impl> impl);
  std::shared_ptr<const Impl> impl_;
};

using Operator = std::variant<RigidBody, LinearBody, NonlinearBody>;

/// What every body has, whichever it is.
int dofs(const Operator& op);
const std::vector<int>& contact_nodes(const Operator& op);
const std::vector<SupportColumn>& support_columns(const Operator& op);
const std::vector<LoadColumn>& loads(const Operator& op);

}  // namespace reye::body
