#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>

#include "api/codec/bytes/sha256.hpp"
#include "server/jobs/job_board.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/store/migrations.hpp"
#include "storage/repository/work/upload_folder.hpp"
#include "storage/sql/upkeep.hpp"
#include "tests/server/jobs/wait_until.hpp"
#include "tests/support/places.hpp"
#include "tests/support/property.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::jobs::kill_test {
namespace {

using repository::JobRepository;
using repository::JobStatus;

routes::Submission submission(const std::string& process, const std::string& inputs) {
  return {.process = process, .inputs_json = inputs, .owner = {}, .digest = {}};
}

/// The real program, serving a store, in a process of its own.
class ServerProcess {
 public:
  explicit ServerProcess(const std::filesystem::path& store) : pid_{fork()} {
    if (pid_ != 0) return;
    const std::string program = support::program_folder() + "/floeplan";
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
      db,
      submission(
          "plan-route",
          R"({"from":[-53,69],"to":[-50,67],"depart":"2026-11-20T06:00:00Z","spacing_m":400,"sectors":5})"),
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

/// A grid of depths that takes a moment to read.
std::string large_grid() {
  constexpr int side = 600;
  std::string text = "ncols 600\nnrows 600\nxllcorner 0\nyllcorner 50\ncellsize 0.01\n";
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) text += std::to_string(-100 - (row * column) % 97) + ' ';
    text += '\n';
  }
  return text;
}

TEST(KilledServer, StoresAnUploadWholeAndOnceWheneverItIsKilled) {
  support::for_each_seed(3, [](std::mt19937_64& rng) {
    const support::TemporaryFolder store;
    auto db = repository::open_store(store.path());
    const std::string grid = large_grid();
    std::ofstream{store.path() / "arriving"} << grid;
    const auto upload = repository::UploadFolder{store.path() / "uploads"}.add(
        store.path() / "arriving", "bed.asc", codec::sha256(grid), "", std::chrono::system_clock::now());
    JobBoard queue;
    const auto job =
        queue.submit(db, submission("ingest", R"({"positive": "up", "uploads": [")" + upload.id + "\"]}"),
                     core::UtcTime{});
    const auto reached = [&](JobStatus status) {
      return support::wait_until([&] { return JobRepository{db}.find(job->id)->status == status; });
    };
    for (int kills = 0; kills < 2; ++kills) {
      ServerProcess killed{store.path()};
      const auto moment =
          std::chrono::steady_clock::now() + std::chrono::milliseconds{support::uniform_int(rng, 50, 600)};
      static_cast<void>(support::wait_until([&] { return std::chrono::steady_clock::now() >= moment; }));
      killed.end(SIGKILL);
      EXPECT_LE(repository::DatasetRepository{db}.list().size(), 1U);
    }

    const ServerProcess restarted{store.path()};

    ASSERT_TRUE(reached(JobStatus::successful)) << JobRepository{db}.find(job->id)->message;
    const auto datasets = repository::DatasetRepository{db}.list();
    ASSERT_EQ(datasets.size(), 1U) << JobRepository{db}.find(job->id)->result_json.value_or("");
    EXPECT_EQ(datasets.front().rows_accepted, 600 * 600);
    EXPECT_TRUE(std::filesystem::is_empty(store.path() / "incoming"));
    EXPECT_EQ(sql::damage_of_structure(db), "");
  });
}

}  // namespace
}  // namespace floeplan::jobs::kill_test
