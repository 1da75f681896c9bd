#pragma once
#include <map>
#include <vector>

#include "contact/state.hpp"

namespace reye::solver {

/// Which nodes may change status in an iteration. opening_first: none closes while another asks to open. What lifts off
/// a thin sheet moves as a whole, and nodes that close meanwhile hold it where they will not stay.
enum class Allowed { all, opening_first, none, one };

/// Detects an active set that cycles while contact settles on one linearisation of the bodies.
/// To decide for all nodes at once, from equations not yet met, is quick; but nodes that answer each other may bring a
/// set back for ever. One that comes for the third time is taken for that. From then on the equations of a set are met
/// before it changes, and then in one node alone, the first that asks for it: where the matrix is a P-matrix no set
/// comes back (Murty's rule). If one does all the same, no set fits.
class ActiveSetWatch {
 public:
  using Set = std::vector<contact::ContactStatus>;  ///< the nodes of all contacts, one after the other

  /// Receives the set of every iteration; an unchanged set is ignored.
  void add(const Set& set) {
    if (set == last_) return;
    last_ = set;
    if (const int times = ++seen_[set]; cycling_)
      stuck_ = stuck_ || times > 1;
    else if (times == 3) {
      cycling_ = true;
      seen_ = {{set, 1}};
    }
  }

  bool cycling() const { return cycling_; }  ///< one node at a time
  bool stuck() const { return stuck_; }      ///< that went in circles, too

 private:
  std::map<Set, int> seen_;
  Set last_;
  bool cycling_ = false, stuck_ = false;
};

}  // namespace reye::solver
