#include "server/cli/serving/api_handler.hpp"

#include <gtest/gtest.h>

#include "storage/repository/access/token_repository.hpp"
#include "storage/repository/store/migrations.hpp"
#include "storage/repository/work/job_repository.hpp"
#include "storage/repository/work/plan_repository.hpp"
#include "storage/sql/driver/failure.hpp"
#include "tests/api/routes/api_fixture.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::cli::api_handler_test {
namespace {

using sql::Trouble;

routes::Request upload() {
  routes::Request request;
  request.method = "POST";
  request.path = "/uploads";
  request.now = core::UtcTime{core::Seconds{1.8e9}};
  return request;
}

/// An API on a store that fails whenever it is opened.
Api api_without_store(Trouble trouble, support::IdleJobs& jobs) {
  return make_api([trouble]() -> sql::Connection { throw sql::Failure{"the disk is gone", trouble}; }, routes::all_routes(), jobs,
                  {}, {});
}

TEST(ApiHandler, AnswersATroubledStoreAlikeBeforeAndAfterABodyIsTakenIn) {
  support::IdleJobs jobs;
  for (const auto& [trouble, status] : {std::pair{Trouble::damaged, 503},
                                        {Trouble::not_writable, 503},
                                        {Trouble::held_by_another, 503},
                                        {Trouble::disk_full, 507},
                                        {Trouble::other, 500}}) {
    const Api api = api_without_store(trouble, jobs);
    const auto refusal = api.refuse(upload());
    const auto answer = api.answer(upload());
    ASSERT_TRUE(refusal) << status;
    EXPECT_EQ(refusal->status, status);
    EXPECT_EQ(refusal->body, answer.body);
    EXPECT_EQ(refusal->headers, answer.headers);
    EXPECT_EQ(refusal->body.find("the disk is gone"), std::string::npos) << "is for the log alone";
  }
}

TEST(ApiHandler, TakesABodyInWhenTheStoreDoesItsPart) {
  support::IdleJobs jobs;
  const Api api = make_api([] { return repository::open_store_in_memory(); }, routes::all_routes(), jobs, {}, {});
  EXPECT_FALSE(api.refuse(upload()));
}

/// A server's API on its own store, which another program has also opened.
class AtOnce : public testing::Test {
 protected:
  static routes::Request get(const std::string& path) {
    routes::Request request;
    request.method = "GET";
    request.path = path;
    request.now = core::UtcTime{core::Seconds{1.8e9}};
    return request;
  }
  void store_plan(const std::string& id) {
    repository::PlanRecord plan;
    plan.id = {id};
    plan.bounds = {-53.0, 69.0, -52.9, 69.0};
    plan.document_json =
        R"({"waypoints":[{"lon":-53.0,"lat":69.0,"eta":"2026-05-28T20:26:40Z"},
            {"lon":-52.9,"lat":69.0,"eta":"2026-05-28T21:26:40Z","leg_m":4000.0}]})";
    repository::PlanRepository{other_}.insert(plan);
  }
  std::string tag_of(const std::optional<routes::Response>& response) {
    return response ? support::header_of(*response, "ETag") : "";
  }

  const std::string plan_{"/collections/plans/items/p1"};
  support::TemporaryFolder folder_;
  sql::Connection other_{repository::open_store(folder_.path())};
  support::IdleJobs jobs_;
  Api api_{make_api([this] { return repository::open_store(folder_.path()); }, routes::all_routes(), jobs_, {}, {})};
};

TEST_F(AtOnce, IsAnsweredWhatWasAnsweredBefore) {
  store_plan("p1");
  EXPECT_FALSE(api_.at_once(get(plan_))) << "it takes a thread to make it";
  const auto made = api_.answer(get(plan_));
  const auto known = api_.at_once(get(plan_));
  ASSERT_TRUE(known);
  EXPECT_EQ(known->status, 200);
  EXPECT_EQ(known->body, made.body);
  EXPECT_EQ(tag_of(known), tag_of(made));
  EXPECT_NE(tag_of(known), "") << "so that it is not reckoned again";
  EXPECT_EQ(known->route, made.route);
}

TEST_F(AtOnce, IsAnsweredNothingThatAnotherProgramHasRemoved) {
  store_plan("p1");
  static_cast<void>(api_.answer(get(plan_)));
  ASSERT_TRUE(repository::PlanRepository{other_}.remove({"p1"}));
  EXPECT_FALSE(api_.at_once(get(plan_)));
  EXPECT_EQ(api_.answer(get(plan_)).status, 404);
  store_plan("p1");
  EXPECT_EQ(api_.answer(get(plan_)).status, 200) << "that there was none is not remembered";
}

TEST_F(AtOnce, IsAnsweredNothingThatTheServerItselfHasRemoved) {
  store_plan("p1");
  static_cast<void>(api_.answer(get(plan_)));
  auto removal = get(plan_);
  removal.method = "DELETE";
  ASSERT_EQ(api_.answer(removal).status, 204);
  EXPECT_FALSE(api_.at_once(get(plan_)));
  EXPECT_EQ(api_.answer(get(plan_)).status, 404);
}

TEST_F(AtOnce, IsAnsweredTheStatusOfAJobAsItIsNow) {
  repository::JobRecord job;
  job.id = {"j1"};
  job.process = "echo";
  job.request_json = "{}";
  repository::JobRepository{other_}.submit(job);
  const auto status = [&] { return support::json_of(*api_.at_once(get("/jobs/j1"))).at("status"); };
  EXPECT_EQ(status(), "accepted");
  EXPECT_EQ(status(), "accepted");
  ASSERT_TRUE(repository::JobRepository{other_}.claim("w", job.created, core::Seconds{60.0}));
  EXPECT_EQ(status(), "running");
  ASSERT_TRUE(repository::JobRepository{other_}.dismiss({"j1"}, job.created));
  EXPECT_EQ(status(), "dismissed");
}

TEST_F(AtOnce, IsRefusedWhoHasNoTokenAsSoonAsThereIsOne) {
  store_plan("p1");
  ASSERT_EQ(api_.answer(get(plan_)).status, 200);
  ASSERT_TRUE(repository::TokenRepository{other_}.add(
      {.name = "ship", .role = repository::Role::admin, .key = "key", .digest = "digest", .created = {}}));
  EXPECT_EQ(api_.answer(get(plan_)).status, 401);
  const auto known = api_.at_once(get(plan_));
  EXPECT_TRUE(!known || known->status == 401);
}

TEST_F(AtOnce, IsAnsweredInEveryReferenceSystemOfItsOwn) {
  store_plan("p1");
  auto mercator = get(plan_);
  mercator.query = {{"crs", "http://www.opengis.net/def/crs/EPSG/0/3857"}};
  const auto plain = api_.answer(get(plan_));
  const auto projected = api_.answer(mercator);
  EXPECT_NE(plain.body, projected.body);
  EXPECT_EQ(api_.at_once(mercator)->body, projected.body);
  EXPECT_EQ(api_.at_once(get(plan_))->body, plain.body);
}

}  // namespace
}  // namespace floeplan::cli::api_handler_test
