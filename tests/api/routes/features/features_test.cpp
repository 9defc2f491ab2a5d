#include "storage/repository/datasets/dataset.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/features/glider_track_repository.hpp"
#include "storage/repository/features/iceberg_repository.hpp"
#include "storage/repository/work/plan_repository.hpp"
#include "tests/api/routes/api_fixture.hpp"

namespace floeplan::routes::features_test {
namespace {

using nlohmann::json;
using support::header_of;
using support::json_of;

constexpr const char* zones = "/collections/nogo-zones/items";
constexpr const char* crs84 = "<http://www.opengis.net/def/crs/OGC/1.3/CRS84>";
const std::string range = R"({"type":"Feature","properties":{"kind":"no_go","name":"Range",
  "from":"2026-06-01T00:00:00Z","until":"2026-07-01T00:00:00Z"},"geometry":{"type":"Polygon",
  "coordinates":[[[-53.1,68.9],[-52.8,68.9],[-52.8,69.1],[-53.1,69.1],[-53.1,68.9]]]}})";

class FeaturesTest : public support::ApiTest {
 protected:
  void store_bergs(int count) {
    repository::Dataset dataset;
    dataset.id = {"icebergs-00000000"};
    dataset.kind = repository::DatasetKind::icebergs;
    dataset.bounds = {-54.0, 68.0, -50.0, 70.0};
    repository::DatasetRepository{db_}.insert(dataset);
    std::vector<ocean::Iceberg> bergs;
    for (int i = 0; i < count; ++i) {
      ocean::Iceberg berg;
      berg.id = "b" + std::to_string(i / 2);
      berg.place = {-54.0 + 0.1 * i, 69.0};
      berg.observed = core::UtcTime{core::Seconds{1.78e9 + 3600.0 * i}};
      bergs.push_back(berg);
    }
    repository::IcebergRepository{db_}.insert(dataset.id, bergs);
  }
  void store_glider_tracks() {
    repository::Dataset dataset;
    dataset.id = {"glider-tracks-00000000"};
    dataset.kind = repository::DatasetKind::glider_tracks;
    dataset.bounds = {-54.0, 68.0, -50.0, 70.0};
    repository::DatasetRepository{db_}.insert(dataset);
    const core::UtcTime start{core::Seconds{1'780'000'000.0}};
    const core::Seconds minute{60.0};
    repository::GliderTrackRepository{db_}.insert(
        dataset.id,
        {{.glider = "amadeus",
          .points = {{.time = start, .place = {-54.0, 69.0}, .depth = core::Metres{0.0}},
                     {.time = start + minute, .place = {-53.9, 69.0}},
                     {.time = start + 2.0 * minute, .place = {-53.8, 69.0}, .depth = core::Metres{180.0}}},
          .currents = {{start + minute, {-53.9, 69.0}, {{0.25}, {-0.5}}}},
          .frame = ocean::CurrentFrame::turned,
          .turned_from = ocean::VehicleAxes{{22, {0.5}}, ocean::VariationSource::log_variation}},
         {.glider = "comet", .points = {{.time = start, .place = {-50.0, 69.0}}}, .currents = {}}});
  }
  void store_plan() {
    repository::PlanRecord plan;
    plan.id = {"p1"};
    plan.departure = core::UtcTime{core::Seconds{1'780'000'000.0}};
    plan.arrival = core::UtcTime{core::Seconds{1'780'007'200.0}};
    plan.bounds = {-53.0, 69.0, -52.8, 69.0};
    plan.document_json =
        R"({"waypoints":[{"lon":-53.0,"lat":69.0,"eta":"2026-05-28T20:26:40Z"},
            {"lon":-52.9,"lat":69.0,"eta":"2026-05-28T21:26:40Z","leg_m":4000.0},
            {"lon":-52.8,"lat":69.0,"eta":"2026-05-28T22:26:40Z","leg_m":4000.0}]})";
    repository::PlanRepository{db_}.insert(plan);
  }
  std::vector<json> ids(const std::string& target) {
    const auto response = ask("GET", target);
    EXPECT_EQ(response.status, 200) << response.body;
    std::vector<json> found;
    const json page = json_of(response);
    for (const auto& feature : page.at("features")) found.push_back(feature.at("id"));
    return found;
  }
  std::string location_of(const Response& created) {
    const std::string address = header_of(created, "Location");
    return address.substr(std::string{"http://127.0.0.1:8080"}.size());
  }
};

TEST_F(FeaturesTest, EveryCollectionIsDescribedAndAnswers) {
  const json collections = json_of(ask("GET", "/collections")).at("collections");
  EXPECT_EQ(collections.size(), 8U);
  for (const auto& collection : collections) {
    const std::string base = "/collections/" + collection.at("id").get<std::string>();
    EXPECT_EQ(json_of(ask("GET", base)), collection);
    const auto items = ask("GET", base + "/items");
    EXPECT_EQ(items.status, 200);
    EXPECT_EQ(items.content_type, "application/geo+json");
    EXPECT_EQ(header_of(items, "Content-Crs"), crs84);
    EXPECT_TRUE(json_of(ask("GET", base + "/schema")).at("properties").contains("geometry"));
  }
}

/// Without this, a plan between two corners of the zone would not read the zones that were drawn by hand.
TEST_F(FeaturesTest, AZoneAllRoundTheEarthWidensWhatIsKnownOfItsDataset) {
  json ring = json::array();
  for (int lon = -180; lon <= 180; lon += 60) ring.push_back({lon, 60});
  for (int lon = 180; lon >= -180; lon -= 60) ring.push_back({lon, 80});
  ring.push_back({-180, 60});
  const json band{{"type", "Feature"},
                  {"properties", {{"kind", "no_go"}, {"name", "Band"}}},
                  {"geometry", {{"type", "Polygon"}, {"coordinates", json::array({ring})}}}};

  ASSERT_EQ(ask("POST", zones, band.dump()).status, 201);

  const auto dataset =
      repository::DatasetRepository{db_}.find(repository::hand_made_id(repository::DatasetKind::zones));
  ASSERT_TRUE(dataset);
  EXPECT_EQ(geo::width_deg(dataset->bounds), 360.0);
}

TEST_F(FeaturesTest, GeometriesAndBoxesComeInTheReferenceSystemThatIsAskedFor) {
  store_bergs(1);
  const std::string items = "/collections/icebergs/items?";
  const std::string mercator = "http://www.opengis.net/def/crs/EPSG/0/3857";
  const std::string latitude_first = "http://www.opengis.net/def/crs/EPSG/0/4326";
  const auto coordinates = [&](const std::string& query) {
    return json_of(ask("GET", items + query)).at("features").at(0).at("geometry").at("coordinates");
  };
  EXPECT_EQ(coordinates("crs=" + latitude_first), json::array({69.0, -54.0}));
  // gdaltransform 3.6.2 -s_srs OGC:CRS84 -t_srs EPSG:3857, for -54 69
  EXPECT_NEAR(coordinates("crs=" + mercator).at(0).get<double>(), -6011252.50283677, 1e-6);
  EXPECT_NEAR(coordinates("crs=" + mercator).at(1).get<double>(), 10750786.5345999, 1e-6);
  EXPECT_EQ(header_of(ask("GET", items + "crs=" + mercator), "Content-Crs"), "<" + mercator + ">");

  EXPECT_THAT(ids(items + "bbox=68.9,-54.1,69.1,-53.9&bbox-crs=" + latitude_first), testing::SizeIs(1));
  EXPECT_EQ(coordinates("crs=EPSG:4326&bbox=68.9,-54.1,69.1,-53.9&bbox-crs=EPSG:4326"),
            json::array({69.0, -54.0}));
  EXPECT_THAT(ids(items + "bbox=-6100000,10700000,-6000000,10800000&bbox-crs=" + mercator),
              testing::SizeIs(1));
  EXPECT_THAT(ids(items + "bbox=68.9,-54.1,69.1,-53.9"), testing::IsEmpty());
  const std::string unknown = "http://www.opengis.net/def/crs/0/unsupported";
  EXPECT_EQ(ask("GET", items + "crs=" + unknown).status, 400);
  EXPECT_EQ(ask("GET", items + "bbox=0,0,1,1&bbox-crs=" + unknown).status, 400);
  EXPECT_EQ(ask("GET", "/collections/icebergs/items/1?crs=" + unknown).status, 400);
}

TEST_F(FeaturesTest, TheExtentOfDataAcrossTheAntimeridianRunsAcrossIt) {
  int number = 0;
  for (const geo::BoundingBox box :
       {geo::BoundingBox{170.0, 60.0, 175.0, 61.0}, geo::BoundingBox{178.0, 60.0, -178.0, 64.0},
        geo::BoundingBox{-172.0, 59.0, -170.0, 61.0}}) {
    repository::Dataset dataset;
    dataset.id = {"zones-0000000" + std::to_string(++number)};
    dataset.kind = repository::DatasetKind::zones;
    dataset.bounds = box;
    dataset.provenance.sha256 = dataset.id.value;
    repository::DatasetRepository{db_}.insert(dataset);
  }
  EXPECT_EQ(json_of(ask("GET", "/collections/nogo-zones")).at("extent").at("spatial").at("bbox"),
            json::parse("[[170.0,59.0,-170.0,64.0]]"));
}

TEST_F(FeaturesTest, PagesMissNothingAndRepeatNothingWhileMoreIsStored) {
  store_bergs(5);
  const auto first = json_of(ask("GET", "/collections/icebergs/items?limit=2"));
  repository::IcebergRepository{db_}.insert({"icebergs-00000000"}, {ocean::Iceberg{}});
  std::string next;
  for (const auto& link : first.at("links"))
    if (link.at("rel") == "next") next = link.at("href");
  ASSERT_NE(next, "");
  EXPECT_THAT(ids(next.substr(21)), testing::ElementsAre(3, 4));
}

TEST_F(FeaturesTest, TracksJoinTheSightingsOfABerg) {
  store_bergs(5);  // b0 twice, b1 twice, b2 once
  const std::string items = "/collections/iceberg-tracks/items";
  EXPECT_THAT(ids(items), testing::ElementsAre(1, 3));
  EXPECT_THAT(ids(items + "?berg_id=b1"), testing::ElementsAre(3));
  EXPECT_THAT(ids(items + "?bbox=-53.85,68,-53.65,70"), testing::ElementsAre(3));
  EXPECT_THAT(ids(items + "?limit=1"), testing::ElementsAre(1));
  EXPECT_EQ(json_of(ask("GET", items + "/3")).at("properties").at("sightings"), 2);
  EXPECT_EQ(ask("GET", items + "/4").status, 404);
}

TEST_F(FeaturesTest, TracksOfGlidersHaveTheirDepthsTimesAndCurrents) {
  store_glider_tracks();
  const std::string items = "/collections/glider-tracks/items";

  EXPECT_THAT(ids(items), testing::ElementsAre(1, 2));
  EXPECT_THAT(ids(items + "?glider=comet"), testing::ElementsAre(2));
  EXPECT_THAT(ids(items + "?bbox=-53.95,68,-53.85,70"), testing::ElementsAre(1));
  EXPECT_THAT(ids(items + "?datetime=2026-05-28T20:20:00Z/.."), testing::ElementsAre(1, 2));
  EXPECT_THAT(ids(items + "?datetime=2027-01-01T00:00:00Z/.."), testing::IsEmpty());
  const json page = json_of(ask("GET", items + "?limit=1"));
  EXPECT_EQ(page.at("numberMatched"), 2);
  EXPECT_EQ(page.at("numberReturned"), 1);

  const json track = json_of(ask("GET", items + "/1"));
  EXPECT_EQ(track.at("geometry"), json::parse(R"({"type":"LineString",
    "coordinates":[[-54.0,69.0,0.0],[-53.9,69.0,-90.0],[-53.8,69.0,-180.0]]})"));
  const json& told = track.at("properties");
  EXPECT_EQ(told.at("glider"), "amadeus");
  EXPECT_EQ(told.at("points"), 3);
  EXPECT_EQ(told.at("deepest_m"), 180.0);
  EXPECT_EQ(told.at("depths_m"), json::parse("[0.0, null, 180.0]"));
  EXPECT_EQ(told.at("times").size(), 3U);
  EXPECT_EQ(told.at("start"), told.at("times").front());
  EXPECT_EQ(told.at("mean_east_m_s"), 0.25);
  EXPECT_EQ(told.at("currents").at(0).at("north_m_s"), -0.5);
  EXPECT_EQ(told.at("current_frame"), "true");
  EXPECT_EQ(told.at("currents_turned_from").at("utm_zone"), 22);
  EXPECT_NEAR(told.at("currents_turned_from").at("declination_deg").get<double>(), -28.6479, 1e-4);
  EXPECT_EQ(told.at("currents_turned_from").at("declination_from"), "m_gps_mag_var");
  EXPECT_EQ(told.at("dataset_id"), "glider-tracks-00000000");
  const json turned = json_of(ask("GET", items + "/1?crs=http://www.opengis.net/def/crs/EPSG/0/4326"));
  EXPECT_EQ(turned.at("geometry").at("coordinates").at(2), json::parse("[69.0,-53.8,-180.0]"));
  EXPECT_EQ(ask("GET", items + "/3").status, 404);
}

TEST_F(FeaturesTest, AGliderThatWasSeenAtOnePlaceHasALineFromThereToThere) {
  store_glider_tracks();
  const json track = json_of(ask("GET", "/collections/glider-tracks/items/2"));
  EXPECT_EQ(track.at("geometry").at("coordinates"), json::parse("[[-50.0,69.0],[-50.0,69.0]]"));
  EXPECT_EQ(track.at("properties").at("times").size(), 2U);
  EXPECT_EQ(track.at("properties").at("mean_east_m_s"), nullptr);
  EXPECT_EQ(track.at("properties").at("current_frame"), nullptr);
}

TEST_F(FeaturesTest, LegsAndWaypointsOfPlansAreFoundByPlaceAndTime) {
  store_plan();
  EXPECT_THAT(ids("/collections/plan-legs/items"), testing::ElementsAre("p1.0", "p1.1"));
  EXPECT_THAT(ids("/collections/waypoints/items"), testing::ElementsAre("p1.0", "p1.1", "p1.2"));
  EXPECT_THAT(ids("/collections/plan-legs/items?bbox=-52.85,68,-52,70"), testing::ElementsAre("p1.1"));
  EXPECT_THAT(ids("/collections/plan-legs/items?datetime=2026-05-28T20:30:00Z"),
              testing::ElementsAre("p1.0"));
  EXPECT_THAT(ids("/collections/waypoints/items?datetime=2026-05-28T22:00:00Z/.."),
              testing::ElementsAre("p1.2"));
  EXPECT_THAT(ids("/collections/waypoints/items?plan_id=p2"), testing::IsEmpty());
  EXPECT_THAT(ids("/collections/plans/items?datetime=2026-05-28T21:00:00Z"), testing::ElementsAre("p1"));
  EXPECT_THAT(ids("/collections/plans/items?datetime=../2026-05-28T20:00:00Z"), testing::IsEmpty());
  EXPECT_EQ(ask("GET", "/collections/plan-legs/items/p1.1").status, 200);
  EXPECT_EQ(ask("GET", "/collections/plan-legs/items/p1.2").status, 404);
  EXPECT_EQ(ask("GET", "/collections/plan-legs/items/p1").status, 404);
}

TEST_F(FeaturesTest, APageOfPartsGoesOnWhereTheLastOneEnded) {
  store_plan();
  const auto first = json_of(ask("GET", "/collections/waypoints/items?limit=2"));
  EXPECT_EQ(first.at("numberMatched"), 3);
  std::string next;
  for (const auto& link : first.at("links"))
    if (link.at("rel") == "next") next = link.at("href");
  ASSERT_NE(next, "");
  EXPECT_THAT(ids(next.substr(21)), testing::ElementsAre("p1.2"));
}

TEST_F(FeaturesTest, AZoneIsMadeChangedAndRemoved) {
  const auto created = ask("POST", zones, range);
  ASSERT_EQ(created.status, 201) << created.body;
  const std::string zone = location_of(created);
  EXPECT_EQ(zone, std::string{zones} + "/1");
  EXPECT_EQ(json_of(ask("GET", zone)).at("properties").at("name"), "Range");
  EXPECT_THAT(ids(std::string{zones} + "?datetime=2026-06-15T00:00:00Z"), testing::SizeIs(1));
  EXPECT_THAT(ids(std::string{zones} + "?datetime=2026-08-15T00:00:00Z"), testing::IsEmpty());
  EXPECT_THAT(ids(std::string{zones} + "?bbox=-53,69,-52.9,69.05&kind=no_go"), testing::SizeIs(1));

  EXPECT_EQ(ask("PATCH", zone, R"({"properties":{"name":"Firing range"}})").status, 204);
  EXPECT_EQ(json_of(ask("GET", zone)).at("properties").at("name"), "Firing range");
  EXPECT_EQ(ask("PUT", zone, range).status, 204);
  EXPECT_EQ(json_of(ask("GET", zone)).at("properties").at("name"), "Range");

  EXPECT_EQ(ask("DELETE", zone).status, 204);
  EXPECT_EQ(ask("GET", zone).status, 404);
  EXPECT_TRUE(repository::DatasetRepository{db_}.list().empty()) << "nothing is left of it";
}

TEST_F(FeaturesTest, AChangeIsMadeToTheVersionThatWasRead) {
  const std::string zone = location_of(ask("POST", zones, range));
  const std::string tag = header_of(ask("GET", zone), "ETag");
  ASSERT_NE(tag, "");
  ASSERT_EQ(ask("PATCH", zone, R"({"properties":{"name":"other"}})", {{"if-match", tag}}).status, 204);
  EXPECT_EQ(ask("PUT", zone, range, {{"if-match", tag}}).status, 412);
  EXPECT_EQ(ask("DELETE", zone, "", {{"if-match", tag}}).status, 412);
  EXPECT_EQ(ask("DELETE", zone, "", {{"if-match", header_of(ask("GET", zone), "ETag")}}).status, 204);
}

TEST_F(FeaturesTest, EveryChangeIsSeenInTheDigestOfTheData) {
  repository::DatasetRepository datasets{db_};
  const std::string zone = location_of(ask("POST", zones, range));
  const std::string before = datasets.contents();
  ask("PATCH", zone, R"({"properties":{"name":"other"}})");
  EXPECT_NE(datasets.contents(), before);
}

TEST_F(FeaturesTest, WhatAFileSaysIsNotChanged) {
  store_bergs(1);
  EXPECT_EQ(ask("DELETE", "/collections/icebergs/items/1").status, 409);
  EXPECT_EQ(ask("PATCH", "/collections/icebergs/items/1", "{}").status, 409);
  EXPECT_EQ(ask("DELETE", "/collections/icebergs/items/9").status, 404);
}

TEST_F(FeaturesTest, AnIcebergThatSomebodyReportsStandsBesideThoseOfFiles) {
  store_bergs(1);
  const auto created = ask("POST", "/collections/icebergs/items",
                           R"({"type":"Feature","geometry":{"type":"Point","coordinates":[-52.5,69.1]},
                              "properties":{"berg_id":"seen","observed":"2026-11-20T06:00:00Z","length_m":80}})");
  ASSERT_EQ(created.status, 201) << created.body;
  EXPECT_THAT(ids("/collections/icebergs/items"), testing::SizeIs(2));
  EXPECT_THAT(ids("/collections/icebergs/items?bbox=-52.6,69,-52.4,69.2"), testing::SizeIs(1));
  EXPECT_THAT(ids("/collections/icebergs/items?berg_id=seen"), testing::SizeIs(1));
}

TEST_F(FeaturesTest, EveryFaultOfAFeatureIsNamed) {
  const auto refused =
      ask("POST", "/collections/icebergs/items",
          R"({"type":"Feature","geometry":null,"properties":{"size":"huge","length_m":-1}})");
  EXPECT_EQ(refused.status, 400);
  std::vector<std::string> pointers;
  const json problem = json_of(refused);
  for (const auto& error : problem.at("errors")) pointers.push_back(error.at("pointer"));
  EXPECT_THAT(pointers,
              testing::UnorderedElementsAre("/geometry", "/properties/berg_id", "/properties/observed",
                                            "/properties/size", "/properties/length_m"));
  for (const std::string body :
       {"", "[]", "{}", R"({"type":"Feature","geometry":{"type":"Point"},"properties":{}})"})
    EXPECT_EQ(ask("POST", zones, body).status, 400) << body;
  EXPECT_EQ(
      ask("POST", zones, range, {{"content-crs", "<http://www.opengis.net/def/crs/EPSG/0/3857>"}}).status,
      400);
  EXPECT_EQ(ask("POST", zones, range, {{"content-type", "text/plain"}}).status, 415);
}

TEST_F(FeaturesTest, AKeyMakesOneFeature) {
  const auto first = ask("POST", zones, range, {{"idempotency-key", "k"}});
  EXPECT_EQ(location_of(ask("POST", zones, range, {{"idempotency-key", "k"}})), location_of(first));
  EXPECT_THAT(ids(zones), testing::SizeIs(1));
}

TEST_F(FeaturesTest, OptionsTellWhatCanBeDone) {
  EXPECT_EQ(header_of(ask("OPTIONS", zones), "Allow"), "OPTIONS, GET, HEAD, POST");
  EXPECT_EQ(header_of(ask("OPTIONS", std::string{zones} + "/1"), "Allow"),
            "OPTIONS, GET, HEAD, PUT, PATCH, DELETE");
  EXPECT_EQ(header_of(ask("OPTIONS", "/collections/waypoints/items"), "Allow"), "OPTIONS, GET, HEAD");
}

}  // namespace
}  // namespace floeplan::routes::features_test
