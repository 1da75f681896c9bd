#include "solver/active_set_watch.hpp"

namespace reye::solver {

void ActiveSetWatch::add(const Set& set) {
  if (set == last_) return;
  last_ = set;
  if (const int times = ++seen_[set]; cycling_)
    stuck_ = stuck_ || times > 1;
  else if (times == 3) {
    cycling_ = true;
    seen_ = {{set, 1}};
  }
}

}  // namespace reye::solver
