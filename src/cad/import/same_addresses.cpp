#include "cad/import/same_addresses.hpp"

#include <sys/personality.h>
#include <unistd.h>

namespace reye::cad {

void start_with_same_addresses(char** words) {
  constexpr unsigned long ask = 0xffffffff;
  const int now = ::personality(ask);
  if (now == -1 || (static_cast<unsigned>(now) & ADDR_NO_RANDOMIZE) != 0) return;
  if (::personality(static_cast<unsigned>(now) | ADDR_NO_RANDOMIZE) == -1) return;
  ::execv("/proc/self/exe", words);  // comes back only where it failed
}

}  // namespace reye::cad
