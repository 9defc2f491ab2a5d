#include "server/jobs/plan_service.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "storage/repository/migrations.hpp"
#include "storage/sqlite/statement.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::jobs {
namespace {

using nlohmann::json;

constexpr core::UtcTime some_time{core::Seconds{1.8e9}};

TEST(PlanService, AnswersWithThePlanThatIsStored) {
  const support::TemporaryFolder store;
  sqlite::Connection db{repository::open_store(store.path())};
  const auto inputs = codec::parse_plan_inputs(json{{"from", {-53, 69}},
                                                    {"to", {-52.9, 69.05}},
                                                    {"depart", "2026-11-20T06:00:00Z"},
                                                    {"method", "direct"}})
                          .value();
  const json first = plan_route_document(db, inputs, {}, {}, some_time).value();
  ASSERT_EQ(first.at("status"), "ok");

  // As if an attempt that was killed after it had stored its plan had found another way.
  sqlite::execute(db, "UPDATE plan SET document_json = json_set(document_json, '$.distance_m', 7)");
  const json second = plan_route_document(db, inputs, {}, {}, some_time).value();
  EXPECT_EQ(second.at("plan_id"), first.at("plan_id"));
  EXPECT_EQ(second.at("distance_m"), 7);
}

}  // namespace
}  // namespace floeplan::jobs
