#include "runs/children.hpp"

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

namespace reye::apps {

namespace {

/// Words as the system takes them; they must outlive the result.
std::vector<char*> pointers(const std::vector<std::string>& words) {
  std::vector<char*> all;
  for (const auto& word : words) all.push_back(const_cast<char*>(word.c_str()));
  all.push_back(nullptr);
  return all;
}

/// The environment of a child: that of this program, with one thread for linear algebra.
std::vector<std::string> environment() {
  std::vector<std::string> all;
  const auto counts_threads = [](const std::string& entry) {
    return entry.starts_with("OPENBLAS_NUM_THREADS=") || entry.starts_with("OMP_NUM_THREADS=");
  };
  for (char** entry = environ; *entry; ++entry)
    if (!counts_threads(*entry)) all.emplace_back(*entry);
  all.insert(all.end(), {"OPENBLAS_NUM_THREADS=1", "OMP_NUM_THREADS=1"});
  return all;
}

[[noreturn]] void become(char* const* words, char* const* settings, const char* log, pid_t parent) {
  // The child has its own process group, so that Ctrl-C reaches it once, through this program; if this program is
  // killed, the child is asked to end, too.
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(127);
  if (*log != '\0') {
    const int file = ::open(log, O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW, 0644);
    if (file < 0 || ::dup2(file, STDOUT_FILENO) < 0 || ::dup2(file, STDERR_FILENO) < 0) ::_exit(127);
  }
  ::execvpe(words[0], words, settings);
  ::_exit(127);
}

/// The process of a child; 0 when there can be none. Between fork and exec only what a signal handler might call.
pid_t started(const Child& child) {
  const auto own = environment();
  const auto words = pointers(child.words), settings = pointers(own);
  const pid_t parent = ::getpid();
  const pid_t pid = ::fork();
  if (pid == 0) become(words.data(), settings.data(), child.log.c_str(), parent);
  return std::max(pid, 0);
}

/// Has ended children wait to be asked for, whatever a parent or the program around wants of SIGCHLD.
class WaitedFor {
 public:
  WaitedFor() {
    struct sigaction action {};
    action.sa_handler = SIG_DFL;
    ::sigaction(SIGCHLD, nullptr, &before_);
    if (before_.sa_handler == SIG_IGN) ::sigaction(SIGCHLD, &action, nullptr);
  }
  ~WaitedFor() { ::sigaction(SIGCHLD, &before_, nullptr); }
  WaitedFor(const WaitedFor&) = delete;
  WaitedFor& operator=(const WaitedFor&) = delete;

 private:
  struct sigaction before_ {};
};

using Running = std::map<pid_t, std::size_t>;

/// The first of them that has ended, with its status; one that somebody else has waited for has ended, too.
Running::iterator first_ended(Running& running, int& status) {
  return std::find_if(running.begin(), running.end(),
                      [&](const auto& child) { return ::waitpid(child.first, &status, WNOHANG) != 0; });
}

int code_of(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

}  // namespace

bool run_children(const std::vector<Child>& children, int most, const std::function<void(std::size_t, int)>& ended,
                  const std::function<int()>& stops) {
  const WaitedFor children_wait;
  Running running;
  int asked = stops(), passed_on = 0;
  std::size_t next = 0;
  while (!running.empty() || (next < children.size() && asked == 0)) {
    if (next < children.size() && asked == 0 && running.size() < static_cast<std::size_t>(most)) {
      const pid_t pid = started(children[next]);
      if (pid == 0)
        ended(next, 127);
      else
        running[pid] = next;
      ++next;
      asked = stops();
      continue;
    }
    int status = 0;
    if (const auto found = first_ended(running, status); found != running.end()) {
      ended(found->second, code_of(status));
      running.erase(found);
      continue;
    }
    asked = stops();
    if (passed_on != asked)
      for (const auto& [child, number] : running) ::kill(child, SIGTERM);
    passed_on = asked;
    // Polling instead of waiting, so that no signal is lost between a check and a wait.
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return asked == 0;
}

bool is_installed(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((folder + '/' + program).c_str(), X_OK) == 0) return true;
  return false;
}

}  // namespace reye::apps
