#include "children.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <map>
#include <sstream>
#include <thread>

#include "signals.hpp"

namespace reye::apps {

namespace {

[[noreturn]] void become(const std::vector<char*>& words, const char* log, pid_t parent) {
  // The child has its own process group, so that Ctrl-C reaches it once, through this program; if this program is
  // killed, the child is asked to end, too.
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(127);
  if (*log != '\0') {
    const int file = ::open(log, O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW, 0644);
    if (file < 0 || ::dup2(file, STDOUT_FILENO) < 0 || ::dup2(file, STDERR_FILENO) < 0) ::_exit(127);
  }
  ::execvp(words[0], words.data());
  ::_exit(127);
}

/// The process of a child; 0 when there can be none. Between fork and exec only what a signal handler might call.
pid_t started(const Child& child) {
  std::vector<char*> words;
  for (const auto& word : child.words) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  const pid_t parent = ::getpid();
  const pid_t pid = ::fork();
  if (pid == 0) become(words, child.log.c_str(), parent);
  return std::max(pid, 0);
}

int code_of(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

}  // namespace

bool run_children(const std::vector<Child>& children, int most, const std::function<void(std::size_t, int)>& ended) {
  constexpr const char* thread_counts[] = {"OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"};
  for (const auto* name : thread_counts) ::setenv(name, "1", 1);
  std::signal(SIGCHLD, SIG_DFL);  // a parent may have wanted it ignored: children are waited for
  const StopSignals stop(false);
  std::map<pid_t, std::size_t> running;
  int passed_on = 0;
  std::size_t next = 0;
  while (!running.empty() || (next < children.size() && StopSignals::count() == 0)) {
    if (next < children.size() && StopSignals::count() == 0 && running.size() < static_cast<std::size_t>(most)) {
      const pid_t pid = started(children[next]);
      if (pid == 0)
        ended(next, 127);
      else
        running[pid] = next;
      ++next;
      continue;
    }
    int status = 0;
    const pid_t pid = ::waitpid(-1, &status, WNOHANG);
    if (const auto found = running.find(pid); found != running.end()) {
      ended(found->second, code_of(status));
      running.erase(found);
      continue;
    }
    if (passed_on != StopSignals::count())
      for (const auto& [child, number] : running) ::kill(child, SIGTERM);
    passed_on = StopSignals::count();
    // Polling instead of waiting, so that no signal is lost between a check and a wait.
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return StopSignals::count() == 0;
}

bool is_installed(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((folder + '/' + program).c_str(), X_OK) == 0) return true;
  return false;
}

}  // namespace reye::apps
