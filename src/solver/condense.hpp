#pragma once
#include <array>
#include <vector>

#include "algebra/factor.hpp"
#include "solver/system.hpp"
#include "solver/window.hpp"

namespace reye::solver {

/// A surface node on the reduced columns, or on those in the window.
struct PlacedNode {
  body::NodePosition position;
  std::array<int, 4> column{-1, -1, -1, -1};  ///< reduced column of each term
  int angle = -1;                             ///< likewise, of the body that turns it
  int free = 0;                               ///< number of its own free columns: they come last
};

/// Returns the column, which is in the window as all are that contact acts on. Throws std::logic_error for one that is
/// not.
int inside(int column);

/// Newton's matrix with the multipliers eliminated. D is diagonal, so the balance of an active secondary node gives
/// dlambda = D^-1 (b - A dq); it goes into the rows it loads, and the node's rows become its conditions. The factorised
/// matrix can be reused for other residuals: `again`.
class Condenser {
 public:
  /// An empty matrix; `rhs`: minus the unbalanced forces, those of contact included. A multiplier along a direction
  /// that a support holds has no balance of its own: it is an unknown, in a column after the others.
  void start(const System& system, const Vector& rhs, const std::vector<contact::Interface>& faces,
             const std::vector<std::vector<PlacedNode>>& nodes);

  /// Keeps the last matrix with another right-hand side; `eliminate`, `fix` and `solve` after it renew only that.
  void again(const Vector& rhs);

  /// Tangent of a body whose columns start at `at`.
  void add_body(int at, const Matrix& tangent);

  /// A spring from a column to the ground.
  void stiffen(int column, double stiffness);

  /// The block of the transposed tangent of a body whose columns start at `at`.
  Eigen::Ref<Matrix> tangent(int at, Eigen::Index size);

  /// Derivatives of conditions and forces, per contact, from which the next matrix is made.
  const std::vector<contact::Linearised>& linearise(std::vector<contact::Interface>& contacts,
                                                    const std::vector<std::vector<Vec2>>& lambda);

  /// Derivative of the contact forces at fixed multipliers.
  void add_contact(const System& system, int contact, const contact::Interface& face,
                   const std::vector<PlacedNode>& nodes, const std::vector<Vec2>& lambda, const Reduction& reduction,
                   const Window& window, const Vector& q);

  /// Eliminates the multipliers of all contacts, which come in the order of System::elimination; a node whose balance
  /// holds a force of another node comes after that one.
  void eliminate(const System& system, const std::vector<contact::Interface>& faces,
                 const std::vector<std::vector<PlacedNode>>& nodes);

  /// Moves a column by a given amount.
  void fix(int column, double by);

  /// In place of the equation of a column: the steps of columns, times factors, add up to `value`.
  void tie(int column, const std::vector<std::pair<int, double>>& factors, double value);

  /// dq, and the held multipliers after it. Throws base::SolveError when the matrix is singular.
  Vector solve();

  /// Takes lambda of a contact along the step dq; zero at inactive nodes.
  void advance(int contact, const Vector& dq, std::vector<Vec2>& lambda) const;

 private:
  /// A share of one reduced column's equation, of or for a component of dlambda.
  struct Share {
    int column = 0, component = 0;
    double factor = 0.0;
  };
  struct Condition {
    int column = 0, row = 0;  ///< row: 2 * node (normal), 2 * node + 1 (tangential)
    double scale = 0.0;
  };
  struct Elimination {
    Matrix slope;  ///< d(lambda)/dq, one component per column
    Vector constant;
    std::vector<int> place;  ///< first column of a node, -1 when inactive
    std::vector<int> held;   ///< column of the matrix for a node's held multiplier, -1: it has none
    std::vector<Share> met;  ///< dlambda into the conditions
    std::vector<Condition> conditions;
  };
  /// One active node: its dlambda from balances, into the rows it loads.
  struct Turn {
    int contact = 0, node = 0;
    std::vector<Share> from, to;
  };
  void place(const std::vector<contact::Interface>& faces);
  void arrange(const System& system, const std::vector<contact::Interface>& faces,
               const std::vector<std::vector<PlacedNode>>& nodes);
  void express(const contact::Interface& face, const PlacedNode& node, Turn& turn);
  void load(const PlacedNode& node, Turn& turn, double factor);
  void conditions(const contact::Interface& face, const std::vector<PlacedNode>& nodes, Elimination& elim,
                  const contact::Linearised& linearised);
  void right_hand_side(const System& system, const std::vector<contact::Interface>& faces);
  void turn(const System& system, const contact::Setup& setup, const Vector& force, const Reduction& reduction,
            const Window& window, const Vector& q);
  void turn(const std::vector<PlacedNode>& nodes, const Vector& force);

  Matrix At_;  ///< transposed: one equation per column
  Vector b_;
  algebra::DenseFactor factor_;
  bool factored_ = false;
  int held_ = 0, next_held_ = 0;  ///< held multipliers; the column for the next one
  Matrix weight_;                 ///< of the conditions in the components of dlambda: one condition per column
  std::vector<contact::Linearised> linearised_;
  std::vector<Elimination> elimination_;
  std::vector<Turn> turns_;                ///< in the order of elimination
  std::vector<std::vector<Vec2>> turned_;  ///< per body: forces on its contact nodes
};

}  // namespace reye::solver
