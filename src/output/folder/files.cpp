#include "output/folder/files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string_view>

#include "base/printable.hpp"

namespace reye::output {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const std::string& verb, const std::string& path, int error) {
  const std::string reason =
      error == ELOOP ? "it is a symbolic link, which a run does not follow" : std::strerror(error);
  throw std::runtime_error("cannot " + verb + " " + base::printable(path) + ": " + reason);
}

/// An open file descriptor; the destructor closes what an error left open.
class Descriptor {
 public:
  /// A symbolic link at the end of the path is not followed, so that it cannot redirect where a run writes.
  Descriptor(const std::string& path, int flags) : fd_(::open(path.c_str(), flags | O_NOFOLLOW | O_CLOEXEC, 0644)) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  bool is_open() const { return fd_ >= 0; }
  bool sync() const { return ::fsync(fd_) == 0; }
  bool cut(std::uintmax_t size) const { return ::ftruncate(fd_, static_cast<off_t>(size)) == 0; }

  bool write(const std::string& text) const {
    std::size_t done = 0;
    while (done < text.size()) {
      const ssize_t count = ::write(fd_, text.data() + done, text.size() - done);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return false;
      done += static_cast<std::size_t>(count);
    }
    return true;
  }

  /// Some file systems report a full disk only here.
  bool close() {
    const int fd = fd_;
    fd_ = -1;
    return ::close(fd) == 0;
  }

 private:
  int fd_;
};

/// Writes a temporary file, on disk for good where `synced`, and renames it.
void write_and_rename(const std::string& path, const std::string& text, bool synced) {
  // The process number distinguishes the files of a run from those of a report made at the same time.
  const std::string temporary = path + '.' + std::to_string(::getpid()) + ".tmp";
  ::unlink(temporary.c_str());
  Descriptor file(temporary, O_WRONLY | O_CREAT | O_EXCL);
  if (!file.is_open()) fail("write", path, errno);
  const bool written = file.write(text) && (!synced || file.sync()) && file.close();
  if (!written || std::rename(temporary.c_str(), path.c_str()) != 0) {
    const int error = errno;
    ::unlink(temporary.c_str());
    fail("write", path, error);
  }
}

}  // namespace

void atomic_write(const std::string& path, const std::string& text) {
  write_and_rename(path, text, true);
  sync_folder(fs::path(path).parent_path().string());
}

void replace_text(const std::string& path, const std::string& text) { write_and_rename(path, text, false); }

void append_text(const std::string& path, const std::string& text) {
  Descriptor file(path, O_WRONLY | O_CREAT | O_APPEND);
  if (!file.is_open() || !file.write(text) || !file.close()) fail("write", path, errno);
}

void cut_file(const std::string& path, std::uintmax_t size) {
  Descriptor file(path, O_WRONLY);
  if (!file.is_open() || !file.cut(size) || !file.close()) fail("write", path, errno);
}

void sync_file(const std::string& path) {
  Descriptor file(path, O_WRONLY);
  if (!file.is_open() || !file.sync() || !file.close()) fail("write", path, errno);
}

void sync_folder(const std::string& path) {
  const Descriptor folder(path.empty() ? "." : path, O_RDONLY | O_DIRECTORY);
  if (folder.is_open()) (void)folder.sync();
}

void make_folder(const std::string& path) {
  if (::mkdir(path.c_str(), 0777) == 0) return sync_folder(fs::path(path).parent_path().string());
  const int error = errno;
  const auto there = fs::symlink_status(path);
  if (fs::is_symlink(there)) fail("write", path, ELOOP);
  if (!fs::is_directory(there)) fail("write", path, error);
}

std::optional<std::string> becoming(const std::string& name) {
  constexpr std::string_view end = ".tmp";
  if (!name.ends_with(end)) return {};
  const std::string_view before = std::string_view(name).substr(0, name.size() - end.size());
  const auto dot = before.rfind('.');
  if (dot == std::string_view::npos || dot + 1 == before.size()) return {};
  if (before.find_first_not_of("0123456789", dot + 1) != std::string_view::npos) return {};
  return std::string(before.substr(0, dot));
}

std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text;
  if (!file || fs::is_directory(path)) fail("read", path, file ? EISDIR : errno);
  std::array<char, 1 << 16> part;
  while (file.read(part.data(), part.size()) || file.gcount() > 0)
    text.append(part.data(), static_cast<std::size_t>(file.gcount()));
  if (file.bad()) fail("read", path, EIO);
  return text;
}

}  // namespace reye::output
