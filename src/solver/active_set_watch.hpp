#pragma once
#include <map>
#include <vector>

#include "contact/state.hpp"

namespace reye::solver {

/// Which nodes may change status in an iteration. opening_first: no node closes while another asks to open. A thin
/// sheet lifts off as a whole, and nodes that close meanwhile would hold it in a place where they do not stay.
enum class Allowed { all, opening_first, none, one };

/// Detects an active set that cycles while contact settles on one linearisation of the bodies.
/// A decision for all nodes at once, from equations not yet met, is quick; but nodes that react to each other may bring
/// a set back for ever. A set that comes for the third time counts as such a cycle. From then on the equations of a set
/// are met before it changes, and then in one node alone, the first that asks for it: where the matrix is a P-matrix no
/// set comes back (Murty's rule). If one does all the same, no consistent set exists.
class ActiveSetWatch {
 public:
  using Set = std::vector<contact::ContactStatus>;  ///< the nodes of all contacts, one after the other

  /// Receives the set of every iteration; an unchanged set is ignored.
  void add(const Set& set);

  bool cycling() const { return cycling_; }  ///< one node at a time
  bool stuck() const { return stuck_; }      ///< changes of one node at a time cycled, too

 private:
  std::map<Set, int> seen_;
  Set last_;
  bool cycling_ = false, stuck_ = false;
};

}  // namespace reye::solver
