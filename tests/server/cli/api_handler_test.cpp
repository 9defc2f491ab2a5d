#include "server/cli/api_handler.hpp"

#include <gtest/gtest.h>

#include "storage/repository/migrations.hpp"
#include "storage/sqlite/failure.hpp"
#include "tests/api/routes/api_fixture.hpp"

namespace floeplan::cli {
namespace {

using sqlite::Trouble;

routes::Request upload() {
  routes::Request request;
  request.method = "POST";
  request.path = "/uploads";
  request.now = core::UtcTime{core::Seconds{1.8e9}};
  return request;
}

/// An API on a store that fails whenever it is opened.
Api api_without_store(Trouble trouble, support::IdleJobs& jobs) {
  return make_api([trouble]() -> sqlite::Connection { throw sqlite::Failure{"the disk is gone", trouble}; },
                  jobs, {}, {});
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
  const Api api = make_api([] { return repository::open_store_in_memory(); }, jobs, {}, {});
  EXPECT_FALSE(api.refuse(upload()));
}

}  // namespace
}  // namespace floeplan::cli
