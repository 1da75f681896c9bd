#include "children.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <map>
#include <sstream>
#include <thread>

extern char** environ;

namespace reye::apps {

namespace {

volatile std::sig_atomic_t signals = 0;

extern "C" void on_signal(int) { signals = signals + 1; }

/// Signals are counted while this lives. SIGCHLD is not ignored, as a parent may have wanted: children are waited for.
class CountedSignals {
 public:
  CountedSignals() {
    signals = 0;
    struct sigaction action {};
    action.sa_handler = on_signal;
    std::signal(SIGCHLD, SIG_DFL);
    ::sigaction(SIGINT, &action, &before_[0]);
    ::sigaction(SIGTERM, &action, &before_[1]);
  }
  ~CountedSignals() {
    ::sigaction(SIGINT, &before_[0], nullptr);
    ::sigaction(SIGTERM, &before_[1], nullptr);
  }
  CountedSignals(const CountedSignals&) = delete;
  CountedSignals& operator=(const CountedSignals&) = delete;

 private:
  struct sigaction before_[2] {};
};

/// The process of a child, in a group of its own so that a Ctrl-C reaches it once, through this program; 0 when it
/// cannot be started.
pid_t started(const Child& child) {
  posix_spawn_file_actions_t files;
  ::posix_spawn_file_actions_init(&files);
  if (!child.log.empty()) {
    ::posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, child.log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    ::posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  }
  posix_spawnattr_t attributes;
  ::posix_spawnattr_init(&attributes);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  std::vector<char*> words;
  for (const auto& word : child.words) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  pid_t pid = 0;
  const int error = ::posix_spawnp(&pid, words[0], &files, &attributes, words.data(), environ);
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&files);
  return error == 0 ? pid : 0;
}

int code_of(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

}  // namespace

bool run_children(const std::vector<Child>& children, int most, const std::function<void(std::size_t, int)>& ended) {
  constexpr const char* thread_counts[] = {"OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"};
  for (const auto* name : thread_counts) ::setenv(name, "1", 1);
  const CountedSignals counted;
  std::map<pid_t, std::size_t> running;
  std::sig_atomic_t passed_on = 0;
  std::size_t next = 0;
  while (!running.empty() || (next < children.size() && signals == 0)) {
    if (next < children.size() && signals == 0 && running.size() < static_cast<std::size_t>(most)) {
      const pid_t pid = started(children[next]);
      if (pid == 0) ended(next, 127);
      else running[pid] = next;
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
    if (passed_on != signals)
      for (const auto& [child, number] : running) ::kill(child, SIGTERM);
    passed_on = signals;
    // Asked again and again rather than waited for: no signal falls between a look and a wait.
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return signals == 0;
}

bool is_installed(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((folder + '/' + program).c_str(), X_OK) == 0) return true;
  return false;
}

}  // namespace reye::apps
