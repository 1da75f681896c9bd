#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <ctime>

#include "cad/import/guard.hpp"
#include "support.hpp"

extern char** environ;

namespace {

using namespace reye::cad;

bool can_run_a_program() {
  pid_t pid = 0;
  const char* const words[] = {"/bin/true", nullptr};
  return ::posix_spawn(&pid, words[0], nullptr, nullptr, const_cast<char**>(words), environ) == 0;
}

bool opens(const std::string& path, int flags) {
  const int file = ::open(path.c_str(), flags, 0600);
  if (file >= 0) ::close(file);
  return file >= 0;
}

/// What a guarded process could still do, one bit each; 255: there is no guard on this system.
int freedoms(const std::string& folder) {
  if (!forbid_all_but_reading({folder})) return 255;
  int all = 0;
  if (can_run_a_program()) all |= 1;
  if (::execl("/bin/true", "true", nullptr) == 0) all |= 1;
  if (opens(folder + "/kept.txt", O_WRONLY) || opens(folder + "/kept.txt", O_RDWR) ||
      opens(folder + "/kept.txt", O_RDONLY | O_TRUNC))
    all |= 2;
  if (opens(folder + "/made.txt", O_RDONLY | O_CREAT) || opens(folder, O_TMPFILE | O_WRONLY)) all |= 4;
  if (::unlink((folder + "/kept.txt").c_str()) == 0 ||
      ::rename((folder + "/kept.txt").c_str(), (folder + "/b").c_str()) == 0)
    all |= 8;
  if (::socket(AF_INET, SOCK_STREAM, 0) >= 0) all |= 16;
  if (::kill(::getppid(), 0) == 0) all |= 32;
  if (!opens(folder + "/kept.txt", O_RDONLY)) all |= 64;
  return all;
}

// A guarded process must read files of its folder, and neither run programs, write, make or remove files, reach the
// network, nor send signals.
TEST(guard, leaves_reading_alone) {
  const std::string folder = std::filesystem::path(temporary_file("kept.txt", "kept")).parent_path().string();
  const pid_t child = ::fork();
  if (child == 0) ::_exit(freedoms(folder));
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  if (WEXITSTATUS(status) == 255) GTEST_SKIP() << "no filter of system calls here";
  EXPECT_EQ(WEXITSTATUS(status), 0);
  std::ifstream file(folder + "/kept.txt");
  std::string text;
  EXPECT_TRUE(std::getline(file, text) && text == "kept");
}

// A limited process must be ended when it computes too long, and get no more memory than it may have.
TEST(guard, limits) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the sanitizer itself takes terabytes of addresses";
#endif
  const pid_t child = ::fork();
  if (child == 0) {
    limit_memory();
    if (std::malloc(std::size_t{4} << 30)) ::_exit(1);
    limit_computing(0);
    while (std::clock() >= 0) {
    }
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), SIGXCPU);
}

}  // namespace
