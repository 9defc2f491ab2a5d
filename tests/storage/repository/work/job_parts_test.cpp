#include "storage/repository/work/job_parts.hpp"

#include <gmock/gmock.h>

#include "tests/support/empty_store.hpp"

namespace floeplan::repository::job_parts_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr core::UtcTime start = core::from_unix_seconds(1'800'000'000.25);
constexpr core::Seconds lease{30.0};
constexpr core::Seconds later{31.0};

/// A running job of the worker "led/1".
class JobPartsTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!sql::is_shared(db_)) GTEST_SKIP() << "parts are kept at a database server (at_database_server)";
    jobs_.submit({.id = {"window"},
                  .process = "plan-route",
                  .request_json = "{}",
                  .job_class = JobClass::batch,
                  .created = start});
    ASSERT_TRUE(jobs_.claim("led/1", start, core::Seconds{300.0}));
  }

  sql::Connection db_ = support::empty_store();
  JobRepository jobs_{db_};
  JobParts parts_{db_};
  JobStage stage_{.job = {"window"}, .number = 1, .basis = "data"};
};

TEST_F(JobPartsTest, AreEachTakenOnce) {
  parts_.offer(stage_, 3);

  EXPECT_EQ(parts_.take(stage_, "a", start, lease), 0U);
  EXPECT_EQ(parts_.take(stage_, "b", start, lease), 1U);
  EXPECT_EQ(parts_.take(stage_, "a", start, lease), 2U);
  EXPECT_EQ(parts_.take(stage_, "b", start, lease), std::nullopt);
}

TEST_F(JobPartsTest, KeepWhatWasFoundToTheLastByte) {
  parts_.offer(stage_, 2);
  const std::string result{"ice\0\xff berg", 11};
  ASSERT_EQ(parts_.take(stage_, "a", start, lease), 0U);

  EXPECT_TRUE(parts_.finish(stage_, 0, "a", result));

  EXPECT_THAT(parts_.finished(stage_), ElementsAre(0U));
  EXPECT_EQ(parts_.result(stage_, 0), result);
  EXPECT_EQ(parts_.result(stage_, 1), std::nullopt);
}

TEST_F(JobPartsTest, OfALostHolderAreTakenByAnother) {
  parts_.offer(stage_, 1);
  ASSERT_EQ(parts_.take(stage_, "lost", start, lease), 0U);
  EXPECT_TRUE(parts_.renew(stage_.job, "lost", start + lease, lease));
  EXPECT_EQ(parts_.take(stage_, "other", start + later, lease), std::nullopt) << "the lease was renewed";

  EXPECT_EQ(parts_.take(stage_, "other", start + lease + later, lease), 0U);

  EXPECT_FALSE(parts_.finish(stage_, 0, "lost", "late"));
  EXPECT_TRUE(parts_.finish(stage_, 0, "other", "right"));
  EXPECT_EQ(parts_.result(stage_, 0), "right");
}

TEST_F(JobPartsTest, ThatAreGivenBackAreFreeAtOnce) {
  parts_.offer(stage_, 1);
  ASSERT_EQ(parts_.take(stage_, "a", start, lease), 0U);
  parts_.give_back(stage_.job, "a");
  EXPECT_EQ(parts_.take(stage_, "b", start, lease), 0U);
}

TEST_F(JobPartsTest, ServeTheNextLeaderWhereTheBasisIsTheSame) {
  parts_.offer(stage_, 2);
  ASSERT_EQ(parts_.take(stage_, "a", start, lease), 0U);
  ASSERT_TRUE(parts_.finish(stage_, 0, "a", "done"));

  parts_.offer(stage_, 2);
  EXPECT_THAT(parts_.finished(stage_), ElementsAre(0U));

  JobStage with_new_data = stage_;
  with_new_data.basis = "newer data";
  EXPECT_EQ(parts_.take(with_new_data, "b", start, lease), std::nullopt) << "nobody has offered them";
  parts_.offer(with_new_data, 2);
  EXPECT_THAT(parts_.finished(with_new_data), IsEmpty());
  EXPECT_THAT(parts_.finished(stage_), IsEmpty());
  EXPECT_EQ(parts_.take(with_new_data, "b", start, lease), 0U);
}

TEST_F(JobPartsTest, CallForHelpFromOtherNodesWhileSomeAreFree) {
  EXPECT_EQ(parts_.in_need("helper/", start, {}), std::nullopt);
  parts_.offer(stage_, 1);

  EXPECT_EQ(parts_.in_need("helper/", start, {}), stage_.job);
  EXPECT_EQ(parts_.in_need("led/", start, {}), std::nullopt) << "its own node does them anyway";
  EXPECT_EQ(parts_.in_need("helper/", start, {stage_.job}), std::nullopt);
  EXPECT_EQ(parts_.in_need("helper/", start + core::Seconds{301.0}, {}), std::nullopt) << "nobody leads it";
  ASSERT_EQ(parts_.take(stage_, "a", start, lease), 0U);
  EXPECT_EQ(parts_.in_need("helper/", start, {}), std::nullopt);
}

TEST_F(JobPartsTest, GoWhenTheirJobEnds) {
  parts_.offer(stage_, 2);
  ASSERT_EQ(parts_.take(stage_, "a", start, lease), 0U);
  EXPECT_TRUE(parts_.renew(stage_.job, "a", start, lease));

  jobs_.succeed(stage_.job, "led/1", "{}", start);

  EXPECT_FALSE(parts_.renew(stage_.job, "a", start, lease));
  EXPECT_FALSE(parts_.finish(stage_, 0, "a", "late"));
  EXPECT_EQ(parts_.take(stage_, "a", start + later, lease), std::nullopt);
}

TEST_F(JobPartsTest, StayWhenTheirJobGoesBackToTheQueue) {
  parts_.offer(stage_, 2);
  ASSERT_EQ(parts_.take(stage_, "a", start, lease), 0U);
  ASSERT_TRUE(parts_.finish(stage_, 0, "a", "done"));

  jobs_.hand_back("led/1", start);

  EXPECT_THAT(parts_.finished(stage_), ElementsAre(0U));
}

}  // namespace
}  // namespace floeplan::repository::job_parts_test
