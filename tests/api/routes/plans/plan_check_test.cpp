#include "api/service/plan_check.hpp"

#include "api/codec/documents/plan_document.hpp"
#include "engine/messages/plan_messages.hpp"
#include "tests/api/routes/api_fixture.hpp"

namespace floeplan::routes::plan_check_test {
namespace {

using nlohmann::json;
using support::json_of;
using testing::HasSubstr;

constexpr double start_s = 1.8e9;
constexpr const char* stored = "/collections/plans/items/p1";

class PlanCheckTest : public support::ApiTest {
 protected:
  /// A plan with a danger, in a store without data, so that no check repeats the danger.
  PlanCheckTest() {
    planning::Plan plan;
    plan.vehicle = "slocum-g3-200";
    plan.departure = core::from_unix_seconds(start_s);
    plan.arrival = plan.departure + core::Seconds{30'000.0};
    plan.waypoints.resize(2);
    plan.waypoints[0].place = {-53.4, 69.0};
    plan.waypoints[0].eta = plan.departure;
    plan.waypoints[1].place = {-53.2, 69.0};
    plan.waypoints[1].eta = plan.arrival;
    plan.waypoints[1].leg_length = core::Metres{8'000.0};
    plan.messages.push_back(
        messages::plan_message<"earlier-danger">(std::string{"ice lies above the start"}));
    record_.id = {"p1"};
    record_.departure = plan.departure;
    record_.arrival = plan.arrival;
    record_.request_json = asked_.dump();
    record_.document_json = codec::plan_document(plan, "p1", "").dump();
    repository::PlanRepository{db_}.insert(record_);
  }

  json asked_{{"from", {-53.4, 69.0}},
              {"to", {-53.2, 69.0}},
              {"depart", "2027-01-15T08:00:00Z"},
              {"margin_m", 750.0}};
  repository::PlanRecord record_;
};

TEST_F(PlanCheckTest, ADangerOfThePlanIsConfirmedAlthoughTheNewestDataDoNotRepeatIt) {
  const service::PlanCheck check = service::check_plan(db_, record_);
  EXPECT_TRUE(check.dangers.empty());
  ASSERT_EQ(check.to_confirm().size(), 1U);

  const auto refused = ask("GET", std::string{stored} + "/mission.gpx");
  EXPECT_EQ(refused.status, 409) << refused.body;
  EXPECT_THAT(refused.body, HasSubstr("ice lies above the start"));
  const auto confirmed = ask("GET", std::string{stored} + "/mission.gpx?accept_dangers=true");
  EXPECT_EQ(confirmed.status, 200) << confirmed.body;
}

/// The printed page is handed out all the same: no vehicle flies it, and it shows the dangers.
TEST_F(PlanCheckTest, TheBriefOfADangerousPlanIsHandedOutAndTellsItsDangersAndTheSafePlaces) {
  const auto brief = ask("GET", std::string{stored} + "/mission.html?safe=-53.2,69.2");
  EXPECT_EQ(brief.status, 200) << brief.body;
  EXPECT_THAT(brief.body, HasSubstr("ce lies above the start"));
  EXPECT_THAT(brief.body, HasSubstr("Safe places: R1 69°12.000′N 053°12.000′W."));
  EXPECT_EQ(ask("GET", std::string{stored} + "/mission.html?safe=here").status, 400);
  EXPECT_EQ(ask("GET", std::string{stored} + "/mission.gpx?safe=-53.2,69.2").status, 400) << "not of a page";
}

TEST_F(PlanCheckTest, TheCheckTellsADangerOfThePlanOnceAndNotAsOneOfTheNewestData) {
  const json document = json_of(ask("GET", std::string{stored} + "/check"));

  EXPECT_EQ(document["dangers"], json::array());
  std::size_t told = 0;
  for (const json& message : document["messages"])
    if (message["code"] == "earlier-danger") ++told;
  EXPECT_EQ(told, 1U) << document.dump(1);
}

TEST_F(PlanCheckTest, WhoeverJudgesAPlanElsewhereLearnsWhatItWasAskedFor) {
  EXPECT_EQ(json_of(ask("GET", std::string{stored} + "/inputs")), asked_);
  EXPECT_EQ(ask("GET", "/collections/plans/items/p2/inputs").status, 404);
}

}  // namespace
}  // namespace floeplan::routes::plan_check_test
