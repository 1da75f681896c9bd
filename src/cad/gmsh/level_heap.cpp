#include "cad/gmsh/level_heap.hpp"

#include <malloc.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>

namespace reye::cad {

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)

namespace {

constexpr std::size_t largest = 65536, step = 16;  // below what glibc maps apart; its sizes are multiples of 16
constexpr std::uintptr_t megabyte = 1u << 20;

/// First address behind all that is allocated.
std::uintptr_t end_of_heap() { return reinterpret_cast<std::uintptr_t>(::sbrk(0)) - ::mallinfo2().keepcost; }

/// Allocates for good and returns where: a compiler may leave out what is allocated and not used.
std::uintptr_t take(std::size_t size) {
  static void* volatile taken = nullptr;
  taken = std::malloc(size);
  return reinterpret_cast<std::uintptr_t>(taken);
}

}  // namespace

void level_heap() {
  const std::uintptr_t end = end_of_heap(), next = (end / megabyte + 2) * megabyte;
  for (std::size_t size = largest; size > 0; size -= step) {
    std::uintptr_t hole = 0;
    while ((hole = take(size)) != 0 && hole < end) {
    }
    std::free(reinterpret_cast<void*>(hole));
  }
  constexpr int most = 2 * megabyte / largest;  // where the heap cannot grow, pieces come from elsewhere, without end
  for (int pieces = 0; pieces < most && end_of_heap() + 2 * largest < next; ++pieces) take(largest);
  const std::uintptr_t left = next - end_of_heap();  // of it a head of 16 bytes
  if (left > 2 * step && left <= 2 * largest) take(left - step);
}

#else

void level_heap() {}

#endif

void level_heap_once() { [[maybe_unused]] static const bool level = (level_heap(), true); }

}  // namespace reye::cad
