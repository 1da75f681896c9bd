#pragma once
#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace reye::cad {

/// Seconds that the importer may compute on one file that is not trusted, and may keep this program waiting for it.
inline constexpr int computing_s = 20;
inline constexpr double waiting_s = 40.0;

/// What the mesh of one body of such a file may take: computing, waiting, memory. A million nodes take about a minute
/// and 2 GB.
inline constexpr int meshing_s = 600;
inline constexpr double waiting_for_mesh_s = 1200.0;
inline constexpr int meshing_GB = 16;

/// What the importer is at, and how long that may take.
struct Task {
  std::string doing = "reading it";
  std::string does = "reads";  ///< "the program that reads it"
  int computing_s = cad::computing_s;
  double waiting_s = cad::waiting_s;
};

/// A running `reye-import`, which takes requests through a socket and answers by messages through a pipe, the only
/// things it shares with this program; ended with the object. A process forked from this one has no share in it.
class ImporterProcess {
 public:
  /// `folder`: in which it works; empty: in that of this program. Throws std::runtime_error when it cannot be started.
  explicit ImporterProcess(const std::vector<std::string>& arguments, const std::string& folder = {});
  ~ImporterProcess();
  ImporterProcess(const ImporterProcess&) = delete;
  ImporterProcess& operator=(const ImporterProcess&) = delete;

  /// Its next message; nothing when it has ended, does not answer within so many seconds, or the message is too long.
  std::optional<std::string> message(double most_s);

  /// Sends it a request, which it reads from its standard input, preceded by its size. One that has ended reads none.
  void ask(const std::string& bytes);

  /// Whether this process has started it, and not one that this was forked from.
  bool is_own() const;

  /// Where its last message did not come: whether it was killed from outside, as it is with the thread that started it.
  bool was_killed();

  /// Why there is no further message, as the rule of an issue.
  std::string end_in_words(const Task& task = {});

 private:
  bool read_all(char* to, std::size_t bytes, double deadline);

  /// Waits for its end; whether the system knows of it.
  bool await_end();

  pid_t pid_ = 0, starter_ = 0;
  int status_ = 0;  ///< with which it has ended, once pid_ is zero
  int pipe_ = -1;
  int requests_ = -1;
  bool too_long_ = false, too_large_ = false;
};

}  // namespace reye::cad
