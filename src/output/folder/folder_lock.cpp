#include "output/folder/folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "base/errors.hpp"
#include "base/printable.hpp"

namespace reye::output {

namespace fs = std::filesystem;

namespace {

std::string lock_file(const std::string& dir) { return (fs::path(dir) / ".reye.lock").string(); }

}  // namespace

FolderLock::FolderLock(const std::string& dir) {
  fs::create_directories(dir);
  // Opened for writing, since over NFS only such a file can be locked exclusively.
  fd_ = ::open(lock_file(dir).c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0644);
  if (fd_ < 0)
    throw std::runtime_error("cannot write " + base::printable(lock_file(dir)) + ": " + std::strerror(errno));
  if (::flock(fd_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  ::close(fd_);
  throw base::InputError({{"--out", dir, refusal_of_locked(dir)}});
}

FolderLock::~FolderLock() { ::close(fd_); }

bool is_locked(const std::string& dir) {
  const int fd = ::open(lock_file(dir).c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
  if (fd < 0) return false;
  const bool held = ::flock(fd, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(fd);
  return held;
}

std::string refusal_of_locked(const std::string& dir) {
  return "another run is writing to the output folder " + dir +
         "; wait for its end, or choose another folder with --out";
}

}  // namespace reye::output
