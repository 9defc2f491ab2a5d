#include "api/codec/exports/plan_files.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "api/codec/documents/alternative_document.hpp"
#include "api/codec/documents/plan_document.hpp"
#include "api/codec/exports/plan_brief.hpp"
#include "api/codec/route_files/route_file.hpp"
#include "engine/core/utc_text.hpp"
#include "engine/messages/data_messages.hpp"
#include "engine/messages/plan_messages.hpp"
#include "engine/mission/writing/nmea_route.hpp"
#include "tests/support/property.hpp"

namespace floeplan::codec::plan_files_test {
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

TEST(PlanDocument, KeepsItsMessagesAndTellsTheGravestFirst) {
  planning::Plan plan = two_legs();
  plan.messages = {messages::plan_message<"search-cut-short">(),
                   messages::plan_message<"surfacings-near-ice">(2, 4, plan.departure, 1.25, 2.5),
                   messages::plan_message<"goal-under-ice">().at({-53.0, 69.125})};

  const json document = plan_document(plan, "p-01", "");

  const json& danger = document.at("messages").at(0);
  EXPECT_EQ(danger.at("code"), "goal-under-ice");
  EXPECT_EQ(danger.at("rank"), "danger");
  EXPECT_EQ(danger.at("place"), (json{{"lon", -53.0}, {"lat", 69.125}}));
  const json& caution = document.at("messages").at(1);
  EXPECT_EQ(caution.at("values"), (json{{"near", 2},
                                        {"surfacings", 4},
                                        {"first", "2026-11-20T06:00:00Z"},
                                        {"ice_km", 1.25},
                                        {"error_km", 2.5}}));
  EXPECT_TRUE(caution.at("place").is_null());
  EXPECT_EQ(document.at("messages").at(2).at("rank"), "note");
  for (std::size_t i = 1; i < 3; ++i)
    EXPECT_EQ(document.at("warnings").at(i), document.at("messages").at(i).at("text"));
  EXPECT_EQ(document.at("dangers"), json::array({document.at("warnings").at(0)}));
  EXPECT_EQ(plan_document(parse_plan_document(document), "p-01", ""), document);
}

TEST(PlanDocument, OfAnEarlierVersionHasItsWarningsByTheirRank) {
  json document = plan_document(two_legs(), "p-01", "");
  document.erase("messages");
  document["warnings"] = {"Danger: the goal lies under ice", "ice is held"};

  const planning::Plan plan = parse_plan_document(document);

  ASSERT_EQ(plan.messages.size(), 2U);
  EXPECT_EQ(plan.messages[0].rank, messages::Rank::danger);
  EXPECT_EQ(plan.messages[0].text, "the goal lies under ice");
  EXPECT_EQ(plan.messages[1].rank, messages::Rank::caution);
  EXPECT_EQ(plan_document(plan, "p-01", "").at("warnings"), document.at("warnings"));
}

TEST(PlanIdentity, IsThatOfTheInputsAndThePlanNotOfItsWords) {
  const json inputs{{"from", {-53.25, 69.2}}};
  planning::Plan plan = two_legs();
  plan.messages = {messages::plan_message<"goal-under-ice">()};
  const std::string id = plan_identity(inputs, plan);

  planning::Plan in_other_words = plan;
  in_other_words.messages[0].text = "no open water at the goal";
  in_other_words.optimality_gap_reason = "nobody asked";
  in_other_words.search.duration = core::Seconds{12.0};
  EXPECT_EQ(plan_identity(inputs, in_other_words), id);

  planning::Plan with_another_danger = plan;
  with_another_danger.messages.push_back(messages::plan_message<"start-under-ice">());
  planning::Plan later = plan;
  later.arrival += core::Seconds{1.0};
  planning::Plan on_other_data = plan;
  on_other_data.datasets = {{.id = "ice-1", .kind = "ice", .name = "chart", .sha256 = "abc"}};
  for (const planning::Plan& other : {with_another_danger, later, on_other_data})
    EXPECT_NE(plan_identity(inputs, other), id);
  EXPECT_NE(plan_identity({{"from", {-53.0, 69.2}}}, plan), id);
}

/// The values of a message decide: a berg that was not named before makes another plan, although the message
/// is of the same kind. Of a note only the kind decides.
TEST(PlanIdentity, CountsTheValuesOfDangersAndCautions) {
  const auto id_with = [](messages::Message message) {
    planning::Plan plan = two_legs();
    plan.messages = {std::move(message)};
    return plan_identity(json::object(), plan);
  };
  const auto on_land = [](const char* names) { return messages::data_message<"icebergs-on-land">(1, names); };
  EXPECT_NE(id_with(on_land("B-17")), id_with(on_land("C-9")));
  const auto gain = [](double minutes) {
    return messages::plan_message<"search-cut-short-near-the-best">(minutes, 1.0);
  };
  EXPECT_EQ(id_with(gain(3.0)), id_with(gain(4.0)));
}

TEST(PlanDocument, KeepsTheDrivesOfTheLegsAndWhatTheyDraw) {
  planning::Plan plan = two_legs();
  plan.waypoints.push_back(plan.waypoints[1]);
  plan.waypoints[0].energy = core::Joules{0.0};
  plan.waypoints[1].drive = vehicle::Drive::thruster;
  plan.waypoints[1].speed_through_water = core::MetresPerSecond{0.5144444444444445};
  plan.waypoints[1].energy = core::Joules{31299.20354153268};
  plan.waypoints[2].drive = vehicle::Drive::buoyancy;
  plan.waypoints[2].speed_through_water = core::MetresPerSecond{0.35};
  plan.waypoints[2].energy = core::Joules{40000.5};

  json document = plan_document(plan, "p-01", "");
  const planning::Plan read = parse_plan_document(document);

  for (std::size_t i = 0; i < plan.waypoints.size(); ++i) {
    EXPECT_EQ(read.waypoints[i].drive, plan.waypoints[i].drive);
    EXPECT_EQ(read.waypoints[i].speed_through_water, plan.waypoints[i].speed_through_water);
    EXPECT_EQ(read.waypoints[i].energy, plan.waypoints[i].energy);
  }
  EXPECT_EQ(plan_document(read, "p-01", ""), document);

  for (json& waypoint : document.at("waypoints"))
    for (const char* newer : {"propulsion", "speed_through_water_m_s", "energy_j"}) waypoint.erase(newer);
  EXPECT_FALSE(parse_plan_document(document).waypoints[1].drive.has_value()) << "of an older version";
  document.at("waypoints")[1]["propulsion"] = "sail";
  EXPECT_THROW(parse_plan_document(document), std::runtime_error);
}

TEST(PlanDocument, TellsWhetherTheSearchWasCutShort) {
  planning::Plan plan = two_legs();
  EXPECT_EQ(plan_document(plan, "p-01", "").at("search").at("cut_short"), false);
  EXPECT_TRUE(plan_document(plan, "p-01", "").at("search").at("possible_gain_s").is_null());
  plan.search.cut_short = true;
  plan.search.possible_gain = core::Seconds{90.0};

  const json document = plan_document(plan, "p-01", "");

  EXPECT_EQ(document.at("search").at("cut_short"), true);
  EXPECT_EQ(document.at("search").at("possible_gain_s"), 90.0);
  EXPECT_TRUE(parse_plan_document(document).search.cut_short);
  EXPECT_EQ(parse_plan_document(document).search.possible_gain, core::Seconds{90.0});
}

TEST(PlanDocument, KeepsWaitsAndWhatIsPassedUnderAndTraded) {
  planning::Plan plan = two_legs();
  plan.waypoints[0].wait = core::Seconds{5400.0};
  plan.iceberg_encounters = 0.02;
  plan.passed_under = {{.iceberg = "B-17",
                        .keel = {{40.0}, true, {50.0}, {70.0}},
                        .from = plan.departure + core::Seconds{600.0},
                        .until = plan.arrival}};
  plan.encounter_trade = planning::EncounterTrade{
      .weight = core::Seconds{3600.0}, .time_before = core::Seconds{7000.0}, .encounters_before = 0.1};

  const json document = plan_document(plan, "p-01", "");
  const planning::Plan read = parse_plan_document(document);

  EXPECT_EQ(document.at("waypoints").at(0).at("wait_s"), 5400.0);
  EXPECT_EQ(document.at("passed_under").at(0).at("clearance_m"), 20.0);
  EXPECT_EQ(document.at("passed_under").at(0).at("draft_from"), "sighting");
  EXPECT_EQ(document.at("encounter_trade").at("after").at("iceberg_encounters"), 0.02);
  EXPECT_EQ(plan_document(read, "p-01", ""), document);
}

TEST(PlanDocument, IsReadBackFromAnOlderVersionWithoutWaitsAndPassages) {
  json document = plan_document(two_legs(), "p-01", "");
  document.erase("passed_under");
  document.erase("encounter_trade");
  for (json& waypoint : document.at("waypoints")) waypoint.erase("wait_s");

  const planning::Plan read = parse_plan_document(document);

  EXPECT_EQ(read.waypoints[0].wait.count(), 0.0);
  EXPECT_TRUE(read.passed_under.empty());
  EXPECT_FALSE(read.encounter_trade);
}

TEST(PlanDocument, IsReadBackFromAnOlderVersionThatDidNotLookForThem) {
  json document = plan_document(two_legs(), "p-01", "");
  document.at("search")["fifo_violations"] = 3;
  document.at("search")["worst_fifo_violation"] = nullptr;
  document.at("search").erase("cut_short");
  document.at("search").erase("possible_gain_s");

  EXPECT_FALSE(parse_plan_document(document).search.cut_short);
}

TEST(PlanCsv, HasARowForEachWaypointAndEmptyCellsForTheUnknown) {
  EXPECT_EQ(plan_csv(two_legs()),
            "index,lon_deg,lat_deg,eta_utc,leg_m,course_deg,speed_over_ground_m_s,depth_m,wait_s\n"
            "0,-53.2500000,69.2000000,2026-11-20T06:00:00Z,,,,,0\n"
            "1,-53.0000000,69.1250000,2026-11-20T08:00:00Z,12932.0,130.13,0.3500,231.5,0\n");
}

TEST(PlanGpx, IsARouteOfVersionOneOne) {
  EXPECT_EQ(plan_gpx(two_legs(), "p-01", "to the mouth"),
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<gpx version=\"1.1\" creator=\"floeplan\" xmlns=\"http://www.topografix.com/GPX/1/1\">\n"
            "  <rte>\n"
            "    <name>to the mouth</name>\n"
            "    <desc>Plan p-01, departure 2026-11-20T06:00:00Z, arrival 2026-11-20T08:00:00Z</desc>\n"
            "    <rtept lat=\"69.2000000\" lon=\"-53.2500000\"><time>2026-11-20T06:00:00Z</time>"
            "<name>S</name></rtept>\n"
            "    <rtept lat=\"69.1250000\" lon=\"-53.0000000\"><time>2026-11-20T08:00:00Z</time>"
            "<name>1</name></rtept>\n"
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

TEST(PlanKml, IsALineAndAPlacemarkForEachWaypoint) {
  const std::string kml = plan_kml(two_legs(), "p-01", "to <the> mouth");

  EXPECT_THAT(kml, HasSubstr("<name>to &lt;the&gt; mouth</name>"));
  EXPECT_THAT(kml, HasSubstr("<coordinates>-53.2500000,69.2000000 -53.0000000,69.1250000</coordinates>"));
  EXPECT_THAT(kml, HasSubstr("<name>1</name><TimeStamp><when>2026-11-20T08:00:00Z</when></TimeStamp>"));
}

TEST(PlanKml, RunsOnPastTheAntimeridian) {
  planning::Plan plan = two_legs();
  plan.waypoints[0].place.lon_deg = 179.5;
  plan.waypoints[1].place.lon_deg = -179.5;

  EXPECT_THAT(plan_kml(plan, "p-01", ""), HasSubstr("<coordinates>179.5000000,69.2000000 180.5000000,"));
}

TEST(PlanFiles, ReadBackToTheSameRoute) {
  const planning::Plan plan = two_legs();
  for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
           {"a.gpx", plan_gpx(plan, "p-01", "")},
           {"a.kml", plan_kml(plan, "p-01", "")},
           {"a.csv", plan_csv(plan)},
           {"a.nmea", mission::write_nmea_route(plan, "p-01").text}}) {
    const auto read = read_route_file(name, text);
    ASSERT_TRUE(read.has_value()) << name;
    ASSERT_EQ(read->places.size(), 2U) << name;
    EXPECT_NEAR(read->places[1].lon_deg, -53.0, 1e-7) << name;
    EXPECT_NEAR(read->places[1].lat_deg, 69.125, 1e-7) << name;
  }
}

TEST(PlanBrief, IsOnePageThatNeedsNothingElse) {
  planning::Plan plan = two_legs();
  plan.datasets = {{.id = "icebergs-1", .kind = "icebergs", .name = "<bergs>", .sha256 = "abc"}};
  plan.messages = {messages::plan_message<"remark">("mind the <ice>")};
  const geo::Polygon island{.outer = {{-53.2, 69.15}, {-53.1, 69.15}, {-53.1, 69.17}}, .holes = {}};
  ocean::Iceberg berg;
  berg.place = {-53.1, 69.18};
  const MapPicture picture = draw_map(plan, {island}, {berg}, 720.0, 420.0);

  const std::string html = plan_brief_html(
      plan, {picture}, {"p-01", "<script>", plan.departure, {messages::plan_message<"remark">("changed")}});

  EXPECT_EQ(picture.land.size(), 1U);
  EXPECT_EQ(picture.icebergs.size(), 1U);
  EXPECT_THAT(html, HasSubstr("<td>69°12.000′N</td><td>053°15.000′W</td><td>2026-11-20T06:00:00Z</td>"));
  EXPECT_THAT(html, HasSubstr("Mind the &lt;ice&gt;."));
  EXPECT_THAT(html, HasSubstr("&lt;bergs&gt; (icebergs-1), sha256 abc"));
  EXPECT_THAT(html, HasSubstr("<li>Changed.</li>"));
  for (const char* foreign : {"<script", "src=", "href=", "@import", "url("})
    EXPECT_THAT(html, Not(HasSubstr(foreign)));
}

TEST(PlanBrief, TellsWhereThePlanIsBelowIceAndMaySurface) {
  planning::Plan plan = two_legs();
  plan.surfacing = planning::SurfacingPlan{
      .longest_without = core::Seconds{5400.0},
      .waypoints = {{.may_surface = true, .leg_upper_turn = {}},
                    {.may_surface = false, .leg_upper_turn = core::Metres{16.2}}},
      .reckoned = {},
      .surfacings = {{.place = {-53.1, 69.15}, .time = plan.departure}},
      .escapes = {{.way = {plan.waypoints[0].place}, .course_deg = {}},
                  {.way = {plan.waypoints[1].place, {-53.0, 69.2}}, .course_deg = 0.0}},
      .ice_beside = {},
      .below_ice = std::vector<planning::StretchBelowIce>{{.waypoint = 1,
                                                           .from = {-53.15, 69.12},
                                                           .to = {-53.05, 69.16},
                                                           .enters = plan.departure,
                                                           .time = core::Seconds{4500.0},
                                                           .length = {5900.0}}}};

  const MapPicture picture = draw_map(plan, {}, {}, 720.0, 420.0);
  const std::string html = plan_brief_html(plan, {picture}, {"p-01", "", plan.departure, {}});

  EXPECT_EQ(picture.below_ice.size(), 1U);
  EXPECT_EQ(picture.surfacings.size(), 1U);
  EXPECT_EQ(picture.closed.size(), 1U);
  EXPECT_EQ(picture.escapes.size(), 1U) << "where it may surface at once there is none";
  EXPECT_THAT(
      html,
      HasSubstr(
          "Below ice or icebergs: 5.9 km, 1 h 15 min. Longest time without a place to surface: 1 h 30 min."));
  EXPECT_THAT(html, HasSubstr("<td>yes</td><td>-</td></tr>"));
  EXPECT_THAT(html, HasSubstr("<td>no</td><td>17</td></tr>"));
  EXPECT_THAT(
      html, HasSubstr("Dashed: below ice or icebergs. Squares: the vehicle must not surface. Dotted: escape "
                      "routes to where it may. "
                      "Discs with an arrow: planned surfacings."));

  plan.surfacing.reset();
  const std::string unknown =
      plan_brief_html(plan, {draw_map(plan, {}, {}, 720.0, 420.0)}, {"p-01", "", plan.departure, {}});
  EXPECT_THAT(unknown, HasSubstr("<td>-</td><td>-</td></tr>"));
  EXPECT_THAT(unknown, Not(HasSubstr("below ice")));
}

TEST(PlanBrief, DrawsTheSeaIceOfTheDepartureForAPrinterWithoutColour) {
  const planning::Plan plan = two_legs();  // from 53.25 W to 53 W
  const SeaIce west_of_the_middle{[](geo::LonLat place) -> std::optional<double> {
                                    if (place.lat_deg > 69.18) return std::nullopt;
                                    return place.lon_deg < -53.125 ? 0.95 : 0.0;
                                  },
                                  0.1};

  const MapPicture picture = draw_map(plan, {}, {}, 720.0, 420.0, west_of_the_middle);

  ASSERT_TRUE(picture.ice.has_value());
  ASSERT_FALSE(picture.ice->marks.hatch.empty());
  for (const auto& line : picture.ice->marks.hatch)
    for (const auto& point : line) EXPECT_LT(point.x, 366.0) << "open water is blank";
  EXPECT_FALSE(picture.ice->marks.unknown.empty());
  for (const auto& lines : {picture.ice->marks.edge, picture.ice->marks.limit}) {
    ASSERT_EQ(lines.size(), 1U) << "interrupted where the ice is unknown";
    for (const auto& point : lines[0]) EXPECT_NEAR(point.x, 360.0, 6.0);
  }
  const std::string html = plan_brief_html(plan, {picture}, {"p-01", "", plan.departure, {}});
  EXPECT_THAT(html, HasSubstr("surfacing limit: no surfacing in more than 10 %"));
  EXPECT_THAT(html, HasSubstr("Sea ice as of the departure, 2026-11-20T06:00:00Z; it moves"));
}

TEST(PlanBrief, ShowsNoIceWhereThePlanKnowsNone) {
  const planning::Plan plan = two_legs();
  const std::string html =
      plan_brief_html(plan, {draw_map(plan, {}, {}, 720.0, 420.0)}, {"p-01", "", plan.departure, {}});
  EXPECT_THAT(html, Not(HasSubstr("class=\"hatch\"")));
  EXPECT_THAT(html, Not(HasSubstr("Sea ice as of")));
}

TEST(PlanBrief, TellsTheChanceToArriveInTime) {
  planning::Plan plan = two_legs();
  plan.uncertainty = planning::UncertaintyReport{
      .spread = planning::ArrivalSpread{{core::Seconds{3600.0}, core::Seconds{7200.0}, std::nullopt,
                                         core::Seconds{5400.0}}},
      .arrive_before = plan.departure + core::Seconds{6000.0},
      .chance = 0.5};
  // A stored plan is read back.
  const planning::Plan stored = parse_plan_document(plan_document(plan, "p-01", ""));

  EXPECT_THAT(brief_facts(stored, {.plan_id = "p-01", .name = "", .messages = {}}),
              testing::Contains(
                  "Uncertain currents: 3 of 4 members arrive, in the mean after 1 h 30 min; 90 % of all "
                  "within not known. Chance to arrive before 2026-11-20T07:40:00Z: 50 %."));
}

TEST(PlanBrief, TellsWhatTheWeightOnEncountersChanged) {
  planning::Plan plan = two_legs();
  plan.iceberg_encounters = 0.1;
  plan.encounter_trade = {
      .weight = core::Seconds{18'000.0}, .time_before = core::Seconds{6600.0}, .encounters_before = 0.25};

  EXPECT_THAT(brief_facts(plan, {.plan_id = "p-01", .name = "", .messages = {}}),
              testing::Contains("Expected encounters with icebergs: 0.10. An encounter counts as 5 h 00 min; "
                                "without this weight: 1 h 50 min and 0.25 encounters."));
}

TEST(PlanBrief, NamesTheNearestIcebergTheEncountersAndTheSafePlaces) {
  planning::Plan plan = two_legs();
  plan.clearances.iceberg = core::Metres{812.0};
  plan.clearances.nearest_iceberg = "B-17";
  plan.iceberg_encounters = 0.034;
  BriefNotes notes{.plan_id = "p-01", .name = "", .messages = {}};
  notes.safe_places = {{-53.2, 69.2}, {-53.0, 69.0}};

  const auto facts = brief_facts(plan, notes);

  EXPECT_THAT(facts, testing::Contains(HasSubstr("Least distance to icebergs 812 m (B-17), to land")));
  EXPECT_THAT(facts, testing::Contains("Expected encounters with icebergs: 0.03."));
  EXPECT_THAT(facts,
              testing::Contains("Safe places: R1 69°12.000′N 053°12.000′W; R2 69°00.000′N 053°00.000′W."));
  EXPECT_THAT(plan_document(plan, "p-01", "").at("clearances").at("iceberg_id"), "B-17");
}

TEST(PlanBrief, GivesLongDistancesInKilometres) {
  planning::Plan plan = two_legs();
  plan.clearances = {.iceberg = core::Metres{141'718.0}, .land = core::Metres{3'240.0}, .bottom = {}};

  const auto facts = brief_facts(plan, {.plan_id = "p-01", .name = "", .messages = {}});

  EXPECT_THAT(facts, testing::Contains(
                         "Least distance to icebergs 142 km, to land 3.2 km, to the sea bed not known."));
}

TEST(PlanBrief, GroupsItsMessagesByRankWithTheirPlaces) {
  planning::Plan plan = two_legs();
  plan.messages = {messages::plan_message<"search-cut-short">(),
                   messages::plan_message<"goal-under-ice">().at({-53.0, 69.125})};
  const auto told = brief_messages(plan, {"p-01", "", plan.departure, plan.messages});

  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(told[0].title, "Dangers");
  ASSERT_EQ(told[0].sentences.size(), 1U) << "each once";
  EXPECT_THAT(told[0].sentences[0], testing::EndsWith(" (69°07.500′N 053°00.000′W)."));
  EXPECT_EQ(told[1].sentences.size(), 1U);
}

TEST(PlanBrief, NamesSettingsByTheirLabelsNotByFlags) {
  planning::Plan plan = two_legs();
  plan.messages = {messages::plan_message<"leads-may-be-missed">(12.0, 19.5)};
  const auto told = brief_messages(plan, {"p-01", "", plan.departure, {}});

  ASSERT_EQ(told.size(), 1U);
  EXPECT_THAT(told[0].sentences.at(0), HasSubstr("(\u201cMax. time without surfacing\u201d)"));
  EXPECT_THAT(told[0].sentences.at(0), HasSubstr("(\u201cVia points\u201d)"));
  EXPECT_THAT(told[0].sentences.at(0), Not(HasSubstr("--")));
}

TEST(PlanBrief, WritesPositionsInSentencesAsInTheTable) {
  planning::Plan plan = two_legs();
  plan.messages = {messages::plan_message<"passes-close-to-land">(-51.35, 69.1707, 74.0, 156.0)};
  const auto told = brief_messages(plan, {"p-01", "", plan.departure, {}});

  ASSERT_EQ(told.size(), 1U);
  EXPECT_THAT(told[0].sentences.at(0), testing::StartsWith("At 69°10.242′N 051°21.000′W the route passes"));
}

TEST(IceSection, DrawsDraftKeelsAndTurnsTrueToScale) {
  planning::Plan plan = two_legs();
  plan.surfacing =
      planning::SurfacingPlan{.waypoints = {{}, {.may_surface = false, .leg_upper_turn = core::Metres{16.2}}},
                              .reckoned = {},
                              .surfacings = {},
                              .escapes = {}};
  const core::Metres length = *plan.waypoints[1].leg_length;
  const std::vector<IceAbove> ice{{core::Metres{0.0}, core::Metres{0.0}},
                                  {core::Metres{0.25 * length.value}, core::Metres{1.0}},
                                  {core::Metres{0.5 * length.value}, std::nullopt},
                                  {length, core::Metres{2.0}}};

  const auto section = draw_ice_section(plan, ice, 720.0, 150.0);

  ASSERT_TRUE(section.has_value());
  ASSERT_EQ(section->draft.size(), 2U) << "broken where the ice is not known";
  const double surface = section->draft[0][0].y;
  const double metre = (section->turn[0].y - surface) / 16.2;
  EXPECT_GT(metre, 0.0);
  EXPECT_NEAR(section->draft[0][1].y - surface, 0.9 * metre, 1e-9);
  EXPECT_NEAR(section->keel[0][1].y - surface, 8.0 * metre, 1e-9);
  EXPECT_NEAR(section->keel[1][0].y - surface, 16.0 * metre, 1e-9);
  EXPECT_NEAR(section->draft[1][0].x, section->turn[1].x, 1e-9);
  EXPECT_THAT(plan_brief_html(plan, {draw_map(plan, {}, {}, 720.0, 420.0), section},
                              {"p-01", "", plan.departure, {}}),
              HasSubstr("deepest keels (dotted)"));
}

TEST(IceSection, IsLeftOutWithoutIce) {
  planning::Plan plan = two_legs();
  EXPECT_FALSE(draw_ice_section(plan, {{core::Metres{0.0}, core::Metres{1.0}}}, 720.0, 150.0))
      << "not planned with ice";
  plan.surfacing = planning::SurfacingPlan{.waypoints = {{}, {.leg_upper_turn = core::Metres{0.0}}},
                                           .reckoned = {},
                                           .surfacings = {},
                                           .escapes = {}};
  EXPECT_FALSE(draw_ice_section(plan, {{core::Metres{0.0}, core::Metres{0.0}}}, 720.0, 150.0));
}

TEST(PlanImc, KeepsStationWhereThePlanHolds) {
  planning::Plan plan = two_legs();
  plan.waypoints.push_back(plan.waypoints[1]);
  plan.waypoints[2].place.lon_deg += 0.25;
  plan.waypoints[2].eta += core::Seconds{7200.0};
  plan.waypoints[1].wait = core::Seconds{100'000.0};
  plan.waypoints[2].eta += plan.waypoints[1].wait;

  const std::string text = plan_imc(plan, {}, {}, {400.0}, "p-01", "", plan.departure);

  const json maneuvers = json::parse(text).at("maneuvers");
  double held_s = 0.0;
  for (const json& maneuver : maneuvers) {
    const json& data = maneuver.at("data");
    if (data.at("abbrev") != "StationKeeping") continue;
    held_s += data.at("duration").get<double>();
    EXPECT_LE(data.at("duration"), 65'535);
    EXPECT_EQ(data.at("radius"), 400.0);
    EXPECT_NEAR(data.at("lat").get<double>(), core::degrees_to_radians(plan.waypoints[1].place.lat_deg),
                1e-12);
  }
  EXPECT_EQ(held_s, 100'000.0);
  EXPECT_EQ(json::parse(text).at("transitions").size() + 1, maneuvers.size());
  const auto read = read_route_file("a.json", text);
  ASSERT_TRUE(read.has_value());
  plan.waypoints[1].wait = core::Seconds{0.0};
  plan.waypoints[2].eta -= core::Seconds{100'000.0};
  const auto without = read_route_file("a.json", plan_imc(plan, {}, {}, {400.0}, "p-01", "", plan.departure));
  ASSERT_TRUE(without.has_value());
  EXPECT_EQ(read->places.size(), without->places.size());
}

TEST(PlanBrief, TellsHoldsInWordsAndOnTheMap) {
  planning::Plan plan = two_legs();
  plan.waypoints[1].wait = core::Seconds{9600.0};

  const MapPicture picture = draw_map(plan, {}, {}, 720.0, 420.0);

  EXPECT_THAT(brief_facts(plan, {}), testing::Contains("Hold 2 h 40 min at waypoint 1."));
  EXPECT_EQ(picture.waypoints.at(1).text, "1 hold 2 h 40 min");
}

TEST(PlanBrief, NamesTheAlternativesOfThePlan) {
  const json document = json::parse(
      R"({"alternatives":[{"plan_id":"p-02","name":"survey, alternative 1","arrival":"2026-11-24T11:44:12Z",
          "travel_time_s":193452.3,"distance_m":59657.0,"energy_j":null,
          "message":{"text":"this route passes north of the icebergs"}}]})");
  const std::string line =
      "survey, alternative 1 (p-02), arrival 2026-11-24T11:44:12Z, 53.7 h, 59.7 km: this route passes north "
      "of the icebergs";

  EXPECT_THAT(alternative_lines(document), testing::ElementsAre(line));
  EXPECT_THAT(alternative_lines(json::object()), testing::IsEmpty());
  const planning::Plan plan = two_legs();
  const BriefPictures pictures{.map = draw_map(plan, {}, {}, 720.0, 420.0)};
  const BriefNotes notes{"p-01", "", {}, {}, {line}};
  EXPECT_THAT(plan_brief_html(plan, pictures, notes),
              HasSubstr("<b>Alternatives</b><ul>\n<li>" + line + "</li>"));
  EXPECT_THAT(plan_brief_html(plan, pictures, {"p-01", "", {}, {}}), Not(HasSubstr("Alternatives")));
}

/// All texts between an opening and a closing text.
std::vector<std::string> all_between(const std::string& text, const std::string& before,
                                     const std::string& after) {
  std::vector<std::string> found;
  for (std::size_t at = text.find(before); at != std::string::npos; at = text.find(before, at)) {
    at += before.size();
    found.push_back(text.substr(at, text.find(after, at) - at));
  }
  return found;
}

TEST(PlanFiles, CallWaypointsTheSameAsTheMapAndTheBrief) {
  planning::Plan plan = two_legs();
  plan.waypoints.insert(plan.waypoints.end(), 10, plan.waypoints[1]);
  std::vector<std::string> names{"S"};
  for (std::size_t i = 1; i < plan.waypoints.size(); ++i) names.push_back(std::to_string(i));

  std::vector<std::string> in_brief;
  for (const auto& row : brief_rows(plan)) in_brief.push_back(row.front());
  std::vector<std::string> on_map;
  for (const auto& waypoint : draw_map(plan, {}, {}, 720.0, 420.0).waypoints) on_map.push_back(waypoint.text);
  const json document = plan_document(plan, "p-01", "");

  EXPECT_EQ(all_between(plan_gpx(plan, "p-01", ""), "</time><name>", "</name>"), names);
  std::vector<std::string> in_kml = all_between(plan_kml(plan, "p-01", ""), "<Placemark><name>", "</name>");
  in_kml.erase(in_kml.begin());  // the line of the whole route
  EXPECT_EQ(in_kml, names);
  EXPECT_EQ(in_brief, names);
  EXPECT_EQ(on_map, names);
  for (std::size_t i = 1; i < names.size(); ++i)
    EXPECT_EQ(std::to_string(document.at("waypoints").at(i).at("index").get<int>()), names[i]);
}

TEST(PlanBrief, IsAPdfOfAnyNameAndLength) {
  planning::Plan plan = two_legs();
  for (int i = 0; i < 200; ++i) plan.waypoints.push_back(plan.waypoints[1]);
  const MapPicture picture = draw_map(plan, {}, {}, 720.0, 420.0);

  const std::string pdf =
      plan_brief_pdf(plan, {picture}, {"p-01", "Diskobugt \xc3\xa6 \xff\xe2\x82 \x01", plan.departure, {}});

  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  EXPECT_THAT(pdf.substr(pdf.size() - 8), HasSubstr("%%EOF"));
  EXPECT_EQ(pdf, plan_brief_pdf(plan, {picture},
                                {"p-01", "Diskobugt \xc3\xa6 \xff\xe2\x82 \x01", plan.departure, {}}));
}

TEST(MapPicture, HoldsTheWholeRouteInsideItsFrame) {
  support::for_each_seed(200, [](std::mt19937_64& rng) {
    planning::Plan plan;
    const double lon_deg = support::uniform(rng, -180.0, 180.0);
    const double lat_deg = support::uniform(rng, -85.0, 85.0);
    for (int i = support::uniform_int(rng, 1, 12); i > 0; --i) {
      planning::Waypoint waypoint;
      waypoint.place = {geo::wrap_longitude(lon_deg + support::uniform(rng, -5.0, 5.0)),
                        lat_deg + support::uniform(rng, -3.0, 3.0)};
      plan.waypoints.push_back(waypoint);
    }
    for (const auto& point : draw_map(plan, {}, {}, 720.0, 420.0).route) {
      EXPECT_TRUE(point.x >= 0.0 && point.x <= 720.0 && point.y >= 0.0 && point.y <= 420.0);
    }
  });
}

}  // namespace
}  // namespace floeplan::codec::plan_files_test
