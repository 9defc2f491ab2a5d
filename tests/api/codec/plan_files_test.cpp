#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "api/codec/plan_csv.hpp"
#include "api/codec/plan_document.hpp"
#include "api/codec/plan_geojson.hpp"
#include "api/codec/plan_gpx.hpp"
#include "engine/core/utc_text.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

planning::Plan two_legs() {
  planning::Plan plan;
  plan.vehicle = "slocum-g3-200";
  plan.departure = core::parse_iso8601("2026-11-20T06:00:00Z").value();
  plan.arrival = plan.departure + core::Seconds{7200.0};
  plan.waypoints.resize(2);
  plan.waypoints[0].place = {-53.25, 69.2};
  plan.waypoints[0].eta = plan.departure;
  plan.waypoints[1] = {.place = {-53.0, 69.125},
                       .eta = plan.arrival,
                       .leg_length = core::Metres{12932.04},
                       .course_deg = 130.126,
                       .speed_over_ground = core::MetresPerSecond{0.35},
                       .depth = core::Metres{231.5},
                       .iceberg_encounters = std::nullopt};
  return plan;
}

TEST(PlanDocument, KeepsWhatTheSearchSawOpenTooLate) {
  planning::Plan plan = two_legs();
  plan.search.fifo_violations = 3;
  plan.search.worst_fifo_violation = planning::LateOpening{.place = {-53.1, 69.15},
                                                           .refused = plan.departure,
                                                           .opens = plan.arrival,
                                                           .gain = core::Seconds{5400.0}};

  const json document = plan_document(plan, "p-01", "");
  const planning::Plan read = parse_plan_document(document);

  EXPECT_EQ(document.at("search").at("worst_fifo_violation").at("opens"), "2026-11-20T08:00:00Z");
  EXPECT_EQ(read.search.fifo_violations, 3);
  EXPECT_EQ(plan_document(read, "p-01", ""), document);
}

TEST(PlanDocument, IsReadBackFromAnOlderVersionThatDidNotLookForThem) {
  json document = plan_document(two_legs(), "p-01", "");
  document.at("search").erase("fifo_violations");
  document.at("search").erase("worst_fifo_violation");

  EXPECT_EQ(parse_plan_document(document).search.fifo_violations, 0);
}

TEST(PlanCsv, HasARowForEachWaypointAndEmptyCellsForTheUnknown) {
  EXPECT_EQ(plan_csv(two_legs()),
            "index,lon_deg,lat_deg,eta_utc,leg_m,course_deg,speed_over_ground_m_s,depth_m\n"
            "0,-53.2500000,69.2000000,2026-11-20T06:00:00Z,,,,\n"
            "1,-53.0000000,69.1250000,2026-11-20T08:00:00Z,12932.0,130.13,0.3500,231.5\n");
}

TEST(PlanGpx, IsARouteOfVersionOneOne) {
  EXPECT_EQ(plan_gpx(two_legs(), "p-01", "to the mouth"),
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<gpx version=\"1.1\" creator=\"floeplan\" xmlns=\"http://www.topografix.com/GPX/1/1\">\n"
            "  <rte>\n"
            "    <name>to the mouth</name>\n"
            "    <desc>Plan p-01, departure 2026-11-20T06:00:00Z, arrival 2026-11-20T08:00:00Z</desc>\n"
            "    <rtept lat=\"69.2000000\" lon=\"-53.2500000\"><time>2026-11-20T06:00:00Z</time>"
            "<name>Start</name></rtept>\n"
            "    <rtept lat=\"69.1250000\" lon=\"-53.0000000\"><time>2026-11-20T08:00:00Z</time>"
            "<name>WP1</name></rtept>\n"
            "  </rte>\n"
            "</gpx>\n");
}

TEST(PlanGpx, EscapesTheNameAndDropsWhatXmlCannotHold) {
  const std::string gpx = plan_gpx(two_legs(), "p-01", "a</name>&\"'\x01\nDiskobugt \xc3\xa6");

  EXPECT_THAT(gpx, HasSubstr("<name>a&lt;/name&gt;&amp;&quot;&apos;Diskobugt \xc3\xa6</name>"));
}

TEST(PlanGpx, IsNamedByItsIdWithoutAName) {
  EXPECT_THAT(plan_gpx(two_legs(), "p-01", ""), HasSubstr("<name>p-01</name>"));
}

TEST(PlanGpx, KeepsLongitudesBelow180) {
  planning::Plan plan = two_legs();
  plan.waypoints[1].place.lon_deg = 181.5;

  EXPECT_THAT(plan_gpx(plan, "p-01", ""), HasSubstr("lon=\"-178.5000000\""));
  EXPECT_THAT(plan_gpx(plan, "p-01", ""), Not(HasSubstr("181.5")));
}

TEST(PlanGeojson, HoldsTheRouteAndThenItsWaypoints) {
  repository::PlanRecord record;
  record.id = {"p-01"};
  record.name = "to the mouth";
  record.document_json = plan_document(two_legs(), "p-01", "to the mouth").dump();

  const json collection = plan_geojson(record);

  EXPECT_EQ(collection.at("type"), "FeatureCollection");
  const json& features = collection.at("features");
  ASSERT_EQ(features.size(), 3u);
  EXPECT_EQ(features[0].at("geometry").at("type"), "LineString");
  EXPECT_EQ(features[0].at("properties").at("name"), "to the mouth");
  EXPECT_EQ(features[2].at("geometry"), json::parse(R"({"type":"Point","coordinates":[-53.0,69.125]})"));
  EXPECT_EQ(features[2].at("properties").at("index"), 1);
  EXPECT_EQ(features[2].at("properties").at("eta"), "2026-11-20T08:00:00Z");
}

}  // namespace
}  // namespace floeplan::codec
