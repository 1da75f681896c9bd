#pragma once
#include <vector>

namespace reye::solver {

/// Columns of which some are left out; those kept are renumbered, body by body.
struct KeptColumns {
  std::vector<int> column;  ///< of each one kept
  std::vector<int> index;   ///< of each column among those kept, -1 left out
  std::vector<int> first;   ///< per body: index of its first column kept

  /// Columns of a body, counted from its first one.
  struct Split {
    std::vector<int> near, far;
  };

  int size() const { return static_cast<int>(column.size()); }

  /// The next body, of the next `count` columns; without those that are `out`.
  template <class Out>
  Split add(int count, Out out) {
    Split split;
    first.push_back(size());
    for (int i = 0; i < count; ++i) {
      const int next = static_cast<int>(index.size());
      const bool left = out(next);
      (left ? split.far : split.near).push_back(i);
      index.push_back(left ? -1 : size());
      if (!left) column.push_back(next);
    }
    return split;
  }
};

}  // namespace reye::solver
