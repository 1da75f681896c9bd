#pragma once
#include <string>
#include <vector>

#include "solver/condense.hpp"

/// What is asked of the solver and what it reports.
namespace reye::solver {

struct NewtonOptions {
  int max_iterations = 30;
  double force_tolerance = 1e-10;     ///< of the largest force in the system
  double condition_tolerance = 1e-9;  ///< of the largest multiplier
  bool limit_reach = true;            ///< condense out contact nodes that are far from contact
  bool chords =
      true;  ///< keep a factorised matrix, and a body's tangent, while the error falls fast; false: Newton's every time
};

/// One row of a Newton table.
struct Iteration {
  double force = 0.0;      ///< largest unbalanced force over the largest force
  double condition = 0.0;  ///< largest unmet condition, as a traction over the largest multiplier
  int changes = 0;         ///< nodes whose status changed
};

/// The kind of a failed increment.
enum class Failure : unsigned char {
  none,
  torn,            ///< a nonlinear body cannot be moved or linearised at the state of the solve
  contact_lost,    ///< a body moves without bound, or nothing holds it
  singular,        ///< the matrix is singular though a node is in contact
  astray,          ///< the predicted start leads away from equilibrium
  passed_through,  ///< a node went through the other side undetected
  no_law,          ///< a formula of wear or friction has no usable value
  no_convergence
};

struct SolveReport {
  bool converged = false;
  Failure failure = Failure::no_convergence;  ///< none when converged
  std::string reason;                         ///< the failure in words, with numbers and places; empty when converged
  std::vector<Iteration> table;
  int solves = 0;     ///< steps taken
  int matrices = 0;   ///< built and factorised for them
  int compliant = 0;  ///< of these, in compliance form
  int tangents = 0;   ///< linearisations of the nonlinear bodies
};

struct SolveResult {
  SolverState state;
  SolveReport report;
};

/// The nodes concerned where no state is found.
struct Suspects {
  struct Node {
    int contact = -1, node = -1;  ///< a secondary node; -1: none
  };
  int unbalanced = -1;   ///< reduced column with the largest unbalanced force, -1: inside a body
  std::string inside;    ///< the place there, in words
  Node unmet;            ///< the condition with the largest error
  Node asking;           ///< the first node that asked for another status in the last decision
  bool circles = false;  ///< the active set cycled under every rule
};

/// Why no state was found, in words: the errors that remain, and where. `nodes`: per contact, secondary ones first.
std::string no_convergence(const System& system, const std::vector<std::vector<PlacedNode>>& nodes,
                           const Suspects& suspects, const std::vector<Iteration>& table, const NewtonOptions& options);

}  // namespace reye::solver
