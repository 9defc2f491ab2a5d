#include "api/codec/documents/plan_document.hpp"
#include "api/routes/plans/plan_exports.hpp"
#include "engine/core/utc_text.hpp"
#include "engine/messages/data_messages.hpp"
#include "storage/repository/work/plan_repository.hpp"
#include "tests/api/routes/api_fixture.hpp"

namespace floeplan::routes::mission_files_test {
namespace {

using nlohmann::json;
using support::json_of;
using testing::Contains;
using testing::HasSubstr;

/// A plan of one leg, made in data that the store no longer has.
class MissionFilesTest : public support::ApiTest {
 protected:
  MissionFilesTest() {
    planning::Plan plan;
    plan.vehicle = "slocum-g3-200";
    plan.departure = core::UtcTime{core::Seconds{1.8e9}};
    plan.arrival = plan.departure + core::Seconds{30'000.0};
    plan.waypoints.resize(2);
    plan.waypoints[0].place = {-53.0, 69.0};
    plan.waypoints[0].eta = plan.departure;
    plan.waypoints[1].place = {-52.75, 69.0};
    plan.waypoints[1].eta = plan.arrival;
    plan.waypoints[1].leg_length = core::Metres{10'000.0};
    plan.datasets = {{.id = "icebergs-00000000", .kind = "icebergs", .name = "old", .sha256 = "0"}};
    repository::PlanRecord record;
    record.id = {"p1"};
    record.departure = plan.departure;
    record.arrival = plan.arrival;
    record.request_json = R"({"from":[-53,69],"to":[-52.75,69],"depart":"2027-01-15T08:00:00Z"})";
    record.document_json = codec::plan_document(plan, "p1", "").dump();
    repository::PlanRepository{db_}.insert(record);
  }

  json ask_for(const std::string& query) {
    return json_of(ask("GET", "/collections/plans/items/p1/mission" + query));
  }
};

TEST_F(MissionFilesTest, AreTheListsAloneUnlessAllAreAskedFor) {
  const json lists = ask_for("");
  ASSERT_EQ(lists["files"].size(), 1U);
  EXPECT_EQ(lists["files"][0]["name"], "goto_l10.ma");

  const json all = ask_for("?full=true&mission=disko&number=20");
  ASSERT_EQ(all["files"].size(), 10U);
  EXPECT_EQ(all["files"][0]["name"], "disko.mi");
  EXPECT_EQ(all["files"][1]["name"], "goto_l20.ma");
}

TEST_F(MissionFilesTest, UnderIceHoldTheSafePlaces) {
  const json all = ask_for("?safe=-53.5,69;-53.25,69.1&iceberg_depth_m=35");

  std::vector<std::string> names;
  for (const json& file : all["files"]) names.push_back(file["name"]);
  EXPECT_THAT(names, Contains("goto_l98.ma"));
  EXPECT_THAT(all["files"][0]["text"].get<std::string>(), HasSubstr("u_max_expected_iceberg_depth(m) 35\n"));
}

TEST_F(MissionFilesTest, SayThatTheDataHaveChangedSinceThePlanWasMade) {
  const auto response = ask("GET", "/collections/plans/items/p1/mission.gpx");

  EXPECT_EQ(response.status, 200);
  EXPECT_THAT(support::header_of(response, "Floeplan-Warning"), HasSubstr("data have changed"));
}

TEST_F(MissionFilesTest, ComeInEveryOtherFormatToo) {
  for (const auto& [format, start] : std::map<std::string, std::string>{{"gpx", "<?xml"},
                                                                        {"kml", "<?xml"},
                                                                        {"geojson", "{"},
                                                                        {"csv", "index,"},
                                                                        {"nmea", "$GPWPL"},
                                                                        {"targets", "/ plan id p1"},
                                                                        {"imc", "{"},
                                                                        {"html", "<!DOCTYPE html>"},
                                                                        {"pdf", "%PDF-"}}) {
    const auto response = ask("GET", "/collections/plans/items/p1/mission." + format);
    EXPECT_EQ(response.status, 200) << format;
    EXPECT_EQ(response.body.substr(0, start.size()), start) << format;
  }
  EXPECT_EQ(ask("GET", "/collections/plans/items/p1/mission.doc").status, 404);
}

TEST_F(MissionFilesTest, AreThoseOfASeagliderWhenAskedFor) {
  const json set = ask_for("?format=seaglider&science=20:5:1110:60;200:10:1100:120");

  ASSERT_EQ(set["files"].size(), 3U);
  EXPECT_EQ(set["files"][1]["name"], "science");
  EXPECT_THAT(set["files"][1]["text"].get<std::string>(), HasSubstr("200 seconds=10 sensors=1100 gc=120\n"));
  EXPECT_THAT(ask("GET", "/collections/plans/items/p1/mission.zip?format=seaglider&glider=sg123").body,
              HasSubstr("sg123/targets"));
}

TEST_F(MissionFilesTest, LieInTheArchiveWhereADockserverLooksForThem) {
  const std::string zip = ask("GET", "/collections/plans/items/p1/mission.zip?glider=amadeus").body;

  EXPECT_THAT(zip, HasSubstr("gliders/amadeus/to-glider/goto_l10.ma"));
  EXPECT_THAT(ask("GET", "/collections/plans/items/p1/mission.zip").body,
              testing::Not(HasSubstr("to-glider")));
  for (const char* bad : {"..%2Fup", "a%20b", "%2Fetc"})
    EXPECT_EQ(ask("GET", "/collections/plans/items/p1/mission.zip?glider=" + std::string{bad}).status, 400)
        << bad;
}

/// The warnings of the response, in the order of its headers.
std::vector<std::string> warnings_of(const Response& response) {
  std::vector<std::string> warnings;
  for (const auto& [name, value] : response.headers)
    if (name == "Floeplan-Warning") warnings.push_back(value);
  return warnings;
}

TEST_F(MissionFilesTest, WarnInTheArchivesHeadersOfAllThatTheyWarnOfByThemselves) {
  const json set = ask_for("?full=true");

  const auto zip = warnings_of(ask("GET", "/collections/plans/items/p1/mission.zip?full=true"));

  EXPECT_THAT(zip, testing::UnorderedElementsAreArray(set["warnings"].get<std::vector<std::string>>()));
  EXPECT_THAT(zip, Contains(HasSubstr("pump and pitch in the yo file")));
}

TEST_F(MissionFilesTest, SayWhatThePlanWasMadeWithout) {
  const auto warnings = ask_for("")["warnings"].get<std::vector<std::string>>();

  EXPECT_THAT(warnings, Contains(HasSubstr("made without sea ice, so open water is assumed")));
  EXPECT_THAT(warnings, Contains(HasSubstr("made without bathymetry")));
  EXPECT_THAT(warnings, testing::Not(Contains(HasSubstr("made without icebergs"))));
}

TEST_F(MissionFilesTest, SayOnceWhatThePlanSaysItWasMadeWithout) {
  const repository::PlanRecord stored = repository::PlanRepository{db_}.find({"p1"}).value();
  planning::Plan plan = codec::parse_plan_document(json::parse(stored.document_json));
  plan.messages = {messages::data_message<"ice-left-out">()};
  repository::PlanRecord record = stored;
  record.id = {"p2"};
  record.document_json = codec::plan_document(plan, "p2", "").dump();
  repository::PlanRepository{db_}.insert(record);

  const std::string brief = ask("GET", "/collections/plans/items/p2/mission.html").body;

  const auto told = brief.find("Sea ice was left out as requested");
  ASSERT_NE(told, std::string::npos);
  EXPECT_EQ(brief.find("Sea ice was left out as requested", told + 1), std::string::npos);
  EXPECT_THAT(brief, testing::Not(HasSubstr("made without sea ice")));
  EXPECT_THAT(brief, HasSubstr("made without bathymetry"));
}

TEST_F(MissionFilesTest, AreDownloadedUnderTheNameDepartureAndIdOfThePlan) {
  repository::PlanRecord plan;
  plan.id = {"p1c2d3e4f5a6"};
  plan.departure = core::parse_iso8601("2026-11-22T06:00:00Z").value();
  EXPECT_EQ(download_stem(plan), "plan-20261122T0600Z-p1c2d3e4f5a6");
  plan.name = "Into the \"Kangia\"/../fjørd ";
  EXPECT_EQ(download_stem(plan), "Into_the_Kangia_fj_rd-20261122T0600Z-p1c2d3e4f5a6");

  for (const std::string format : {"zip", "gpx"}) {
    const auto response = ask("GET", "/collections/plans/items/p1/mission." + format);
    EXPECT_THAT(response.headers, testing::Contains(testing::Pair(
                                      "Content-Disposition", testing::EndsWith("-p1." + format + "\""))));
  }
}

TEST_F(MissionFilesTest, RefuseBadOptions) {
  const std::string path = "/collections/plans/items/p1/mission?";
  for (const char* query :
       {"number=98", "firmware=ten", "safe=here", "iceberg_depth_m=20", "full=true&mission=recov",
        "safe=-53,69&iceberg_depth_m=900", "accept_dangers=maybe", "force=true", "format=spray",
        "science=20:5:1:60", "format=seaglider&science=20:5"})
    EXPECT_EQ(ask("GET", path + query).status, 400) << query;
}

}  // namespace
}  // namespace floeplan::routes::mission_files_test
