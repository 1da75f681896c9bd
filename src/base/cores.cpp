#include "base/cores.hpp"

#include <sched.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <fstream>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace reye::base {

namespace {

std::atomic<int> allowed = 1;
thread_local bool beside = false;  ///< this thread works side by side with others

/// Marks a thread while it does a share of the work.
class Beside {
 public:
  Beside() : before_(std::exchange(beside, true)) {}
  ~Beside() { beside = before_; }
  Beside(const Beside&) = delete;
  Beside& operator=(const Beside&) = delete;

 private:
  bool before_;
};

/// The threads of so many cores, as far as the machine has them. They are kept from loop to loop: starting them for
/// each let a life of many blocks grow.
tbb::task_arena& arena_of(int count) {
  static tbb::task_arena arena(count);
  static int size = count;
  if (size != std::exchange(size, count)) {
    arena.terminate();
    arena.initialize(count);
  }
  return arena;
}

}  // namespace

int cores() { return beside ? 1 : allowed.load(); }

// TBB would count them, too, but loads hwloc for it, which takes a twentieth of a short run.
int physical_cores() {
  cpu_set_t usable;
  if (sched_getaffinity(0, sizeof usable, &usable) != 0) return tbb::info::default_concurrency();
  std::set<std::string> found;
  for (int k = 0; k < CPU_SETSIZE; ++k) {
    if (!CPU_ISSET(k, &usable)) continue;
    const std::string processor = "/sys/devices/system/cpu/cpu" + std::to_string(k);
    std::string threads;  // that share its core; one by itself where the system does not say
    if (!std::getline(std::ifstream(processor + "/topology/core_cpus_list"), threads)) threads = processor;
    found.insert(threads);
  }
  return std::max(1, static_cast<int>(found.size()));
}

Cores::Cores(int count) : before_(allowed.exchange(std::max(1, count))) {}
Cores::~Cores() { allowed = before_; }

void side_by_side(int count, const std::function<void(int)>& work) {
  if (cores() == 1 || count < 2) {
    for (int i = 0; i < count; ++i) work(i);
    return;
  }
  std::vector<std::exception_ptr> thrown(static_cast<std::size_t>(count));
  arena_of(std::min(cores(), tbb::info::default_concurrency())).execute([&] {
    tbb::parallel_for(0, count, [&](int i) {
      const Beside mark;
      try {
        work(i);
      } catch (...) {
        thrown[static_cast<std::size_t>(i)] = std::current_exception();
      }
    });
  });
  for (const auto& exception : thrown)
    if (exception) std::rethrow_exception(exception);
}

void side_by_side(int count, int share, const std::function<void(int first, int end)>& work) {
  side_by_side((count + share - 1) / share, [&](int k) { work(k * share, std::min(count, (k + 1) * share)); });
}

}  // namespace reye::base
