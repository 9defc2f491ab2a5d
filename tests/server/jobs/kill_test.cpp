#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "server/jobs/job_board.hpp"
#include "storage/repository/migrations.hpp"
#include "tests/server/jobs/wait_until.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::jobs {
namespace {

using repository::JobRepository;
using repository::JobStatus;

/// The real program, serving a store, in a process of its own.
class ServerProcess {
 public:
  explicit ServerProcess(const std::filesystem::path& store) : pid_{fork()} {
    if (pid_ != 0) return;
    const std::string program = FLOEPLAN_BINARY_DIR "/floeplan";
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDERR_FILENO);
    execl(program.c_str(), "floeplan", "--data", store.c_str(), "serve", "--listen", "127.0.0.1:0", nullptr);
    _exit(127);
  }
  ~ServerProcess() {
    if (pid_ > 0) end(SIGKILL);
  }
  ServerProcess(const ServerProcess&) = delete;
  ServerProcess& operator=(const ServerProcess&) = delete;

  /// Returns the status as waitpid gives it.
  int end(int signal) {
    int status = 0;
    kill(pid_, signal);
    waitpid(pid_, &status, 0);
    pid_ = -1;
    return status;
  }

 private:
  pid_t pid_;
};

TEST(KilledServer, DoesItsJobOnceMoreAfterTheRestart) {
  const support::TemporaryFolder store;
  auto db = repository::open_store(store.path());
  JobBoard queue;
  const auto job = queue.submit(
      db, "plan-route",
      R"({"from":[-53,69],"to":[-50,67],"depart":"2026-11-20T06:00:00Z","spacing_m":400,"sectors":5})",
      core::UtcTime{core::Seconds{1.8e9}});
  ASSERT_TRUE(job.has_value());
  const auto reached = [&](JobStatus status) {
    return support::wait_until([&] { return JobRepository{db}.find(job->id)->status == status; });
  };
  {
    ServerProcess killed{store.path()};
    ASSERT_TRUE(reached(JobStatus::running));
    killed.end(SIGKILL);
  }
  ASSERT_EQ(JobRepository{db}.find(job->id)->status, JobStatus::running);

  ServerProcess restarted{store.path()};
  ASSERT_TRUE(reached(JobStatus::successful)) << JobRepository{db}.find(job->id)->message;
  EXPECT_EQ(JobRepository{db}.find(job->id)->attempts, 2);
  EXPECT_EQ(restarted.end(SIGTERM), 0);
}

}  // namespace
}  // namespace floeplan::jobs
