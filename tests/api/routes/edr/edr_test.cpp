#include <cmath>

#include "api/codec/bytes/wkt.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "tests/api/routes/api_fixture.hpp"

namespace floeplan::routes::edr_test {
namespace {

using nlohmann::json;
using support::json_of;

/// A current of 0.1 m/s eastwards that grows by 0.1 with each hour, over 54 to 50 W, 68 to 70 N, at 0 and 100 m.
class EdrTest : public support::ApiTest {
 protected:
  EdrTest() {
    repository::Dataset dataset;
    dataset.id = {"currents-00000000"};
    dataset.kind = repository::DatasetKind::currents;
    dataset.name = "Model";
    dataset.bounds = {-54.0, 68.0, -50.0, 70.0};
    dataset.time_start = core::from_unix_seconds(1'795'176'000.0);  // 2026-11-20T12:00:00Z
    dataset.time_end = core::from_unix_seconds(1'795'183'200.0);
    repository::DatasetRepository{db_}.insert(dataset);
    repository::FieldRepository fields{db_};
    fields.create(dataset.id, {.grid = {geo::GridFrame{}, ocean::Axis{{-54.0, -52.0, -50.0}},
                                        ocean::Axis{{68.0, 69.0, 70.0}}},
                               .depths_m = ocean::Axis{{0.0, 100.0}},
                               .times_s = ocean::Axis{{1'795'176'000.0, 1'795'179'600.0, 1'795'183'200.0}}});
    for (std::size_t time = 0; time < 3; ++time) {
      for (std::size_t depth = 0; depth < 2; ++depth) {
        const auto speed = 0.1F * static_cast<float>(time + 1);
        fields.write_slice(dataset.id, "u_m_s", time, depth, std::vector<float>(9, speed));
        fields.write_slice(dataset.id, "v_m_s", time, depth, std::vector<float>(9, 0.0F));
      }
    }
  }
  json get(const std::string& query, int status = 200) {
    const auto response = ask("GET", "/edr/collections/currents/" + query);
    EXPECT_EQ(response.status, status) << response.body;
    return json_of(response);
  }
  static json values(const json& coverage, const std::string& parameter = "eastward_sea_water_velocity") {
    return coverage.at("ranges").at(parameter).at("values");
  }
};

TEST_F(EdrTest, DescribesTheDataThatAreThere) {
  EXPECT_EQ(ask("GET", "/edr").status, 200);
  EXPECT_EQ(ask("GET", "/edr/?f=json").status, 200);
  const json collections = json_of(ask("GET", "/edr/collections"));
  ASSERT_EQ(collections.at("collections").size(), 1U);
  const json& currents = collections.at("collections").at(0);
  EXPECT_EQ(currents.at("extent").at("spatial").at("bbox").at(0), json::array({-54.0, 68.0, -50.0, 70.0}));
  EXPECT_EQ(currents.at("extent").at("temporal").at("interval").at(0).at(1), "2026-11-20T14:00:00Z");
  EXPECT_EQ(json_of(ask("GET", "/edr/collections/currents")), currents);
  EXPECT_EQ(ask("GET", "/edr/collections/sea-ice").status, 404);
  const json api = json_of(ask("GET", "/edr/api"));
  EXPECT_EQ(api.at("servers").at(0).at("url"), "http://127.0.0.1:8080/edr");
  EXPECT_TRUE(api.at("paths").contains("/collections/currents/position"));
  EXPECT_FALSE(api.at("paths").contains("/jobs"));
}

TEST_F(EdrTest, APositionIsAPointASeriesAProfileOrAGrid) {
  const auto type = [&](const std::string& more) {
    return get("position?coords=POINT(-53%2069)" + more).at("domain").at("domainType");
  };
  EXPECT_EQ(type("&z=0&datetime=2026-11-20T12:00:00Z"), "Point");
  EXPECT_EQ(type("&z=0"), "PointSeries");
  EXPECT_EQ(type("&datetime=2026-11-20T12:00:00Z"), "VerticalProfile");
  EXPECT_EQ(type(""), "Grid");
}

TEST_F(EdrTest, ValuesAreThoseOfTheData) {
  EXPECT_EQ(values(get("position?coords=POINT(-53+69)&z=0")), json::array({0.1, 0.2, 0.3}));
  const json between = get("position?coords=POINT(-53+69)&z=50&datetime=2026-11-20T12:30:00Z");
  EXPECT_EQ(values(between), json::array({0.15}));
  EXPECT_EQ(values(between, "sea_water_velocity_to_direction"), json::array({90.0}));
  const json one = get("position?coords=POINT(-53+69)&z=0&parameter-name=sea_water_speed");
  EXPECT_EQ(one.at("ranges").size(), 1U);
  EXPECT_EQ(get("position?coords=MULTIPOINT((-53+69),(-52+69))&z=0").at("coverages").size(), 2U);
}

TEST_F(EdrTest, AreasAndDiscsAreEmptyBeyondTheirEdges) {
  const std::string now = "&z=0&datetime=2026-11-20T12:00:00Z";
  const std::string more = now + "&resolution-x=5&resolution-y=5";
  const json area = get("area?coords=POLYGON((-53+68.5,-52+68.5,-52+69.5,-53+68.5))" + now +
                        "&resolution-x=5&resolution-y=5");
  EXPECT_EQ(area.at("domain").at("domainType"), "Grid");
  ASSERT_EQ(values(area).size(), 25U);
  EXPECT_TRUE(values(area).at(20).is_null()) << "the north-western corner is outside";
  EXPECT_EQ(values(area).at(8), 0.1) << "52.3 W, 68.8 N is inside";
  const json disc = get("radius?coords=POINT(-52+69)&within=20&within-units=km" + more);
  EXPECT_TRUE(values(disc).at(0).is_null());
  EXPECT_EQ(values(disc).at(12), 0.1);
  EXPECT_EQ(values(get("cube?bbox=-53,68.5,-52,69.5" + more)).size(), 25U);
  EXPECT_EQ(values(get("cube?bbox=-53,68.5,-52,69.5&z=0/100&resolution-x=2&resolution-y=2")).size(), 24U);
}

TEST_F(EdrTest, ATrajectoryTakesTheTimeOfEachPlace) {
  const json way = get("trajectory?coords=LINESTRINGZM(-53+69+0+1795176000,-52+69+50+1795183200)");
  EXPECT_EQ(way.at("domain").at("domainType"), "Trajectory");
  EXPECT_EQ(values(way), json::array({0.1, 0.3}));
  const json plain = get("trajectory?coords=LINESTRING(-53+69,-52+69)&datetime=2026-11-20T13:00:00Z&z=0");
  EXPECT_EQ(values(plain), json::array({0.2, 0.2}));
}

TEST_F(EdrTest, AParameterThatIsNamedAgainAndAgainComesOnce) {
  std::string names = "eastward_sea_water_velocity";
  for (int i = 0; i < 300; ++i) names += ",eastward_sea_water_velocity";
  EXPECT_EQ(get("position?coords=POINT(-53+69)&parameter-name=" + names).at("ranges").size(), 1U);
}

TEST_F(EdrTest, WrongQueriesAreRefused) {
  for (const std::string query : {"position",
                                  "area",
                                  "trajectory",
                                  "radius",
                                  "cube",
                                  "position?coords=",
                                  "position?coords=POINT()",
                                  "area?coords=POLYGON()",
                                  "trajectory?coords=LINESTRING()",
                                  "trajectory?coords=LINESTRINGZM()",
                                  "position?coords=POINT(1)",
                                  "position?coords=POINT(0+91)",
                                  "position?coords=POINT(nan+1)",
                                  "area?coords=POLYGON((0+0,1+0,1+1,0+1))",
                                  "position?coords=POINT(-53+69)&z=deep",
                                  "position?coords=POINT(-53+69)&parameter-name=salt",
                                  "position?coords=POINT(-53+69)&crs=EPSG:3857",
                                  "position?coords=POINT(-53+69)&datetime=now",
                                  "position?coords=POINT(-53+69)&f=netcdf",
                                  "radius?coords=POINT(-53+69)&within=2&within-units=leagues",
                                  "position?coords=POINT(-53+69)&salt=1"}) {
    EXPECT_EQ(ask("GET", "/edr/collections/currents/" + query).status, 400) << query;
  }
  EXPECT_EQ(ask("GET", "/edr/collections/currents/position?coords=POINT(0+0)").status, 404);
  const auto large =
      ask("GET", "/edr/collections/currents/cube?bbox=-53,68,-52,69&resolution-x=2000&resolution-y=2000");
  EXPECT_EQ(large.status, 413);
}

TEST(Wkt, ReadsEverySpellingOfDimensions) {
  for (const char* text : {"POINT Z (1 2 3)", "POINTZ(1 2 3)", "point z(1 2 3)"})
    EXPECT_EQ(codec::parse_wkt(text).value().places.front().z_m, 3.0) << text;
  EXPECT_EQ(core::unix_seconds(*codec::parse_wkt("POINT M (1 2 3)").value().places.front().time), 3.0);
  EXPECT_EQ(codec::parse_wkt("MULTIPOLYGON(((0 0,1 0,1 1,0 0)),((2 0,3 0,3 1,2 0)))").value().areas.size(),
            2U);
  for (const char* text :
       {"", "POINT", "POINT EMPTY", "POINT(1 2) x", "POINT Q (1 2)", "CIRCLE(1 2)", "POINT(1 2 3)"})
    EXPECT_FALSE(codec::parse_wkt(text)) << text;
}

}  // namespace
}  // namespace floeplan::routes::edr_test
