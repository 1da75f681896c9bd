#pragma once
#include <string>

namespace reye::output {

/// A lock on the file .reye.lock of a folder, held by the process that writes a run into it. The kernel releases it
/// when the process ends in any way; the file stays. Reading, and `report`, need no lock.
class FolderLock {
 public:
  /// Makes the folder where there is none. Throws base::InputError when another process holds the lock,
  /// std::runtime_error when a write fails. On a file system without locks it does nothing.
  explicit FolderLock(const std::string& dir);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int fd_ = -1;
};

/// Whether a process holds it now; makes nothing.
bool is_locked(const std::string& dir);

/// The message for the second process.
std::string refusal_of_locked(const std::string& dir);

}  // namespace reye::output
