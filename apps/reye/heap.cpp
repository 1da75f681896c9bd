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
  constexpr int largest_array = 32 << 20;             // more is mapped on its own and given back: memory of large scenes
  constexpr int kept = 256 << 20, ahead = 64 << 20;   // bytes
  mallopt(M_MMAP_THRESHOLD, largest_array);
  mallopt(M_TRIM_THRESHOLD, kept);
  mallopt(M_TOP_PAD, ahead);
  // Addresses alone: a page takes memory when it is written to.
  constexpr std::size_t page = 2u << 20, reserved = 24u << 20;
  if (void* block = std::malloc(reserved)) {
    const auto from = (reinterpret_cast<std::uintptr_t>(block) + page - 1) / page * page;
    madvise(reinterpret_cast<void*>(from), ahead, MADV_HUGEPAGE);
    std::free(block);
  }
}

#else

void keep_heap() {}

#endif

}  // namespace reye::apps
