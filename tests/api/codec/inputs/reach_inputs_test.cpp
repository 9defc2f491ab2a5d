#include "api/codec/inputs/reach_inputs.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "api/codec/documents/reach_document.hpp"
#include "engine/core/utc_text.hpp"

namespace floeplan::codec::reach_inputs_test {
namespace {

using nlohmann::json;
using planning::IsochroneRequest;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

const json from{{"from", {-53.0, 69.0}}, {"depart", "2026-11-20T06:00:00Z"}, {"hours", {6, 12.5}}};
const json to{{"to", {-53.0, 69.0}}, {"arrive_by", "2026-11-22T06:00:00Z"}, {"hours", 24}};

std::vector<std::string> faults(const json& inputs) {
  const auto parsed = parse_reach_inputs(inputs);
  std::vector<std::string> fields;
  if (!parsed) {
    for (const auto& violation : parsed.error()) fields.push_back(violation.field);
  }
  return fields;
}

json with(json inputs, const json& more) {
  inputs.update(more);
  return inputs;
}

TEST(ReachInputs, ReadAPlaceAndItsDeparture) {
  const auto parsed = parse_reach_inputs(from);

  ASSERT_TRUE(parsed.has_value());
  EXPECT_EQ(parsed->request.direction, IsochroneRequest::Direction::from);
  EXPECT_EQ(parsed->request.spans,
            (std::vector<core::Seconds>{core::Seconds{21600.0}, core::Seconds{45000.0}}));
  EXPECT_EQ(parsed->data.depart, core::parse_iso8601("2026-11-20T06:00:00Z"));
  EXPECT_EQ(parsed->data.until->time, core::parse_iso8601("2026-11-20T18:30:00Z"));
}

TEST(ReachInputs, ReadAPlaceAndTheArrivalThere) {
  const auto parsed = parse_reach_inputs(to);

  ASSERT_TRUE(parsed.has_value());
  EXPECT_EQ(parsed->request.direction, IsochroneRequest::Direction::to);
  EXPECT_EQ(parsed->data.depart, core::parse_iso8601("2026-11-21T06:00:00Z"));
  EXPECT_EQ(parsed->data.until->time, core::parse_iso8601("2026-11-22T06:00:00Z"));
}

TEST(ReachInputs, ReadWhatTheIceLetsPassAndNothingOfSurfacingsThatArePlanned) {
  const json passing{{"margin_below_ice_m", 15}, {"max_time_without_surfacing_s", 21600}};

  const auto parsed = parse_reach_inputs(with(from, {{"under_ice", passing}}));

  ASSERT_TRUE(parsed.has_value());
  EXPECT_EQ(parsed->request.under_ice.margin_below_ice.value, 15.0);
  EXPECT_EQ(parsed->request.under_ice.max_time_without_surfacing, core::Seconds{21600.0});
  EXPECT_THAT(faults(with(from, {{"under_ice", {{"escape_plan", true}, {"margin_below_ice_m", -1}}}})),
              UnorderedElementsAre("/under_ice/escape_plan", "/under_ice/margin_below_ice_m"));
}

TEST(ReachInputs, SayThatAThirdNumberIsLeftOut) {
  const auto parsed = parse_reach_inputs(with(from, {{"from", {-60.0, 70.0, -30.0}}}));

  ASSERT_TRUE(parsed.has_value());
  EXPECT_THAT(parsed->warnings, ElementsAre(HasSubstr("third number of a position")));
  EXPECT_THAT(parse_reach_inputs(from)->warnings, IsEmpty());
}

TEST(ReachInputs, ReadBackWhatTheyWrite) {
  const json below_ice = with(to, {{"under_ice", {{"max_time_without_surfacing_s", 21600}}}});
  for (const json& given : {from, to, below_ice}) {
    const json canonical = to_json(parse_reach_inputs(given).value());
    EXPECT_EQ(to_json(parse_reach_inputs(canonical).value()), canonical);
  }
}

TEST(ReachInputs, NameEveryFault) {
  EXPECT_THAT(faults(json::object()), UnorderedElementsAre("/from", "/hours"));
  EXPECT_THAT(faults(with(from, {{"to", {1, 2}}})), UnorderedElementsAre("/from"));
  EXPECT_THAT(faults(with(from, {{"arrive_by", "2026-11-22T06:00:00Z"}})),
              UnorderedElementsAre("/arrive_by"));
  EXPECT_THAT(faults({{"to", {1, 2}}, {"hours", 6}}), UnorderedElementsAre("/arrive_by"));
  EXPECT_THAT(faults(with(from, {{"hours", json::array()}})), UnorderedElementsAre("/hours"));
  EXPECT_THAT(faults(with(from, {{"hours", {6, 0, -1, 721, "x"}}, {"colour", "red"}})),
              UnorderedElementsAre("/hours/1", "/hours/2", "/hours/3", "/hours/4", "/colour"));
  EXPECT_THAT(faults(with(from, {{"from", {1, 99}}, {"spacing_m", 1}, {"sectors", 6}})),
              UnorderedElementsAre("/from", "/spacing_m", "/sectors"));
}

TEST(ReachDocument, IsGeoJsonWithClosedRings) {
  planning::Isochrones reach;
  reach.areas.push_back({.span = core::Seconds{21600.0},
                         .time = core::parse_iso8601("2026-11-20T12:00:00Z").value(),
                         .polygons = {{.outer = {{-53.0, 69.0}, {-52.0, 69.0}, {-52.0, 70.0}}, .holes = {}}},
                         .area_m2 = 2.5e9});

  const json document = reach_document(reach, parse_reach_inputs(from)->request, "round the bay");

  EXPECT_EQ(document["type"], "FeatureCollection");
  EXPECT_EQ(document["status"], "ok");
  const json& feature = document["features"][0];
  EXPECT_EQ(feature["geometry"]["type"], "MultiPolygon");
  const json& ring = feature["geometry"]["coordinates"][0][0];
  EXPECT_EQ(ring.size(), 4U);
  EXPECT_EQ(ring.front(), ring.back());
  EXPECT_EQ(feature["properties"]["hours"], 6.0);
  EXPECT_EQ(feature["properties"]["area_km2"], 2500.0);
}

}  // namespace
}  // namespace floeplan::codec::reach_inputs_test
