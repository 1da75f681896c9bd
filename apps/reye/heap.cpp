#include "heap.hpp"

#include <cstdint>
#include <cstdlib>

#if defined(__GLIBC__)
#include <malloc.h>
#include <sys/mman.h>
#endif

namespace reye::apps {

#if defined(__GLIBC__)

void keep_heap() {
  // Larger arrays are mapped on their own and given back: with 32 MB in place of 4 a scene of 145 000 dofs has a tenth
  // more memory at its peak, for no gain.
  constexpr int largest_array = 4 << 20, ahead = 64 << 20, page = 2 << 20;
  mallopt(M_MMAP_THRESHOLD, largest_array);
  mallopt(M_TRIM_THRESHOLD, ahead);
  mallopt(M_TOP_PAD, ahead);
  // The first array of the heap covers the range of the large pages, which take memory only when they are written to.
  if (void* block = std::malloc(largest_array - page / 2)) {
    const auto from = (reinterpret_cast<std::uintptr_t>(block) + page - 1) / page * page;
    madvise(reinterpret_cast<void*>(from), ahead, MADV_HUGEPAGE);
    std::free(block);
  }
}

#else

void keep_heap() {}

#endif

}  // namespace reye::apps
