#pragma once
#include <string>
#include <vector>

#include "solver/condense.hpp"

namespace reye::solver {

/// The contacts of an increment on the columns in reach: the nodes that take part, their positions, and the integrals
/// there. The reach is kept between increments until `forget`.
class ContactsInReach {
 public:
  void forget() {
    chosen_ = false;
    choices_ = 0;
  }
  /// Chooses the nodes that take part; `limited`: those near the contact, and where they are few more those `ahead`
  /// (`Controls`), unless `everything` is set. False: the choice is unchanged.
  bool choose(const System& system, const SolverState& before, const std::vector<std::vector<char>>& ahead,
              bool everything, bool limited);
  /// Chooses a reach round the contact at the predicted q, where it outruns the present one. False: it does not.
  /// `lambda`: the multipliers expected there.
  bool look_ahead(const System& system, const SolverState& before, const Controls& controls, const Multipliers& lambda,
                  const Vector& q);
  /// Starts an increment from the accepted state.
  void begin(const System& system, const SolverState& before, const Controls& controls, const Guess* guess);

  /// Moves the nodes in reach to where the reduced q puts them, and integrates.
  void place(const System& system, const Vector& q) { integrate(system, reduction_.scatter(q), false); }
  /// Moves all nodes to where the global q puts them, and integrates.
  void place_all(const System& system, const Vector& q) { integrate(system, q, true); }

  /// Where no earlier increment gives the reach: narrows it round what is active by now, if that is worth it. `loads`:
  /// those on the columns of the present reach.
  bool narrow(const System& system, const Reduction::Loads& loads, base::TwoPart& q);
  /// Returns to all nodes.
  void widen(const System& system, const Reduction::Loads& loads, base::TwoPart& q) {
    change(system, Reach::all(system), loads, q);
  }
  /// Chooses the reach round the contact that was found among all nodes, or all nodes.
  void follow(const System& system, const Reduction::Loads& loads, base::TwoPart& q);
  /// Whether contact, placed among all nodes, stayed inside the reach.
  bool enclosed() const { return enclosed_by(reach_); }
  /// After `place_all`: the node that went through the other side undetected, in words; empty: none.
  std::string passed_through() const;

  bool limited() const { return limited_; }
  /// Whether the reach is kept for the next increment.
  bool chosen() const { return chosen_; }
  const Reduction& reduction() const { return reduction_; }
  std::vector<contact::Interface>& faces() { return faces_; }
  const std::vector<contact::Interface>& faces() const { return faces_; }
  /// Per contact: secondary nodes, then primary.
  const std::vector<std::vector<PlacedNode>>& nodes() const { return nodes_; }

 private:
  bool enclosed_by(const Reach& reach) const;
  void take(const System& system, Reach reach);
  Reach reach_round_faces(const System& system) const;
  void change(const System& system, Reach reach, const Reduction::Loads& loads, base::TwoPart& q);
  void limit_faces();
  void integrate(const System& system, const Vector& q, bool everything);

  Reach reach_;
  Reduction reduction_;
  bool chosen_ = false;  ///< false before anything touches and where contact outran its reach: to be chosen again
  int choices_ = 0;      ///< made since then
  bool limited_ = true;
  std::vector<contact::Interface> faces_;
  std::vector<Sides> sides_, start_;  ///< positions of the surface nodes, now and at the start of the increment
  std::vector<std::vector<PlacedNode>> nodes_;
  bool placed_in_reach_ = false;  ///< those that stand in `nodes_` are the nodes in reach, and no others
};

}  // namespace reye::solver
