#pragma once
#include <array>
#include <utility>
#include <vector>

#include "algebra/factor.hpp"
#include "solver/condense.hpp"

namespace reye::solver {

/// Newton's step of linear bodies that keep their direction, with multipliers and free motions of supports as unknowns:
///   dq_n = C (b_n - Q_n^T dlambda) + P ds,   C = S_nn^-1,  P = -C S_ns                              [README (6)]
///   (S_ss + S_sn P) ds + (Q_s + Q_n P)^T dlambda = b_s + P^T b_n
/// The integrals D and M in Q and the normals are held, so that errors fall by a factor of some hundred in a step, not
/// quadratically. The factorised matrix can be reused for other residuals.
class ComplianceForm {
 public:
  /// Bodies have other columns from now on.
  void forget() { tried_ = false; }

  /// Whether all bodies are linear, keep their direction and are held by their supports alone, if these stay in place.
  /// The first call after `forget` inverts their stiffness.
  bool fits(const System& system, const Reduction& reduction);

  /// Makes and factorises the matrix. Throws base::SolveError when it is singular.
  void factor(const Controls& controls, const Reduction& reduction, std::vector<contact::Interface>& faces,
              const std::vector<std::vector<PlacedNode>>& nodes, const Multipliers& lambda);

  /// dq on the reduced columns by the last matrix, from minus the unbalanced forces `b` and the conditions of `faces`;
  /// takes lambda along.
  Vector solve(const Controls& controls, const Reduction& reduction, const std::vector<contact::Interface>& faces,
               Vector b, const base::TwoPart& q, Multipliers& lambda) const;

 private:
  using Weights = std::vector<std::pair<int, double>>;

  /// The compliance of a body: columns of nodes come first, then those of supports.
  struct Part {
    int first = 0, nodes = 0, supports = 0;  ///< first reduced column; numbers of columns
    Matrix C, P, T;                          ///< T = S_ss + S_sn P
    Vector unit;                             ///< of a support's unknown: its motion by a unit force [mm, or rad]

    int support() const { return first + nodes; }  ///< first column of supports
  };
  /// The unknowns of a node's dlambda. One is left where the tangential condition is of its own traction alone, as in
  /// slip: it is met by a step across the other.
  struct Multiplier {
    int first = -1, count = 0;  ///< unknowns; the equations of its conditions have the same numbers
    std::array<Vec2, 2> along{Vec2::UnitX(), Vec2::UnitY()};
    int met = -1;  ///< the tangential condition among those met beforehand
  };
  struct Met {
    int contact = 0, node = 0;
    Vec2 step = Vec2::Zero();  ///< dlambda per unmet condition; by it:
    Weights forces, slopes;    ///< forces on columns, and what it adds to the conditions that are equations
  };
  /// A condition that is an equation, and the columns by which it changes.
  struct Condition {
    int contact = 0, row = 0;  ///< row: 2 * node (normal), 2 * node + 1 (tangential)
    Weights slope;
  };
  static bool take(const System& system, const Reduction& reduction, int body, Part& part);
  void choose_unknowns(int contact, const contact::Interface& face);
  void number();
  void find_free(const Controls& controls, const Reduction& reduction);
  void move_supports(const Controls& controls, const Reduction& reduction);
  void load(const PlacedNode& node, const Multiplier& multiplier, double factor);
  void add_conditions(int contact, const contact::Interface& face, const std::vector<PlacedNode>& nodes);
  void close_conditions();
  const Part& part_of(int column) const { return parts_[body_of_[column]]; }

  bool tried_ = false, fits_ = false;
  std::vector<Part> parts_;
  std::vector<int> body_of_;                          ///< per reduced column
  std::vector<std::vector<Multiplier>> multipliers_;  ///< per contact and secondary node
  std::vector<Met> met_;
  std::vector<Condition> conditions_;  ///< one per unknown of a multiplier
  std::vector<int> free_;              ///< support columns that are unknowns, after those of multipliers
  Matrix motion_;                      ///< of the reduced columns, each in a column, by the unknowns
  Matrix At_;                          ///< transposed: one equation per column
  algebra::DenseFactor factor_;
  std::vector<contact::Linearised> linearised_;
  Vector slope_;  ///< of one condition by the reduced columns; zero between uses
};

}  // namespace reye::solver
