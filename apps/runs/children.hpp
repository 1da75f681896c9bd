#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

/// Child processes.
namespace reye::apps {

struct Child {
  std::vector<std::string> words;  ///< program, then its arguments
  std::string log;                 ///< file that takes what it prints; empty: printed as usual
};

/// Runs them all, at most `most` at once, each with one thread for linear algebra. `ended` is called for each with its
/// number and its exit code, or 128 + the signal that ended it, or 127 when it could not be started.
/// `stops`: how often a stop has been asked for; each time running ones get a SIGTERM, and no other is started; the
/// result is then false. If this program is killed, they get a SIGTERM from the kernel. Other children of this program
/// are left alone.
bool run_children(const std::vector<Child>& children, int most, const std::function<void(std::size_t, int)>& ended,
                  const std::function<int()>& stops);

/// Whether a program of this name is found in PATH.
bool is_installed(const std::string& program);

}  // namespace reye::apps
