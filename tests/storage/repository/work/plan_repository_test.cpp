#include "storage/repository/work/plan_repository.hpp"

#include <gmock/gmock.h>

#include "tests/storage/repository/datasets/sample_data.hpp"
#include "tests/support/empty_store.hpp"

namespace floeplan::repository::plan_repository_test {
namespace {

PlanRecord plan(const std::string& id, const geo::BoundingBox& bounds = {}) {
  return {.row = 0,
          .id = {id},
          .name = "plan " + id,
          .created = sample_time,
          .departure = sample_time + core::Seconds{0.1},
          .arrival = sample_time + day,
          .bounds = bounds,
          .request_json = R"({"from":[1,2]})",
          .document_json = R"({"status":"ok"})"};
}

std::vector<std::string> ids(const std::vector<PlanRecord>& plans) {
  std::vector<std::string> result;
  for (const PlanRecord& record : plans) result.push_back(record.id.value);
  return result;
}

class PlanRepositoryTest : public testing::Test {
 protected:
  sql::Connection db_ = support::empty_store();
  PlanRepository plans_{db_};
};

TEST_F(PlanRepositoryTest, GivesBackWhatWasInserted) {
  const PlanRecord inserted = plan("a", {-54.1, 68.0, -50.2, 70.0});
  const auto row = plans_.insert(inserted);

  const auto found = plans_.find({"a"});

  ASSERT_TRUE(found);
  EXPECT_EQ(found->row, row);
  EXPECT_EQ(found->name, inserted.name);
  EXPECT_EQ(found->created, inserted.created);
  EXPECT_EQ(found->departure, inserted.departure);
  EXPECT_EQ(found->arrival, inserted.arrival);
  EXPECT_EQ(found->bounds, inserted.bounds);
  EXPECT_EQ(found->request_json, inserted.request_json);
  EXPECT_EQ(found->document_json, inserted.document_json);
}

TEST_F(PlanRepositoryTest, LeavesAPlanWithTheSameIdAsItIs) {
  const auto row = plans_.insert(plan("a"));
  PlanRecord other = plan("a");
  other.name = "another name";

  EXPECT_EQ(plans_.insert(other), row);
  EXPECT_EQ(plans_.find({"a"})->name, "plan a");
  EXPECT_EQ(plans_.count({}), 1);
}

TEST_F(PlanRepositoryTest, ListsThePlansOfAnAreaInPages) {
  plans_.insert(plan("far", {0.0, 0.0, 1.0, 1.0}));
  plans_.insert(plan("first", {178.0, 60.0, -178.0, 61.0}));
  plans_.insert(plan("second", {-179.0, 60.5, -179.0, 60.5}));
  const geo::BoundingBox area{179.5, 60.0, -170.0, 62.0};

  const auto page = plans_.list({.area = area}, 0, 1);
  EXPECT_THAT(ids(page), testing::ElementsAre("first"));
  EXPECT_THAT(ids(plans_.list({.area = area}, page.front().row, 10)), testing::ElementsAre("second"));
  EXPECT_EQ(plans_.count({.area = area}), 2);
  EXPECT_THAT(ids(plans_.list({}, 0, 10)), testing::ElementsAre("far", "first", "second"));
}

TEST_F(PlanRepositoryTest, NeverGivesARowNumberAgain) {
  const auto row = plans_.insert(plan("a"));
  EXPECT_TRUE(plans_.remove({"a"}));
  EXPECT_FALSE(plans_.remove({"a"}));

  EXPECT_GT(plans_.insert(plan("b")), row);
}

}  // namespace
}  // namespace floeplan::repository::plan_repository_test
