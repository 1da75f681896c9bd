#include "cad/part/importer_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <stdexcept>

#include "cad/part/beside.hpp"

extern char** environ;

namespace reye::cad {

namespace {

constexpr int pipe_of_importer = 3;

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Starts the process with its requests as standard input, its pipe as descriptor 3 and no other open file of this
/// program.
pid_t start(const std::string& program, const std::vector<std::string>& arguments, const std::string& folder,
            int requests, int pipe) {
  posix_spawn_file_actions_t files;
  ::posix_spawn_file_actions_init(&files);
  if (!folder.empty()) ::posix_spawn_file_actions_addchdir_np(&files, folder.c_str());
  ::posix_spawn_file_actions_adddup2(&files, requests, STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&files, pipe, pipe_of_importer);
  for (int out : {STDOUT_FILENO, STDERR_FILENO})
    ::posix_spawn_file_actions_addopen(&files, out, "/dev/null", O_WRONLY, 0);
  ::posix_spawn_file_actions_addclosefrom_np(&files, pipe_of_importer + 1);
  std::vector<char*> words{const_cast<char*>(program.c_str())};
  for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  pid_t pid = 0;
  const int error = ::posix_spawn(&pid, program.c_str(), &files, nullptr, words.data(), environ);
  ::posix_spawn_file_actions_destroy(&files);
  if (error != 0) throw std::runtime_error("the importer " + program + " cannot be started: " + std::strerror(error));
  return pid;
}

std::string in_words(int signal, const Task& task) {
  const char* const mend = "; export the file again from the program it comes from, or in another format";
  if (signal == SIGXCPU)
    return task.doing + " takes more than " + std::to_string(task.computing_s) +
           " s of computing; a file that you trust may take longer with --trust-geometry";
  return "the program that " + task.does + " it crashes on it (" + ::strsignal(signal) + ")" + mend;
}

void close_both(const int (&ends)[2]) {
  for (int end : ends)
    if (end >= 0) ::close(end);
}

}  // namespace

ImporterProcess::ImporterProcess(const std::vector<std::string>& arguments, const std::string& folder)
    : starter_(::getpid()) {
  int ends[2] = {-1, -1}, asking[2] = {-1, -1};
  if (::pipe2(ends, O_CLOEXEC) != 0 || ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, asking) != 0) {
    const std::string why = std::strerror(errno);
    close_both(ends);
    throw std::runtime_error("no pipe to the importer: " + why);
  }
  try {
    pid_ = start(beside_program("reye-import"), arguments, folder, asking[1], ends[1]);
  } catch (...) {
    close_both(ends);
    close_both(asking);
    throw;
  }
  pipe_ = ends[0];
  requests_ = asking[0];
  ::close(ends[1]);
  ::close(asking[1]);
}

ImporterProcess::~ImporterProcess() {
  ::close(pipe_);
  ::close(requests_);
  if (pid_ == 0 || !is_own()) return;
  ::kill(pid_, SIGKILL);
  while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

bool ImporterProcess::is_own() const { return starter_ == ::getpid(); }

void ImporterProcess::ask(const std::string& bytes) {
  const std::uint64_t size = bytes.size();
  std::string all(reinterpret_cast<const char*>(&size), sizeof size);
  all += bytes;
  for (std::size_t at = 0; at < all.size();) {
    const ssize_t n = ::send(requests_, all.data() + at, all.size() - at, MSG_NOSIGNAL);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return;  // it has ended, as the answer that does not come will show
    at += static_cast<std::size_t>(n);
  }
}

bool ImporterProcess::read_all(char* to, std::size_t bytes, double deadline) {
  while (bytes > 0) {
    pollfd waited{pipe_, POLLIN, 0};
    const double left = deadline - now();
    constexpr double longest_s = 1e6;  // poll counts milliseconds as int
    const int ready = left > 0.0 ? ::poll(&waited, 1, static_cast<int>(1e3 * std::min(left, longest_s)) + 1) : 0;
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) {
      too_long_ = ready == 0;
      return false;
    }
    const ssize_t n = ::read(pipe_, to, bytes);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    to += n;
    bytes -= static_cast<std::size_t>(n);
  }
  return true;
}

std::optional<std::string> ImporterProcess::message(double most_s) {
  constexpr std::uint64_t most = std::uint64_t{1} << 30;
  const double deadline = now() + most_s;
  std::uint64_t size = 0;
  if (!read_all(reinterpret_cast<char*>(&size), sizeof size, deadline)) return std::nullopt;
  too_large_ = size > most;
  if (too_large_) return std::nullopt;
  std::string text(static_cast<std::size_t>(size), '\0');
  if (!read_all(text.data(), text.size(), deadline)) return std::nullopt;
  return text;
}

bool ImporterProcess::await_end() {
  while (pid_ != 0) {
    if (::waitpid(pid_, &status_, 0) == pid_)
      pid_ = 0;
    else if (errno != EINTR)
      return false;
  }
  return true;
}

bool ImporterProcess::was_killed() {
  return !too_long_ && !too_large_ && await_end() && WIFSIGNALED(status_) && WTERMSIG(status_) == SIGKILL;
}

std::string ImporterProcess::end_in_words(const Task& task) {
  if (too_large_) return "holds more than 1 GB of outlines or mesh";
  if (too_long_) {
    return task.doing + " takes more than " + std::to_string(static_cast<int>(task.waiting_s)) +
           " s; a file that you trust may take longer with --trust-geometry";
  }
  if (!await_end()) return "the program that " + task.does + " it ended without a message";
  if (WIFSIGNALED(status_)) return in_words(WTERMSIG(status_), task);
  return "the program that " + task.does + " it ended without a message (code " + std::to_string(WEXITSTATUS(status_)) +
         ")";
}

}  // namespace reye::cad
