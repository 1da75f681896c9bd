#include "cad/import/guard.hpp"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>

#include "cad/import/landlock.hpp"
#include "cad/import/system_calls.hpp"

namespace reye::cad {

namespace {

void limit(int resource, rlim_t most) {
  rlimit now{};
  if (::getrlimit(static_cast<__rlimit_resource>(resource), &now) != 0) return;
  now.rlim_cur = now.rlim_max == RLIM_INFINITY ? most : std::min(most, now.rlim_max);
  ::setrlimit(static_cast<__rlimit_resource>(resource), &now);
}

}  // namespace

void end_with_parent() { ::prctl(PR_SET_PDEATHSIG, SIGKILL); }

void ignore_ends_of_groups() {
  for (int end : {SIGINT, SIGHUP, SIGTERM}) std::signal(end, SIG_IGN);
}

void limit_memory(int gigabytes) {
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
#if defined(__SANITIZE_ADDRESS__)  // that takes terabytes of addresses
  (void)gigabytes;
#else
  limit(RLIMIT_AS, static_cast<rlim_t>(gigabytes) << 30);
#endif
}

void limit_computing(int seconds) {
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  limit(RLIMIT_CPU, static_cast<rlim_t>(used.ru_utime.tv_sec + used.ru_stime.tv_sec + 1 + seconds));
}

bool forbid_all_but_reading(const std::vector<std::string>& folders) {
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return false;
  restrict_paths(folders);
  return filter_system_calls();
}

}  // namespace reye::cad
