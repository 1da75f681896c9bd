#pragma once
#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace reye::cad {

/// A running `reye-import`, which answers by messages through a pipe, the only thing it shares with this program; ended
/// with the object.
class ImporterProcess {
 public:
  /// Throws std::runtime_error when it cannot be started.
  explicit ImporterProcess(const std::vector<std::string>& arguments);
  ~ImporterProcess();
  ImporterProcess(const ImporterProcess&) = delete;
  ImporterProcess& operator=(const ImporterProcess&) = delete;

  /// Its next message; nothing when it has ended, does not answer within so many seconds, or the message is too long.
  std::optional<std::string> message(double most_s);

  /// Why there is no further message, as the rule of an issue.
  std::string end_in_words();

 private:
  bool read_all(char* to, std::size_t bytes, double deadline);

  pid_t pid_ = 0;
  int pipe_ = -1;
  bool too_long_ = false, too_large_ = false;
};

/// Seconds that the importer may compute on one file that is not trusted, and may keep this program waiting for it.
inline constexpr int computing_s = 20;
inline constexpr double waiting_s = 40.0;

}  // namespace reye::cad
