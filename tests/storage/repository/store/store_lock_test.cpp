#include "storage/repository/store/store_lock.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <optional>

#include "tests/support/temporary_folder.hpp"

namespace floeplan::repository::store_lock_test {
namespace {

TEST(StoreLock, IsHeldByOneAtATime) {
  const support::TemporaryFolder folder;
  std::optional<StoreLock> first{folder.path()};
  try {
    const StoreLock second{folder.path()};
    FAIL() << "two hold it";
  } catch (const std::runtime_error& refused) {
    EXPECT_NE(std::string{refused.what()}.find("in use by process " + std::to_string(getpid())),
              std::string::npos)
        << refused.what();
  }
  first.reset();
  EXPECT_NO_THROW(StoreLock{folder.path()});
}

TEST(StoreLock, GoesWithAKilledProcess) {
  const support::TemporaryFolder folder;
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const pid_t child = fork();
  if (child == 0) {
    const StoreLock lock{folder.path()};
    if (write(ends[1], "x", 1) == 1) pause();
    _exit(1);
  }
  char held = 0;
  ASSERT_EQ(read(ends[0], &held, 1), 1);
  EXPECT_THROW(StoreLock{folder.path()}, std::runtime_error);
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_NO_THROW(StoreLock{folder.path()});
  close(ends[0]);
  close(ends[1]);
}

}  // namespace
}  // namespace floeplan::repository::store_lock_test
