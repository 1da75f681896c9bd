#pragma once
#include <functional>
#include <string>
#include <vector>

#include "body/operator.hpp"
#include "solver/division.hpp"

/// Bodies and contacts joined into one system of equations, with its controls.
namespace reye::solver {

using base::Matrix;
using base::Points;
using base::Vec2;
using base::Vector;

/// All body operators with their place in the global vector q, and all contacts on them.
/// Derived from the shapes; renewed when one of them changes.
struct System {
  std::vector<body::Operator> bodies;
  std::vector<int> offset;  ///< first global column of each body
  int dofs = 0;
  std::vector<contact::Setup> contacts;  ///< those of the scene, then its bonds
  std::vector<int> elimination;          ///< order in which the multipliers of the contacts are eliminated
  SharedSecondary shared;                ///< nodes and facets that are secondary in several contacts
  double extent = 0.0;                   ///< of all contact surfaces [mm]
  /// Per column, the arm that converts a rotation to a motion and a moment to a force: `extent` for rotations, else
  /// one.
  Vector arm;

  auto part(const Vector& q, int body) const {
    return q.segment(offset[body], std::visit([](const auto& b) { return b.dofs(); }, bodies[body]));
  }
  /// The parts of all bodies.
  std::vector<Vector> parts(const Vector& q) const;
};

/// Places the bodies in q and orders the contacts: one whose primary nodes are secondary elsewhere comes first.
System make_system(std::vector<body::Operator> bodies, std::vector<contact::Setup> contacts);

/// The evolving state of the solver.
struct SolverState {
  // Compiled once: every file that holds one would else compile them.
  SolverState();
  SolverState(const SolverState&);
  SolverState(SolverState&&) noexcept;
  SolverState& operator=(const SolverState&);
  SolverState& operator=(SolverState&&) noexcept;
  ~SolverState();

  base::TwoPart q;                        ///< forces of stiff bodies need its rounding error, too
  std::vector<body::Interior> interiors;  ///< per body; empty but for nonlinear ones
  std::vector<contact::ContactState> contacts;
};

/// Multipliers per contact and secondary node.
using Multipliers = std::vector<std::vector<Vec2>>;

/// The expected end of an increment, from which Newton starts. It speeds up the search and does not decide the result.
struct Guess {
  Vector dq;
  std::vector<Vector> inside;  ///< change of Interior::y, per body; empty but for nonlinear ones
  Multipliers lambda;
  std::vector<std::vector<contact::ContactStatus>> status;  ///< per contact
};

/// A spring between a column and the ground: force stiffness (rest - q) on the column.
struct Spring {
  int column = 0;  ///< global
  double stiffness = 0.0, rest = 0.0;
};

/// The values imposed at the end of one increment, and the data of its contacts.
struct Controls {
  std::vector<std::pair<int, double>> prescribed;  ///< global column, value
  std::vector<std::pair<int, double>> forces;      ///< global column, force conjugate to it
  std::vector<Spring> springs;
  std::vector<Vector> load_factors;  ///< per body, per load of that body
  std::vector<contact::IncrementOptions> contacts;
  const Guess* guess = nullptr;
  /// Per contact and secondary node: whether it is expected to touch in an increment from here on; empty: not known.
  std::vector<std::vector<char>> ahead;
  double continues = 0.0;  ///< > 0: this increment continues as the last one did, this many times as far
};

/// Positions of the nodes of both sides of a contact at q.
struct Sides {
  Points secondary, primary;
};
Sides positions(const System& system, const contact::Setup& setup, const Vector& q);

/// Contact forces of all contacts added up in the global columns.
Vector contact_forces(const System& system, const std::vector<contact::ContactState>& contacts, const Vector& q);

/// Force that each support column carries: residual of the bodies plus contact forces at that column; for other columns
/// the sum is not the force that holds them.
Vector reactions(const System& system, const SolverState& state, const Controls& controls);

}  // namespace reye::solver
