#include "server/jobs/worker_pool.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <ctime>
#include <memory>
#include <stdexcept>
#include <vector>

#include "api/service/scenario_service.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/store/migrations.hpp"
#include "storage/sql/statement.hpp"
#include "tests/server/jobs/wait_until.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::jobs::worker_pool_test {
namespace {

using repository::JobRepository;
using repository::JobStatus;
using support::wait_until;

constexpr const char* short_plan =
    R"({"from":[-53,69],"to":[-52.9,69.05],"depart":"2026-11-20T06:00:00Z","method":"direct"})";
constexpr const char* late_plan =  // wanted a minute after its departure
    R"({"from":[-53,69],"to":[-52.9,69.05],"depart":"2026-11-20T06:00:00Z","method":"direct",)"
    R"("arrive_by":"2026-11-20T06:01:00Z"})";
constexpr const char* long_plan =
    R"({"from":[-53,69],"to":[-50,67],"depart":"2026-11-20T06:00:00Z","depart_until":"2026-11-24T06:00:00Z",)"
    R"("spacing_m":400,"sectors":5})";
constexpr const char* plan_of_many_legs =  // its document needs pages of its own
    R"({"from":[-53,69],"to":[-52.9,69.05],"depart":"2026-11-20T06:00:00Z","method":"direct","max_leg_m":100})";
constexpr const char* thousands_of_flights = R"({"scenario":"random-icebergs","runs":10000})";
constexpr core::UtcTime some_time{core::Seconds{1.8e9}};

class WorkerPoolTest : public testing::Test {
 protected:
  OpenStore open_store() {
    return [path = store_.path()] { return repository::open_store(path); };
  }
  repository::JobRecord submit(const std::string& process, const std::string& inputs,
                               const std::string& owner = {}) {
    return board_
        .submit(db_, {.process = process, .inputs_json = inputs, .owner = owner, .digest = {}}, some_time)
        .value();
  }
  JobStatus status_of(const repository::JobRecord& job) { return JobRepository{db_}.find(job.id)->status; }
  bool wait_for(const repository::JobId& id, JobStatus status) {
    return wait_until([&] { return JobRepository{db_}.find(id)->status == status; });
  }

  support::TemporaryFolder store_;
  sql::Connection db_{repository::open_store(store_.path())};
  JobBoard board_;
};

TEST_F(WorkerPoolTest, DoesAJobAndStoresItsResult) {
  WorkerPool pool{open_store(), board_, 1};
  const auto job = submit("plan-route", short_plan);

  ASSERT_TRUE(wait_for(job.id, JobStatus::successful)) << JobRepository{db_}.find(job.id)->message;
  const auto result = JobRepository{db_}.find(job.id)->result_json;
  EXPECT_NE(result->find("\"status\":\"ok\""), std::string::npos) << *result;
}

TEST_F(WorkerPoolTest, SaysOfASuccessfulJobThatThereIsNoRoute) {
  WorkerPool pool{open_store(), board_, 1};
  const auto possible = submit("plan-route", short_plan);
  const auto job = submit("plan-route", late_plan);

  ASSERT_TRUE(wait_for(job.id, JobStatus::successful)) << JobRepository{db_}.find(job.id)->message;
  const auto ended = JobRepository{db_}.find(job.id);
  EXPECT_NE(ended->result_json->find("\"status\":\"infeasible\""), std::string::npos) << *ended->result_json;
  EXPECT_THAT(ended->message, testing::StartsWith("no route: "));
  ASSERT_TRUE(wait_for(possible.id, JobStatus::successful));
  EXPECT_EQ(JobRepository{db_}.find(possible.id)->message, "");
}

TEST_F(WorkerPoolTest, FailsAJobThatCannotBeDoneWithTheReason) {
  WorkerPool pool{open_store(), board_, 1};
  const auto job = submit("no-such-process", "{}");

  ASSERT_TRUE(wait_for(job.id, JobStatus::failed));
  EXPECT_NE(JobRepository{db_}.find(job.id)->message.find("no-such-process"), std::string::npos);
}

TEST_F(WorkerPoolTest, KeepsAPlanForWhichTheDiskHasNoRoomUntilThereIs) {
  sql::execute(
      db_,
      "CREATE TABLE filler AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < "
      "100) SELECT i, randomblob(8000) FROM n");
  const auto job = submit("plan-route", plan_of_many_legs);
  const OpenStore open_full_store = [open = open_store()] {
    sql::Connection db = open();
    sql::execute(db, "PRAGMA max_page_count = 1");  // no more pages than there are
    return db;
  };
  WorkerPool pool{open_full_store, board_, 1};
  ASSERT_TRUE(wait_until([&] {
    const auto found = JobRepository{db_}.find(job.id);
    return found->status == JobStatus::accepted && found->updated != job.updated;
  }));

  sql::execute(db_, "DROP TABLE filler");  // its pages become free

  EXPECT_TRUE(wait_for(job.id, JobStatus::successful)) << JobRepository{db_}.find(job.id)->message;
}

TEST_F(WorkerPoolTest, DoesNotStartWhileTheStoreCannotBeOpenedForEachThread) {
  constexpr int of_one_worker = 2 + 2 + static_cast<int>(WorkerPool::batches_at_once) + 1;
  for (int opened = 0; opened < of_one_worker; ++opened) {
    const OpenStore open_so_often = [open = open_store(), left = std::make_shared<int>(opened)] {
      if ((*left)-- == 0) throw std::runtime_error{"damaged meanwhile"};
      return open();
    };
    EXPECT_THROW((WorkerPool{open_so_often, board_, 1}), std::runtime_error) << opened;
  }
}

TEST_F(WorkerPoolTest, StopsADismissedJobWithinASecondOfWork) {
  WorkerPool pool{open_store(), board_, 1};
  const auto job = submit("plan-route", long_plan);
  ASSERT_TRUE(wait_for(job.id, JobStatus::running));

  const std::clock_t begin = std::clock();  // counts this program's work, whatever else the machine does
  ASSERT_TRUE(board_.dismiss(db_, job.id, some_time));
  ASSERT_TRUE(wait_until([&] { return board_.running().empty(); }));
  EXPECT_LT(std::clock() - begin, CLOCKS_PER_SEC);
  EXPECT_EQ(JobRepository{db_}.find(job.id)->status, JobStatus::dismissed);
}

TEST_F(WorkerPoolTest, KeepsARunningJobHoweverTheClockIsSet) {
  WorkerPool pool{open_store(), board_, 1};
  const auto job = submit("echo", R"({"pause":10})");
  ASSERT_TRUE(wait_for(job.id, JobStatus::running));
  const core::UtcTime a_year_ahead = std::chrono::system_clock::now() + core::Seconds{3.2e7};
  EXPECT_FALSE(JobRepository{db_}.claim("another", a_year_ahead, core::Seconds{30.0}, {}));
}

TEST_F(WorkerPoolTest, WritesTheResultDownOnceTheStoreTakesItAgain) {
  // FAIL, unlike ABORT, keeps the changes made before it.
  sql::execute(db_, R"(CREATE TABLE tried (n INTEGER) STRICT;
    CREATE TRIGGER no_room BEFORE UPDATE OF status ON job WHEN new.status = 'successful' BEGIN
      INSERT INTO tried VALUES (1); SELECT RAISE(FAIL, 'no room'); END)");
  WorkerPool pool{open_store(), board_, 1};
  const auto job = submit("echo", R"({"echo":"kept","pause":0})");
  ASSERT_TRUE(wait_until([&] {
    sql::Statement query{db_, "SELECT count(*) FROM tried"};
    return query.step() && query.integer(0) > 0;
  }));
  EXPECT_EQ(JobRepository{db_}.find(job.id)->status, JobStatus::running);

  sql::execute(db_, "DROP TRIGGER no_room");

  ASSERT_TRUE(wait_for(job.id, JobStatus::successful));
  EXPECT_EQ(JobRepository{db_}.find(job.id)->result_json, R"({"echo":"kept"})");
  EXPECT_EQ(JobRepository{db_}.find(job.id)->attempts, 1);
}

TEST_F(WorkerPoolTest, PlansWhateverBatchesRun) {
  WorkerPool pool{open_store(), board_, 1};
  std::vector<repository::JobRecord> batches;
  for (std::size_t i = 0; i <= WorkerPool::batches_at_once; ++i)  // one more than run at once
    batches.push_back(submit("fly-scenario", thousands_of_flights, "ann" + std::to_string(i)));
  ASSERT_TRUE(wait_until([&] { return board_.running().size() == WorkerPool::batches_at_once; }));

  const auto plan = submit("plan-route", short_plan, "bob");
  ASSERT_TRUE(wait_for(plan.id, JobStatus::successful)) << JobRepository{db_}.find(plan.id)->message;

  EXPECT_EQ(board_.running().size(), WorkerPool::batches_at_once) << "none was broken off for it";
  EXPECT_EQ(std::ranges::count(batches, JobStatus::running, [&](const auto& job) { return status_of(job); }),
            WorkerPool::batches_at_once);
}

TEST_F(WorkerPoolTest, PlansForOneOwnerBesideTheLongPlansOfAnother) {
  WorkerPool pool{open_store(), board_, 1};
  std::vector<repository::JobRecord> pauses;
  for (int i = 0; i < 3; ++i) pauses.push_back(submit("echo", R"({"pause":10})", "ann"));
  ASSERT_TRUE(wait_for(pauses[0].id, JobStatus::running));

  const auto plan = submit("plan-route", short_plan, "bob");
  ASSERT_TRUE(wait_for(plan.id, JobStatus::successful)) << JobRepository{db_}.find(plan.id)->message;

  EXPECT_EQ(status_of(pauses[0]), JobStatus::running);
  EXPECT_EQ(status_of(pauses[1]), JobStatus::accepted) << "ann has as many workers as she may";
}

TEST_F(WorkerPoolTest, FliesTheSameBesideASteadyStreamOfPlans) {
  WorkerPool pool{open_store(), board_, 1};
  const auto batch =
      submit("fly-scenario", R"({"scenario":"random-icebergs","runs":3,"seed":7,"avoidance":false})", "ann");

  std::size_t plans = 0;
  auto plan = submit("plan-route", short_plan, "bob");
  const bool ended = wait_until([&] {
    if (status_of(plan) == JobStatus::successful) {
      plan = submit("plan-route", short_plan, "bob");
      ++plans;
    }
    return status_of(batch) == JobStatus::successful;
  });

  ASSERT_TRUE(ended);
  EXPECT_GT(plans, 0U);
  const auto alone =
      service::fly_scenario_document({.runs = 3, .seed = 7, .avoidance = false}, core::in_order(), {}, {});
  EXPECT_EQ(JobRepository{db_}.find(batch.id)->result_json, (nlohmann::json{{"scenario", alone}}.dump()));
}

TEST_F(WorkerPoolTest, FailsAJobBeyondItsTimeLimitAndGoesOn) {
  WorkerPool pool{open_store(), board_, 1, {}, {.interactive = core::Seconds{0.3}}};
  const auto endless = submit("echo", R"({"pause":10})");
  const auto next = submit("echo", R"({"pause":0})");

  ASSERT_TRUE(wait_for(endless.id, JobStatus::failed));
  const std::string message = JobRepository{db_}.find(endless.id)->message;
  EXPECT_THAT(message, testing::HasSubstr("stopped after 0.3 s"));
  EXPECT_THAT(message, testing::HasSubstr("ask for less at once"));
  EXPECT_THAT(message, testing::HasSubstr("--max-interactive-s"));
  EXPECT_TRUE(wait_for(next.id, JobStatus::successful));
}

TEST_F(WorkerPoolTest, LimitsEachClassByItself) {
  WorkerPool pool{open_store(), board_, 1, {}, {.batch = core::Seconds{0.0}}};
  const auto batch = submit("fly-scenario", thousands_of_flights);
  const auto plan = submit("plan-route", short_plan);

  EXPECT_TRUE(wait_for(batch.id, JobStatus::failed));
  EXPECT_THAT(JobRepository{db_}.find(batch.id)->message, testing::HasSubstr("--max-batch-s"));
  EXPECT_TRUE(wait_for(plan.id, JobStatus::successful));
}

TEST_F(WorkerPoolTest, EndsAPauseThatWasDismissed) {
  WorkerPool pool{open_store(), board_, 1};
  const auto job = submit("echo", R"({"pause":10})");
  ASSERT_TRUE(wait_for(job.id, JobStatus::running));

  ASSERT_TRUE(board_.dismiss(db_, job.id, some_time));
  EXPECT_TRUE(wait_until([&] { return board_.running().empty(); }));
}

TEST_F(WorkerPoolTest, GivesBackWhatEchoWasSent) {
  WorkerPool pool{open_store(), board_, 1};
  const auto job = submit("echo", R"({"echo":"teststring","numbers":[1,2],"pause":0})");

  ASSERT_TRUE(wait_for(job.id, JobStatus::successful));
  EXPECT_EQ(JobRepository{db_}.find(job.id)->result_json, R"({"echo":"teststring","numbers":[1,2]})");
}

TEST_F(WorkerPoolTest, HandsARunningJobBackWhenItStops) {
  WorkerPool pool{open_store(), board_, 1};
  const auto job = submit("plan-route", long_plan);
  ASSERT_TRUE(wait_for(job.id, JobStatus::running));

  pool.stop();
  const auto handed_back = JobRepository{db_}.find(job.id);
  EXPECT_EQ(handed_back->status, JobStatus::accepted);
  EXPECT_EQ(handed_back->attempts, 0);
}

TEST_F(WorkerPoolTest, WakesThoseWhoWaitForAJob) {
  const auto job = submit("plan-route", short_plan);
  std::atomic<int> woken{0};
  const auto subscription = board_.subscribe(job.id, [&] { ++woken; });
  WorkerPool pool{open_store(), board_, 1};

  ASSERT_TRUE(wait_for(job.id, JobStatus::successful));
  EXPECT_TRUE(wait_until([&] { return woken > 0; }));
}

}  // namespace
}  // namespace floeplan::jobs::worker_pool_test
