#include "output/folder/folder_lock.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <csignal>

#include "base/errors.hpp"
#include "output/folder/folder.hpp"
#include "sample_run.hpp"

using namespace reye::output;

// While one run holds the lock of a folder a second must be refused, with --force, too; afterwards it may.
TEST(FolderLock, OneAtATime) {
  sample::TemporaryFolder dir;
  {
    const FolderLock lock(dir.str());
    EXPECT_TRUE(is_locked(dir.str()));
    EXPECT_THROW(FolderLock(dir.str()), reye::base::InputError);
    for (const bool force : {false, true})
      EXPECT_EQ(open_folder(dir.str(), "s", "1", force), refusal_of_locked(dir.str()));
  }
  EXPECT_FALSE(is_locked(dir.str()));
  EXPECT_FALSE(open_folder(dir.str(), "s", "1", false));
  const FolderLock again(dir.str());
}

// A folder that is not there is made with the lock; to ask makes nothing.
TEST(FolderLock, MakesTheFolder) {
  sample::TemporaryFolder dir;
  EXPECT_FALSE(is_locked(dir / "a/b"));
  EXPECT_FALSE(sample::fs::exists(dir / "a"));
  const FolderLock lock(dir / "a/b");
  EXPECT_TRUE(is_locked(dir / "a/b"));
}

// The kernel must release the lock of a process that is killed.
TEST(FolderLock, EndsWithTheProcess) {
  sample::TemporaryFolder dir;
  const pid_t child = ::fork();
  if (child == 0) {
    const FolderLock lock(dir.str());
    for (;;) ::pause();
  }
  while (!is_locked(dir.str())) ::usleep(1000);
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_FALSE(is_locked(dir.str()));
}

// A link in the place of the lock must not be followed.
TEST(FolderLock, FollowsNoLink) {
  sample::TemporaryFolder dir;
  sample::fs::create_symlink(dir / "elsewhere", dir / ".reye.lock");
  EXPECT_THROW(FolderLock(dir.str()), std::runtime_error);
  EXPECT_FALSE(sample::fs::exists(dir / "elsewhere"));
}
