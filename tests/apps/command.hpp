#pragma once
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "support/temporary_folder.hpp"
#include "support/texts.hpp"

/// The built command as a user runs it: in a folder of its own, with what it prints and leaves on disk.
namespace reye::test {

namespace fs = std::filesystem;
using support::holds;

inline std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

struct Told {
  int code = -1;  ///< exit code, or 128 + signal
  std::string out, err;
  double peak_MB = 0.0;  ///< largest resident memory
};

/// A command that has been started and not yet waited for.
class Running {
 public:
  Running(pid_t pid, fs::path out, fs::path err) : pid_(pid), out_(std::move(out)), err_(std::move(err)) {}

  bool is_running() { return !ended(WNOHANG); }

  /// Sends a signal as soon as `when` holds; false when it ended before.
  bool signal_when(int signal, const std::function<bool()>& when) {
    while (!when()) {
      if (ended(WNOHANG)) return false;
      std::this_thread::sleep_for(std::chrono::microseconds(300));
    }
    return !ended(WNOHANG) && ::kill(pid_, signal) == 0;
  }

  Told wait() {
    ended(0);
    const int code = WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
    return {code, read(out_), read(err_), static_cast<double>(usage_.ru_maxrss) / 1024.0};
  }

 private:
  bool ended(int options) {
    if (!done_) done_ = ::wait4(pid_, &status_, options, &usage_) == pid_;
    return done_;
  }
  pid_t pid_;
  fs::path out_, err_;
  int status_ = 0;
  rusage usage_{};
  bool done_ = false;
};

/// A folder to work in, removed at the end; what is printed is kept outside of it.
class Place {
 public:
  Place() { fs::create_directories(work()); }

  fs::path work() const { return root_.path() / "work"; }
  fs::path operator/(const std::string& file) const { return work() / file; }
  void write(const std::string& file, const std::string& text) const {
    fs::create_directories((work() / file).parent_path());
    std::ofstream(work() / file, std::ios::binary) << text;
  }

  /// `file_bytes`: no file may grow beyond that, as on a full disk; 0: as the system allows. `beside`: another name
  /// where what is printed is kept while another command runs. `before` is called in the new process, for limits of
  /// another kind.
  Running start(const std::vector<std::string>& words, rlim_t file_bytes = 0, const std::string& beside = "",
                void (*before)() = nullptr) const {
    const fs::path out = root_ / ("out" + beside), err = root_ / ("err" + beside);
    const pid_t pid = ::fork();
    if (pid == 0) {
      const rlimit limit{file_bytes, file_bytes};
      if (file_bytes > 0) ::setrlimit(RLIMIT_FSIZE, &limit);
      if (before) before();
      become(words, out, err);
    }
    return {pid, out, err};
  }
  Told reye(std::vector<std::string> words, rlim_t file_bytes = 0) const {
    words.insert(words.begin(), REYE_COMMAND);
    return start(words, file_bytes).wait();
  }
  Running start_reye(std::vector<std::string> words) const {
    words.insert(words.begin(), REYE_COMMAND);
    return start(words);
  }

  /// Every file below a folder with its bytes; folders with a slash at their end.
  std::map<std::string, std::string> files(const std::string& below = "") const {
    std::map<std::string, std::string> all;
    const auto top = work() / below;
    if (!fs::exists(top)) return all;
    for (const auto& entry : fs::recursive_directory_iterator(top)) {
      const auto name = fs::relative(entry.path(), top).string();
      if (entry.is_directory())
        all[name + "/"];
      else
        all[name] = read(entry.path());
    }
    return all;
  }

 private:
  [[noreturn]] void become(const std::vector<std::string>& words, const fs::path& out, const fs::path& err) const {
    std::vector<char*> arguments;
    for (const auto& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const auto to = [](const fs::path& file, int fd) {
      ::dup2(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644), fd);
    };
    to(out, 1);
    to(err, 2);
    if (::chdir(work().c_str()) == 0) ::execv(arguments[0], arguments.data());
    ::_exit(127);
  }
  support::TemporaryFolder root_;
};

using Changes = std::vector<std::pair<std::string, std::string>>;

/// The text with each first `from` replaced; all must be there.
inline std::string changed(std::string text, const Changes& changes) {
  for (const auto& [from, to] : changes) {
    const auto at = text.find(from);
    if (at == std::string::npos) throw std::runtime_error("not in the scene: " + from);
    text.replace(at, from.size(), to);
  }
  return text;
}

/// Lines of a file of the folder; 0 when it is not there.
inline long lines(const fs::path& file) {
  const auto text = read(file);
  return std::count(text.begin(), text.end(), '\n');
}

}  // namespace reye::test
