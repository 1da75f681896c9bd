#pragma once
#include <string>

namespace reye::output {

/// Held by whoever writes a run into a folder, on the file .reye.lock in it. The kernel lets go of it when the process
/// ends, however it does; the file stays. Reading, and `report`, need no lock.
class FolderLock {
 public:
  /// Makes the folder where there is none. Throws base::InputError when another process holds the lock,
  /// std::runtime_error when the disk refuses. A file system without locks is taken as it is.
  explicit FolderLock(const std::string& dir);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int fd_ = -1;
};

/// Whether a process holds it now; makes nothing.
bool is_locked(const std::string& dir);

/// What is said to the second.
std::string refusal_of_locked(const std::string& dir);

}  // namespace reye::output
