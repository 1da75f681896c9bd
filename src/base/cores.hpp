#pragma once
#include <functional>

/// How many cores of this machine the process computes on. The number belongs to the process as a whole, as it does in
/// the libraries below: it is the only setting that is not passed on as a value.
namespace reye::base {

/// Cores that loops and matrices may use at once; 1 unless a `Cores` lives, and inside `side_by_side`.
int cores();

/// Physical cores that this process may run on.
int physical_cores();

/// Lets the process compute on `count` >= 1 cores until it is destroyed, when the number before it holds again.
class Cores {
 public:
  explicit Cores(int count);
  ~Cores();
  Cores(const Cores&) = delete;
  Cores& operator=(const Cores&) = delete;

 private:
  int before_;
};

/// work(0), ..., work(count - 1), side by side. Each call writes what no other one reads or writes, so that the result
/// is the same to the last bit on any number of cores. Of the exceptions that some throw, that of the lowest number is
/// thrown on. One loop at a time: from one thread, or inside a share.
void side_by_side(int count, const std::function<void(int)>& work);

/// Work on shares of 0, ..., count - 1 with `share` numbers each: work(first, end). The shares do not depend on the
/// number of cores.
void side_by_side(int count, int share, const std::function<void(int first, int end)>& work);

}  // namespace reye::base
