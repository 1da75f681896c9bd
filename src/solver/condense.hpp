#pragma once
#include <array>
#include <vector>

#include "solver/reduction.hpp"
#include "solver/system.hpp"

namespace reye::solver {

/// A surface node on the reduced columns.
struct PlacedNode {
  body::NodePosition position;
  std::array<int, 4> column{-1, -1, -1, -1};  ///< reduced column of each term
  int free = 0;                               ///< number of its own free columns: they come last
};

/// Newton's matrix with the multipliers eliminated. D is diagonal, so the balance of an active secondary node
/// gives lambda = D^-1 (b - A dq); it goes into the rows it loads, and the node's rows become its conditions.
class Condenser {
 public:
  /// An empty matrix; `rhs`: minus the bodies' residual.
  void start(const System& system, const Vector& rhs);

  /// Tangent of a body whose columns start at `at`.
  void add_body(int at, const Matrix& tangent) { At_.block(at, at, tangent.cols(), tangent.rows()) = tangent.transpose(); }

  /// Derivative of the contact forces at fixed multipliers.
  void add_contact(const System& system, int contact, contact::Interface& face, const std::vector<PlacedNode>& nodes,
                   const std::vector<Vec2>& lambda, const Reduction& reduction, const Vector& q);

  /// Eliminates the multipliers of one contact; contacts come in the order of System::elimination.
  void eliminate(int contact, const contact::Interface& face, const std::vector<PlacedNode>& nodes,
                 const std::vector<Vec2>& lambda);

  /// Moves a column by a given amount.
  void fix(int column, double by);

  /// dq. Throws base::SolveError when the matrix is singular.
  Vector solve();

  /// lambda of a contact after the step dq; zero at inactive nodes.
  void recover(int contact, const Vector& dq, std::vector<Vec2>& lambda) const;

 private:
  struct Elimination {
    Matrix slope;            ///< d(lambda)/dq, one component per column
    Vector constant;
    std::vector<int> place;  ///< first column of a node, -1 when inactive
  };
  void express(const contact::Interface& face, const std::vector<PlacedNode>& nodes, Elimination& elim) const;
  void load(const PlacedNode& node, const Elimination& elim, int from, double factor);
  void conditions(const contact::Interface& face, const std::vector<PlacedNode>& nodes, const std::vector<Vec2>& lambda,
                  const Elimination& elim, const contact::Linearised& linearised);
  void turn(const System& system, const contact::Setup& setup, const Vector& force, const Reduction& reduction,
            const Vector& q);

  Matrix At_;  ///< transposed: one equation per column
  Vector b_;
  std::vector<contact::Linearised> linearised_;
  std::vector<Elimination> elimination_;
  std::vector<std::vector<Vec2>> turned_;  ///< per body: forces on its contact nodes
};

}  // namespace reye::solver
