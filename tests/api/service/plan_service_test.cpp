#include "api/service/plan_service.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "api/service/threads.hpp"
#include "engine/core/utc_text.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/features/iceberg_repository.hpp"
#include "storage/repository/store/migrations.hpp"
#include "storage/sql/statement.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::service::plan_service_test {
namespace {

using nlohmann::json;

constexpr core::UtcTime some_time{core::Seconds{1.8e9}};

TEST(PlanService, AnswersWithThePlanThatIsStored) {
  const support::TemporaryFolder store;
  sql::Connection db{repository::open_store(store.path())};
  const auto inputs = codec::parse_plan_inputs(json{{"from", {-53, 69}},
                                                    {"to", {-52.9, 69.05}},
                                                    {"depart", "2026-11-20T06:00:00Z"},
                                                    {"method", "direct"}})
                          .value();
  const json first = plan_route_document(db, inputs, Threads{2}, {}, {}, some_time).value();
  ASSERT_EQ(first.at("status"), "ok");

  // The plan now looks as if an attempt had stored it that took longer and was killed afterwards.
  sql::execute(db, "UPDATE plan SET document_json = json_set(document_json, '$.search.seconds', 7)");
  const json second = plan_route_document(db, inputs, Threads{2}, {}, {}, some_time).value();
  EXPECT_EQ(second.at("plan_id"), first.at("plan_id"));
  EXPECT_EQ(second.at("search").at("seconds"), 7);
}

codec::EvaluateInputs route_past(double middle_lat_deg) {
  return codec::parse_evaluate_inputs(json{{"route", {{-53.0, 69.0}, {-52.9, middle_lat_deg}, {-52.8, 69.0}}},
                                           {"depart", "2026-11-20T06:00:00Z"}})
      .value();
}

/// The figures of an evaluation without those of its own running time.
json figures(const json& evaluation) {
  json result = evaluation;
  if (result.contains("search")) result["search"].erase("seconds");
  return result;
}

void add_iceberg(sql::Connection& db, geo::LonLat place) {
  repository::Dataset dataset;
  dataset.id = {"icebergs-12345678"};
  dataset.kind = repository::DatasetKind::icebergs;
  dataset.name = "seen";
  dataset.bounds = {place.lon_deg, place.lat_deg, place.lon_deg, place.lat_deg};
  dataset.provenance.sha256 = "1234";
  repository::DatasetRepository{db}.insert(dataset);
  ocean::Iceberg berg;
  berg.id = "on the way";
  berg.place = place;
  berg.length = core::Metres{100.0};
  berg.observed = core::parse_iso8601("2026-11-20T05:00:00Z").value();
  repository::IcebergRepository{db}.insert(dataset.id, {berg});
}

TEST(PlanService, AnotherPlanForTheSameInputsAndDataHasAnIdOfItsOwn) {
  const support::TemporaryFolder store;
  sql::Connection db{repository::open_store(store.path())};
  add_iceberg(db, {-52.7, 69.2});
  const auto inputs =
      codec::parse_plan_inputs(
          json{{"from", {-53, 69}}, {"to", {-52.4, 69.0}}, {"depart", "2026-11-20T06:00:00Z"}})
          .value();
  const json before = plan_route_document(db, inputs, Threads{2}, {}, {}, some_time).value();
  ASSERT_EQ(before.at("status"), "ok");

  // The store now looks as if another program had read more from the same data.
  sql::execute(db, "UPDATE sighting SET lat_deg = 69.02");
  const json after = plan_route_document(db, inputs, Threads{2}, {}, {}, some_time).value();

  ASSERT_EQ(after.at("status"), "ok");
  EXPECT_NE(after.at("plan_id"), before.at("plan_id"));
  EXPECT_NE(after.at("waypoints"), before.at("waypoints"));
}

KeptWork room_for_work() {
  constexpr std::size_t most = 64 << 20;
  return {.currents = repository::CurrentGridCache{most},
          .grounds = repository::RecentlyUsed<GroundKey, planning::search::RouteGround>{most}};
}

TEST(PlanService, EvaluatesOnKeptGroundAsOnNew) {
  const support::TemporaryFolder store;
  sql::Connection db{repository::open_store(store.path())};
  KeptWork kept = room_for_work();
  for (const double lat_deg : {69.05, 69.051, 69.049, 69.05}) {
    const json evaluation = evaluate_route_document(db, route_past(lat_deg), {}, &kept).value();
    EXPECT_EQ(evaluation.at("status"), "ok");
    EXPECT_EQ(figures(evaluation), figures(evaluate_route_document(db, route_past(lat_deg), {}).value()));
  }
}

TEST(PlanService, KeepsNoGroundBeyondAChangeOfTheData) {
  const support::TemporaryFolder store;
  sql::Connection db{repository::open_store(store.path())};
  KeptWork kept = room_for_work();
  ASSERT_EQ(evaluate_route_document(db, route_past(69.05), {}, &kept).value().at("status"), "ok");

  add_iceberg(db, {-52.9, 69.05});

  const json evaluation = evaluate_route_document(db, route_past(69.05), {}, &kept).value();
  EXPECT_EQ(evaluation.at("status"), "infeasible");
  EXPECT_EQ(figures(evaluation), figures(evaluate_route_document(db, route_past(69.05), {}).value()));
}

}  // namespace
}  // namespace floeplan::service::plan_service_test
