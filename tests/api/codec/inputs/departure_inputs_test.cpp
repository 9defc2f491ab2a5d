#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "api/codec/documents/departure_document.hpp"
#include "api/codec/inputs/plan_input_parts.hpp"
#include "api/codec/inputs/plan_inputs.hpp"
#include "engine/core/utc_text.hpp"
#include "engine/messages/refusal_messages.hpp"

namespace floeplan::codec::departure_inputs_test {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::UnorderedElementsAre;

const json places{{"from", {-53.0, 69.0}}, {"to", {-52.5, 69.3}}};

json inputs(json more) {
  more.update(places);
  return more;
}

std::vector<std::string> faults(const json& more) {
  const auto parsed = parse_plan_inputs(inputs(more));
  std::vector<std::string> fields;
  if (!parsed) {
    for (const auto& violation : parsed.error()) fields.push_back(violation.field);
  }
  return fields;
}

core::UtcTime utc(const char* text) { return core::parse_iso8601(text).value(); }

TEST(DepartureInputs, ReadAWindow) {
  const auto parsed = parse_plan_inputs(inputs({{"depart", "2026-11-20T06:00:00Z"},
                                                {"depart_until", "2026-11-21T06:00:00Z"},
                                                {"depart_step", "PT2H"}}));

  ASSERT_TRUE(parsed.has_value());
  EXPECT_EQ(parsed->request.departures.departures(parsed->request.depart).size(), 13U);
  ASSERT_TRUE(parsed->data.until.has_value());
  EXPECT_EQ(parsed->data.until->time, utc("2026-11-21T06:00:00Z"));
  EXPECT_FALSE(parsed->data.may_begin_later);
}

TEST(DepartureInputs, StepByTheHourUnlessToldOtherwise) {
  const auto parsed = parse_plan_inputs(
      inputs({{"depart", "2026-11-20T06:00:00Z"}, {"depart_until", "2026-11-20T09:00:00Z"}}));

  EXPECT_EQ(parsed->request.departures.step, core::Seconds{3600.0});
}

TEST(DepartureInputs, TakeTheLongestMissionBeforeAWantedArrivalAsTheEarliestDeparture) {
  const auto parsed = parse_plan_inputs(inputs({{"arrive_by", "2026-12-20T06:00:00Z"}}));

  ASSERT_TRUE(parsed.has_value());
  EXPECT_EQ(parsed->request.depart, utc("2026-11-20T06:00:00Z"));
  EXPECT_TRUE(parsed->data.may_begin_later);
}

TEST(DepartureInputs, ReadBackWhatTheyWrite) {
  for (const json& given :
       {json{{"depart", "2026-11-20T06:00:00Z"}},
        json{{"depart", "2026-11-20T06:00:00Z"},
             {"depart_until", "2026-11-21T06:00:00Z"},
             {"depart_step", "PT90M"}},
        json{{"arrive_by", "2026-12-20T06:00:00Z"}},
        json{{"depart", "2026-12-01T06:00:00Z"}, {"arrive_by", "2026-12-20T06:00:00Z"}}}) {
    const json canonical = to_json(parse_plan_inputs(inputs(given)).value());

    EXPECT_EQ(to_json(parse_plan_inputs(canonical).value()), canonical) << canonical;
  }
}

TEST(DepartureInputs, NeedADepartureOrAnArrival) { EXPECT_THAT(faults({}), ElementsAre("/depart")); }

TEST(DepartureInputs, RefuseWhatCannotBeAWindow) {
  const json depart{{"depart", "2026-11-20T06:00:00Z"}};
  const auto with = [&](json more) {
    more.update(depart);
    return faults(more);
  };
  EXPECT_THAT(with({{"depart_until", "2026-11-19T06:00:00Z"}}), ElementsAre("/depart_until"));
  EXPECT_THAT(with({{"depart_until", "2026-11-21T06:00:00Z"}, {"depart_step", "PT0S"}}),
              ElementsAre("/depart_step"));
  EXPECT_THAT(with({{"depart_until", "2026-11-21T06:00:00Z"}, {"depart_step", "-PT1H"}}),
              ElementsAre("/depart_step"));
  EXPECT_THAT(with({{"depart_until", "2026-11-21T06:00:00Z"}, {"depart_step", 3600}}),
              ElementsAre("/depart_step"));
  EXPECT_THAT(with({{"depart_until", "2027-11-21T06:00:00Z"}}), ElementsAre("/depart_step"));
  EXPECT_THAT(with({{"depart_step", "PT1H"}}), ElementsAre("/depart_step"));
  EXPECT_THAT(with({{"arrive_by", "2026-11-20T05:00:00Z"}}), ElementsAre("/arrive_by"));
  EXPECT_THAT(with({{"arrive_by", "2026-11-24T05:00:00Z"}, {"depart_until", "2026-11-21T06:00:00Z"}}),
              ElementsAre("/arrive_by"));
  EXPECT_THAT(
      with({{"depart_until", "2026-11-21T06:00:00Z"}, {"via", {{-52.8, 69.1}}}, {"via_order", "best"}}),
      ElementsAre("/via_order"));
  EXPECT_THAT(with({{"arrive_by", "tomorrow"}, {"depart_until", 7}}),
              UnorderedElementsAre("/arrive_by", "/depart_until"));
}

TEST(DeparturesJson, HasTheTimeOrTheReasonOfEachDeparture) {
  std::vector<planning::DepartureOutcome> outcomes(2);
  outcomes[0].departure = utc("2026-11-20T06:00:00Z");
  outcomes[0].travel_time = core::Seconds{7200.0};
  outcomes[0].energy = core::Joules{3.5e5};
  outcomes[1].departure = utc("2026-11-20T07:00:00Z");
  outcomes[1].closed = planning::Infeasible{.reason = planning::Reason::outside_data,
                                            .at = {},
                                            .when = {},
                                            .why = messages::refusal<"way-outside-data">()};

  const json curve = departures_json(outcomes);

  EXPECT_EQ(curve[0]["status"], "ok");
  EXPECT_EQ(curve[0]["travel_time_s"], 7200.0);
  EXPECT_EQ(curve[0]["arrival"], "2026-11-20T08:00:00Z");
  EXPECT_EQ(curve[0]["energy_j"], 3.5e5);
  EXPECT_TRUE(curve[0]["reason"].is_null());
  EXPECT_EQ(curve[1]["status"], "infeasible");
  EXPECT_EQ(curve[1]["reason"], "outside_data");
  EXPECT_TRUE(curve[1]["travel_time_s"].is_null());
  EXPECT_TRUE(curve[1]["energy_j"].is_null());
}

}  // namespace
}  // namespace floeplan::codec::departure_inputs_test
