#include "server/jobs/job_board.hpp"

#include <gmock/gmock.h>

#include "tests/support/empty_store.hpp"

namespace floeplan::jobs::job_board_test {
namespace {

using repository::JobRepository;
using routes::SubmissionRefused;

constexpr core::UtcTime some_time{core::Seconds{1.8e9}};

routes::Submission plan(std::optional<std::string> digest = {}) {
  return {.process = "plan-route", .inputs_json = "{}", .owner = "ann", .digest = std::move(digest)};
}

repository::IdempotencyKey key(const std::string& request) { return {"ann", "key", request}; }

class JobBoardTest : public testing::Test {
 protected:
  void finish(const repository::JobId& id) {
    ASSERT_TRUE(JobRepository{db_}.claim("w", some_time, core::Seconds{60.0}));
    ASSERT_TRUE(JobRepository{db_}.succeed(id, "w", "{}", some_time));
  }

  sql::Connection db_{support::empty_store()};
  JobBoard board_;
};

TEST_F(JobBoardTest, GivesTheSameWorkTheSameJob) {
  const auto first = board_.submit(db_, plan("d"), some_time);
  EXPECT_EQ(board_.submit(db_, plan("d"), some_time)->id, first->id);
  finish(first->id);
  const auto shared = board_.submit(db_, plan("d"), some_time);
  EXPECT_EQ(shared->id, first->id);
  EXPECT_EQ(shared->status, repository::JobStatus::successful);
  EXPECT_NE(board_.submit(db_, plan("e"), some_time)->id, first->id);
  EXPECT_NE(board_.submit(db_, plan(), some_time)->id, first->id);
}

TEST_F(JobBoardTest, DoesTheSameWorkAgainWhenForced) {
  const auto first = board_.submit(db_, plan("d"), some_time);
  auto forced = plan("d");
  forced.force = true;
  EXPECT_NE(board_.submit(db_, forced, some_time)->id, first->id);
}

TEST_F(JobBoardTest, GivesTheSameKeyTheSameJob) {
  auto keyed = plan();
  keyed.key = key("request");
  const auto first = board_.submit(db_, keyed, some_time);
  EXPECT_EQ(board_.submit(db_, keyed, some_time)->id, first->id);

  auto other = plan();
  other.key = key("another request");
  EXPECT_EQ(board_.submit(db_, other, some_time).error(), SubmissionRefused::key_reused);

  ASSERT_TRUE(JobRepository{db_}.remove(first->id));
  EXPECT_EQ(board_.submit(db_, keyed, some_time).error(), SubmissionRefused::job_removed);
}

TEST_F(JobBoardTest, RefusesMoreThanTheQueueHolds) {
  auto of_nobody = plan();
  of_nobody.owner.clear();
  for (std::int64_t i = 0; i < JobBoard::max_waiting; ++i)
    ASSERT_TRUE(board_.submit(db_, of_nobody, some_time).has_value());
  EXPECT_EQ(board_.submit(db_, plan(), some_time).error(), SubmissionRefused::queue_full);
}

TEST_F(JobBoardTest, KeepsRoomForOthersWhenOneOwnerSubmitsAndSubmits) {
  auto mine = plan();
  mine.owner = "ship";
  for (int i = 0; i < JobBoard::max_waiting_of_owner; ++i)
    ASSERT_TRUE(board_.submit(db_, mine, some_time).has_value());
  EXPECT_EQ(board_.submit(db_, mine, some_time).error(), SubmissionRefused::queue_full);

  auto yours = plan();
  yours.owner = "office";
  EXPECT_TRUE(board_.submit(db_, yours, some_time).has_value());
}

TEST_F(JobBoardTest, WakesThoseWhoWaitForAnyJob) {
  int woken = 0;
  const auto subscription = board_.subscribe_to_all([&] { ++woken; });
  const auto job = board_.submit(db_, plan(), some_time);
  EXPECT_EQ(woken, 1);
  ASSERT_TRUE(board_.dismiss(db_, job->id, some_time));
  EXPECT_EQ(woken, 2);
}

}  // namespace
}  // namespace floeplan::jobs::job_board_test
