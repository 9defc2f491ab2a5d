#include "storage/repository/work/job_repository.hpp"

#include <gmock/gmock.h>

#include <map>
#include <mutex>
#include <thread>
#include <vector>

#include "storage/repository/store/migrations.hpp"
#include "storage/sql/transaction.hpp"
#include "tests/support/empty_store.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::repository::job_repository_test {
namespace {

using std::chrono::seconds;

constexpr core::UtcTime start = core::from_unix_seconds(1'800'000'000.25);
constexpr core::Seconds lease{60.0};

JobRecord job(const std::string& id) {
  JobRecord record;
  record.id = {id};
  record.process = "plan-route";
  record.request_json = R"({"name":")" + id + R"("})";
  record.created = start;
  return record;
}

class JobRepositoryTest : public testing::Test {
 protected:
  JobRecord found(const std::string& id) { return jobs_.find({id}).value(); }

  sql::Connection db_ = support::empty_store();
  JobRepository jobs_{db_};
};

TEST_F(JobRepositoryTest, KeepsASubmittedJob) {
  jobs_.submit(job("a"));

  const JobRecord record = found("a");
  EXPECT_EQ(record.process, "plan-route");
  EXPECT_EQ(record.request_json, R"({"name":"a"})");
  EXPECT_EQ(record.status, JobStatus::accepted);
  EXPECT_EQ(record.created, start);
  EXPECT_EQ(record.updated, start);
  EXPECT_EQ(record.started, std::nullopt);
  EXPECT_EQ(record.result_json, std::nullopt);
  EXPECT_EQ(jobs_.count(JobStatus::accepted), 1);
  EXPECT_EQ(jobs_.find({"b"}), std::nullopt);
}

TEST_F(JobRepositoryTest, RefusesAnIdTwice) {
  jobs_.submit(job("a"));
  EXPECT_THROW(jobs_.submit(job("a")), std::runtime_error);
}

TEST_F(JobRepositoryTest, ListsTheNewestFirstInPages) {
  for (const char* id : {"a", "b", "c"}) jobs_.submit(job(id));

  const auto first = jobs_.list(0, 2);
  ASSERT_EQ(first.size(), 2U);
  EXPECT_EQ(first[0].id.value, "c");
  const auto second = jobs_.list(first[1].row, 2);
  ASSERT_EQ(second.size(), 1U);
  EXPECT_EQ(second[0].id.value, "a");
}

TEST_F(JobRepositoryTest, GivesTheOldestJobToAWorker) {
  jobs_.submit(job("a"));
  jobs_.submit(job("b"));

  const auto claimed = jobs_.claim("w1", start + seconds{5}, lease);

  ASSERT_TRUE(claimed);
  EXPECT_EQ(claimed->id.value, "a");
  EXPECT_EQ(claimed->status, JobStatus::running);
  EXPECT_EQ(claimed->attempts, 1);
  EXPECT_EQ(claimed->started, start + seconds{5});
  EXPECT_EQ(jobs_.claim("w2", start, lease)->id.value, "b");
  EXPECT_FALSE(jobs_.claim("w3", start, lease));
}

TEST_F(JobRepositoryTest, GivesEachWorkerJobsOfItsClassAlone) {
  for (const JobClass of : {JobClass::ingest, JobClass::batch, JobClass::interactive}) {
    JobRecord record = job(class_name(of));
    record.job_class = of;
    jobs_.submit(record);
    EXPECT_EQ(found(class_name(of)).job_class, of);
  }

  for (const JobClass of : {JobClass::ingest, JobClass::batch, JobClass::interactive}) {
    EXPECT_EQ(jobs_.claim("w", start, lease, of)->id.value, class_name(of));
    EXPECT_FALSE(jobs_.claim("w", start, lease, of));
  }
}

TEST_F(JobRepositoryTest, GivesAWorkerOfAnyClassInteractiveJobsFirst) {
  for (const JobClass of : {JobClass::ingest, JobClass::batch, JobClass::interactive}) {
    JobRecord record = job(class_name(of));
    record.job_class = of;
    jobs_.submit(record);
  }

  std::vector<std::string> order;
  while (const auto claimed = jobs_.claim("w", start, lease)) order.push_back(claimed->id.value);

  EXPECT_THAT(order, testing::ElementsAre("interactive", "batch", "ingest"));
}

TEST_F(JobRepositoryTest, RunsNoTwoBatchesOfOneOwnerAndProcessAtOnce) {
  const auto batch = [&](const std::string& owner, const std::string& process, const std::string& id) {
    JobRecord record = job(id);
    record.owner = owner;
    record.process = process;
    record.job_class = JobClass::batch;
    jobs_.submit(record);
  };
  batch("ann", "simulate-plan", "a1");
  batch("ann", "simulate-plan", "a2");
  batch("bob", "simulate-plan", "b1");
  batch("ann", "plan-route", "a3");

  std::vector<std::string> order;
  while (const auto claimed = jobs_.claim("w", start, lease, JobClass::batch))
    order.push_back(claimed->id.value);
  EXPECT_THAT(order, testing::ElementsAre("a1", "b1", "a3"));

  ASSERT_TRUE(jobs_.succeed({"a1"}, "w", "{}", start));
  EXPECT_EQ(jobs_.claim("w", start, lease, JobClass::batch)->id.value, "a2");
}

TEST_F(JobRepositoryTest, PassesOverOwnersWithAsManyRunningJobsAsTheyMayHave) {
  for (const char* id : {"a1", "a2", "b1"}) {
    JobRecord record = job(id);
    record.owner = id[0] == 'a' ? "ann" : "bob";
    jobs_.submit(record);
  }

  EXPECT_EQ(jobs_.claim("w1", start, lease, {}, 1)->id.value, "a1");
  EXPECT_EQ(jobs_.claim("w2", start, lease, {}, 1)->id.value, "b1");
  EXPECT_FALSE(jobs_.claim("w3", start, lease, {}, 1));
  ASSERT_TRUE(jobs_.succeed({"a1"}, "w1", "{}", start));
  EXPECT_EQ(jobs_.claim("w3", start, lease, {}, 1)->id.value, "a2");
}

TEST_F(JobRepositoryTest, TakesTurnsWithinAClassWhateverElseAnOwnerRuns) {
  JobRecord batch = job("batch");
  batch.owner = "ann";
  batch.job_class = JobClass::batch;
  jobs_.submit(batch);
  ASSERT_TRUE(jobs_.claim("w1", start, lease));
  for (const char* owner : {"ann", "bob"}) {
    JobRecord record = job(owner);
    record.owner = owner;
    jobs_.submit(record);
  }

  EXPECT_EQ(jobs_.claim("w2", start, lease)->id.value, "ann") << "hers is older, and no plan of hers runs";
}

TEST_F(JobRepositoryTest, ReportsProgressAndKeepsTheLease) {
  jobs_.submit(job("a"));
  ASSERT_TRUE(jobs_.claim("w1", start, lease));

  EXPECT_TRUE(jobs_.renew({"a"}, "w1", "search", 0.25, start + seconds{50}, lease));

  EXPECT_EQ(found("a").stage, "search");
  EXPECT_EQ(found("a").progress, 0.25);
  EXPECT_FALSE(jobs_.claim("w2", start + seconds{109}, lease));
  EXPECT_TRUE(jobs_.claim("w2", start + seconds{110}, lease));
}

TEST_F(JobRepositoryTest, EndsWithItsResult) {
  jobs_.submit(job("a"));
  ASSERT_TRUE(jobs_.claim("w1", start, lease));
  ASSERT_TRUE(jobs_.renew({"a"}, "w1", "search", 0.5, start, lease));

  EXPECT_TRUE(jobs_.succeed({"a"}, "w1", R"({"status":"ok"})", start + seconds{9}));

  EXPECT_EQ(found("a").status, JobStatus::successful);
  EXPECT_EQ(found("a").result_json, R"({"status":"ok"})");
  EXPECT_EQ(found("a").finished, start + seconds{9});
  EXPECT_EQ(found("a").progress, 1.0);
  EXPECT_EQ(found("a").stage, "") << "which would be of work that is over";
  EXPECT_FALSE(jobs_.fail({"a"}, "w1", "too late", start + seconds{10}));
}

TEST_F(JobRepositoryTest, FailsWithItsReason) {
  jobs_.submit(job("a"));
  ASSERT_TRUE(jobs_.claim("w1", start, lease));

  EXPECT_TRUE(jobs_.fail({"a"}, "w1", "the disk is full", start));

  EXPECT_EQ(found("a").status, JobStatus::failed);
  EXPECT_EQ(found("a").message, "the disk is full");
}

TEST_F(JobRepositoryTest, DropsTheResultOfAWorkerWhoseLeaseAnotherTookOver) {
  jobs_.submit(job("a"));
  ASSERT_TRUE(jobs_.claim("w1", start, lease));
  ASSERT_TRUE(jobs_.claim("w2", start + lease, lease));

  EXPECT_FALSE(jobs_.renew({"a"}, "w1", "search", 0.5, start, lease));
  EXPECT_FALSE(jobs_.succeed({"a"}, "w1", "{}", start));
  EXPECT_EQ(found("a").attempts, 2);
  EXPECT_TRUE(jobs_.succeed({"a"}, "w2", "{}", start));
}

TEST_F(JobRepositoryTest, FailsAfterTheLastAttempt) {
  jobs_.submit(job("a"));
  core::UtcTime now = start;
  for (int attempt = 1; attempt <= JobRepository::max_attempts; ++attempt, now += lease) {
    ASSERT_TRUE(jobs_.claim("w", now, lease));
  }

  EXPECT_FALSE(jobs_.claim("w", now, lease));

  EXPECT_EQ(found("a").status, JobStatus::failed);
  EXPECT_EQ(found("a").finished, now);
  EXPECT_THAT(found("a").message, testing::HasSubstr("3 times"));
}

TEST_F(JobRepositoryTest, GivesBackAJobWithoutCountingTheAttempt) {
  jobs_.submit(job("a"));
  ASSERT_TRUE(jobs_.claim("w1", start, lease));

  jobs_.hand_back("w1", start + seconds{1});

  EXPECT_EQ(found("a").status, JobStatus::accepted);
  EXPECT_EQ(found("a").attempts, 0);
  EXPECT_EQ(found("a").started, std::nullopt);
  EXPECT_EQ(jobs_.claim("w2", start, lease)->attempts, 1);
}

TEST_F(JobRepositoryTest, MakesTheJobsOfAKilledServerClaimableAtOnce) {
  jobs_.submit(job("a"));
  ASSERT_TRUE(jobs_.claim("w1", start, lease));

  jobs_.release_all_leases(start + seconds{1});

  EXPECT_FALSE(jobs_.renew({"a"}, "w1", "search", 0.5, start, lease));
  EXPECT_EQ(jobs_.claim("w1", start + seconds{1}, lease)->attempts, 2);
}

TEST_F(JobRepositoryTest, DismissesAJobThatHasNotEnded) {
  for (const char* id : {"a", "b"}) jobs_.submit(job(id));
  ASSERT_TRUE(jobs_.claim("w1", start, lease));

  EXPECT_TRUE(jobs_.dismiss({"a"}, start));
  EXPECT_TRUE(jobs_.dismiss({"b"}, start));

  EXPECT_EQ(found("a").status, JobStatus::dismissed);
  EXPECT_FALSE(jobs_.renew({"a"}, "w1", "search", 0.5, start, lease));
  EXPECT_FALSE(jobs_.dismiss({"a"}, start));
  EXPECT_FALSE(jobs_.dismiss({"unknown"}, start));
  EXPECT_FALSE(jobs_.claim("w1", start + 2 * lease, lease));
}

TEST_F(JobRepositoryTest, NeverGivesARowNumberAgain) {
  jobs_.submit(job("a"));
  const auto row = found("a").row;
  EXPECT_TRUE(jobs_.remove({"a"}));
  EXPECT_FALSE(jobs_.remove({"a"}));

  jobs_.submit(job("b"));

  EXPECT_GT(found("b").row, row);
}

TEST_F(JobRepositoryTest, TakesTurnsBetweenOwners) {
  const auto of = [&](const std::string& owner, const std::string& id) {
    JobRecord record = job(id);
    record.owner = owner;
    jobs_.submit(record);
  };
  for (const char* id : {"a1", "a2", "a3"}) of("ann", id);
  of("bob", "b1");
  of("bob", "b2");

  std::vector<std::string> order;
  for (int i = 0; i < 5; ++i) order.push_back(jobs_.claim("w", start + seconds{i}, lease)->id.value);

  EXPECT_THAT(order, testing::ElementsAre("a1", "b1", "a2", "b2", "a3"));
}

TEST_F(JobRepositoryTest, LetsAnOwnerWithRunningJobsWait) {
  const auto of = [&](const std::string& owner, const std::string& id) {
    JobRecord record = job(id);
    record.owner = owner;
    jobs_.submit(record);
  };
  of("ann", "a1");
  ASSERT_TRUE(jobs_.claim("w1", start, lease));
  of("bob", "b1");
  ASSERT_TRUE(jobs_.claim("w2", start + seconds{1}, lease));
  ASSERT_TRUE(jobs_.succeed({"b1"}, "w2", "{}", start + seconds{2}));
  of("ann", "a2");
  of("bob", "b2");

  EXPECT_EQ(jobs_.claim("w2", start + seconds{3}, lease)->id.value, "b2") << "ann's first still runs";
}

TEST_F(JobRepositoryTest, FindsAJobWhoseResultFollowsFromTheSame) {
  JobRecord mine = job("mine");
  mine.owner = "ann";
  mine.digest = "d";
  jobs_.submit(mine);
  EXPECT_EQ(jobs_.find_shared("d", "ann")->id.value, "mine");
  EXPECT_FALSE(jobs_.find_shared("d", "bob")) << "ann may still dismiss it";
  EXPECT_FALSE(jobs_.find_shared("e", "ann"));

  ASSERT_TRUE(jobs_.claim("w", start, lease));
  ASSERT_TRUE(jobs_.succeed({"mine"}, "w", "{}", start));
  EXPECT_EQ(jobs_.find_shared("d", "bob")->id.value, "mine");
}

TEST_F(JobRepositoryTest, SharesNoJobThatFailedOrWasDismissed) {
  for (const char* id : {"failed", "dismissed"}) {
    JobRecord record = job(id);
    record.digest = "d";
    jobs_.submit(record);
  }
  ASSERT_TRUE(jobs_.claim("w", start, lease));
  ASSERT_TRUE(jobs_.fail({"failed"}, "w", "the disk is full", start));
  ASSERT_TRUE(jobs_.dismiss({"dismissed"}, start));

  EXPECT_FALSE(jobs_.find_shared("d", ""));
}

TEST_F(JobRepositoryTest, NumbersEveryChangeThatAClientSees) {
  jobs_.submit(job("a"));
  jobs_.submit(job("b"));
  const std::int64_t seen = jobs_.last_change();
  ASSERT_TRUE(jobs_.claim("w", start, lease));
  ASSERT_TRUE(jobs_.renew({"a"}, "w", "search", 0.5, start, lease));
  const std::int64_t then = jobs_.last_change();
  ASSERT_TRUE(jobs_.renew({"a"}, "w", "search", 0.5, start + seconds{9}, lease));

  EXPECT_EQ(jobs_.last_change(), then) << "nothing new to see";
  const auto changed = jobs_.changed_since(seen, 10);
  ASSERT_EQ(changed.size(), 1U);
  EXPECT_EQ(changed[0].id.value, "a");
  EXPECT_EQ(changed[0].change, then);
  EXPECT_THAT(jobs_.changed_since(0, 1), testing::SizeIs(1));
}

TEST_F(JobRepositoryTest, NeverGivesAChangeItsNumberAgain) {
  jobs_.submit(job("a"));
  const std::int64_t seen = jobs_.last_change();
  ASSERT_TRUE(jobs_.remove({"a"}));

  jobs_.submit(job("b"));

  EXPECT_THAT(jobs_.changed_since(seen, 10), testing::SizeIs(1));
}

TEST(JobRepository, NeverGivesAJobToTwoWorkers) {
  const support::TemporaryFolder folder;
  constexpr int job_count = 60;
  {
    sql::Connection db = open_store(folder.path());
    sql::Transaction transaction{db};
    for (int i = 0; i < job_count; ++i) JobRepository{db}.submit(job("job" + std::to_string(i)));
    transaction.commit();
  }

  std::mutex mutex;
  std::map<std::string, int> claims;
  {
    std::vector<std::jthread> workers;
    for (int i = 0; i < 4; ++i) {
      workers.emplace_back([&, name = "w" + std::to_string(i)] {
        sql::Connection db = open_store(folder.path());
        JobRepository jobs{db};
        while (const auto claimed = jobs.claim(name, start, lease)) {
          const std::scoped_lock lock{mutex};
          ++claims[claimed->id.value];
        }
      });
    }
  }

  EXPECT_EQ(claims.size(), static_cast<std::size_t>(job_count));
  EXPECT_THAT(claims, testing::Each(testing::Pair(testing::_, 1)));
}

}  // namespace
}  // namespace floeplan::repository::job_repository_test
