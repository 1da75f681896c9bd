#pragma once
#include <string>
#include <vector>

#include "solver/active_set_watch.hpp"
#include "solver/compliance_form.hpp"
#include "solver/contacts_in_reach.hpp"
#include "solver/nonlinear_bodies.hpp"
#include "solver/report.hpp"

namespace reye::solver {

/// The matrix of a Newton step: a new one with all derivatives, a new one in compliance form, or that of the last step.
enum class StepMatrix : unsigned char { exact, compliance, kept };

/// The equations of one increment at (q, lambda), on the columns in reach, and the multipliers: an iteration places,
/// decides, measures and solves them. Work space is kept between increments; so are the reach and the last increment,
/// until `forget`.
class Increment {
 public:
  void forget();
  /// Remembers the increment from `before` to the state `accepted`.
  void remember(const SolverState& before, const SolverState& accepted);
  /// Whether `before` is of the system whose last increment is remembered.
  bool follows(const SolverState& before) const { return last_step_.size() == before.q.high.size(); }

  /// Chooses the contact nodes that take part; `limited`: those near the contact, unless `everything` is set.
  void choose_reach(const System& system, const SolverState& before, const Controls& controls, bool everything,
                    bool limited);

  /// Moves the reach to where the predicted motion takes the contact, if that is out of it: Newton would find out at
  /// the end, and continue from there. True: the reach was moved.
  bool look_ahead(const System& system, const SolverState& before, const Controls& controls);

  /// Starts from `before`, or from the state that the guess, or else the continuation of the last increment, predicts.
  /// Returns q; throws base::SolveError when a nonlinear body cannot be linearised there.
  base::TwoPart begin(const System& system, const SolverState& before, const Controls& controls, contact::Start from,
                      body::Tangent tangent);

  /// Moves the surfaces to where q puts them, and integrates.
  void place(const System& system, const base::TwoPart& q) { contacts_.place(system, q.high); }
  /// Decides the status of all nodes, as far as `allowed`; returns the number of nodes that ask for another status.
  int decide(int iteration, contact::Start from, Allowed allowed);
  /// Where no earlier increment gives the reach: narrows it round what is active by now, if that is worth it. Newton
  /// continues as it would have, on a smaller matrix. True: q has to be placed and measured again.
  bool narrow(const System& system, const Controls& controls, base::TwoPart& q);
  /// Returns to all nodes.
  void widen(const System& system, const Controls& controls, base::TwoPart& q);
  /// After `accept` has found that contact outran its reach: chooses the reach round that contact, or all nodes, and
  /// Newton continues from there. Nonlinear bodies have just been measured at q.
  void follow(const System& system, const Controls& controls, base::TwoPart& q);
  /// Balance and conditions at (q, lambda).
  Iteration measure(const System& system, const Controls& controls, const base::TwoPart& q, bool fresh);
  /// Whether steps can be taken in compliance form, on columns in reach that serve more than one increment.
  bool complies(const System& system);
  /// Whether the last matrix was in that form.
  bool in_compliance() const { return in_compliance_; }
  /// One semi-smooth Newton step about (q, lambda), or a chord step with the last matrix. Returns dq and updates
  /// lambda. Throws base::SolveError when the matrix is singular.
  Vector step(const System& system, const Controls& controls, const base::TwoPart& q, StepMatrix matrix);
  /// Whether `follow` has moved the reach since it was chosen: a start from the accepted state may need the one before.
  bool followed() const { return followed_; }

  /// Moves nonlinear bodies to the state in which contact left them, with their present tangent. Returns why this
  /// fails, or nothing.
  std::string renew(base::TwoPart& q);
  /// Linearises nonlinear bodies there. Returns why this fails, or nothing.
  std::string linearise(const base::TwoPart& q, body::Tangent tangent);
  /// Recovers the nodes out of reach and stores the state. False: contact did not stay inside the reach.
  bool accept(const System& system, const base::TwoPart& q, SolverState& state);

  /// After `accept`: the node that went through the other side of its contact undetected, in words; empty: none.
  std::string passed_through() const { return contacts_.passed_through(); }

  bool nonlinear() const { return nonlinear_.any(); }
  bool touching() const;  ///< whether a node of some contact is active
  /// Reverts the last decision on the node that is open least of those that it opened: where it left nothing in
  /// contact, a body that is pressed on would otherwise be unsupported in this iteration. False: it opened none.
  bool keep_nearest();
  ActiveSetWatch::Set active_set() const;
  double way(const Vector& dq) const;  ///< largest motion of a step [mm], rotations at the contacts' extent
  /// Why no state was found, with the nodes concerned.
  std::string not_found(const System& system, const std::vector<Iteration>& table, const NewtonOptions& options,
                        bool circles) const;

 private:
  struct Rounding {
    double inside = 0.0;  ///< possible rounding error of a body's own forces
    double scale = 0.0;   ///< force due to the rounding of positions: where none is larger, nothing is loaded
  };
  const Reduction& reduction() const { return contacts_.reduction(); }
  Vector predicted_motion(const Controls& controls) const;
  void take_columns(const System& system, const Controls& controls);
  void forget_columns();
  void change_columns(const System& system, const Controls& controls);
  std::vector<Vector> deformations(const System& system, const base::TwoPart& q) const;
  Vector residual(const System& system, const Controls& controls, const base::TwoPart& q,
                  const std::vector<Vector>& v) const;
  void turn_window(const System& system, const base::TwoPart& q);
  void tie_angles(const System& system, const base::TwoPart& q);
  Rounding rounding(const System& system, const base::TwoPart& q, const std::vector<Vector>& v) const;
  const Matrix& stiffness(std::size_t body) const;

  ContactsInReach contacts_;
  Window window_;
  bool followed_ = false;
  Vector last_step_;  ///< dq of the last accepted increment
  NonlinearBodies nonlinear_;
  Multipliers lambda_;
  Condenser condenser_;
  ComplianceForm compliance_;
  bool in_compliance_ = false;  ///< the last matrix
  Reduction::Loads loads_;
  Vector balance_, arm_;  ///< on the reduced columns
  Suspects suspects_;
};

}  // namespace reye::solver
