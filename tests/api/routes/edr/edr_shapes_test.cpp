#include <array>
#include <cmath>
#include <map>
#include <sstream>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/fields/field_overviews.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "tests/api/routes/api_fixture.hpp"
#include "tests/support/property.hpp"

namespace floeplan::routes::edr_shapes_test {
namespace {

using nlohmann::json;
using support::for_each_seed;
using support::json_of;
using support::uniform;
using support::uniform_int;

constexpr double noon_s = 1'795'176'000.0;  // 2026-11-20T12:00:00Z
const std::string currents = "/edr/collections/currents/";
const std::string at_noon = "&z=0&datetime=2026-11-20T12:00:00Z";
const std::string east_name = "eastward_sea_water_velocity";

std::vector<double> nodes_from(double first, double step, int count) {
  std::vector<double> nodes;
  for (int i = 0; i < count; ++i) nodes.push_back(first + i * step);
  return nodes;
}

/// Currents on a grid: u is the value of `u_m_s` at the node, at all depths and times; v is zero.
struct Model {
  std::string id{"currents-00000000"};
  geo::GridFrame frame{};
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> depths_m{0.0};  // empty: no such axis
  std::vector<double> times_s{noon_s};
  double ingested_s{1e9};
  std::function<double(std::size_t ix, std::size_t iy)> u_m_s{[](auto...) { return 0.3; }};
};

class EdrShapesTest : public support::ApiTest {
 protected:
  void store(const Model& model) {
    const ocean::HorizontalGrid grid{model.frame, ocean::Axis{model.x}, ocean::Axis{model.y}};
    repository::Dataset dataset;
    dataset.id = {model.id};
    dataset.kind = repository::DatasetKind::currents;
    dataset.name = "Model";
    dataset.bounds = grid.bounds();
    dataset.time_start = core::from_unix_seconds(model.times_s.front());
    dataset.time_end = core::from_unix_seconds(model.times_s.back());
    dataset.provenance.ingested = core::from_unix_seconds(model.ingested_s);
    dataset.provenance.sha256 = model.id;
    repository::DatasetRepository{db_}.insert(dataset);
    repository::FieldRepository fields{db_};
    const std::size_t levels = std::max<std::size_t>(model.depths_m.size(), 1);
    const bool has_depths = !model.depths_m.empty();
    fields.create(dataset.id,
                  {.grid = grid,
                   .depths_m = has_depths ? std::optional{ocean::Axis{model.depths_m}} : std::nullopt,
                   .times_s = ocean::Axis{model.times_s}});
    std::vector<float> u;
    for (std::size_t iy = 0; iy < model.y.size(); ++iy)
      for (std::size_t ix = 0; ix < model.x.size(); ++ix)
        u.push_back(static_cast<float>(model.u_m_s(ix, iy)));
    // The pair is missing where u is.
    std::vector<float> v;
    for (const float east : u) v.push_back(std::isnan(east) ? east : 0.0F);
    for (std::size_t time = 0; time < model.times_s.size(); ++time) {
      for (std::size_t depth = 0; depth < levels; ++depth) {
        fields.write_slice(dataset.id, "u_m_s", time, depth, u);
        fields.write_slice(dataset.id, "v_m_s", time, depth, v);
      }
    }
  }
  void remove(const std::string& id) { repository::DatasetRepository{db_}.remove({id}); }

  json get(const std::string& query, int status = 200) {
    const auto response = ask("GET", query);
    EXPECT_EQ(response.status, status) << query << '\n' << response.body;
    return json_of(response);
  }
  static json axis(const json& coverage, const std::string& name) {
    return coverage.at("domain").at("axes").at(name).at("values");
  }
  static json values(const json& coverage) { return coverage.at("ranges").at(east_name).at("values"); }

  std::optional<double> at_position(double lon_deg, double lat_deg) {
    std::ostringstream query;
    query.precision(17);
    query << currents << "position?coords=POINT(" << lon_deg << "+" << lat_deg << ")" << at_noon;
    const auto response = ask("GET", query.str());
    if (response.status != 200) return std::nullopt;
    const json value = values(json_of(response)).at(0);
    return value.is_null() ? std::nullopt : std::optional{value.get<double>()};
  }
};

/// Half a degree from 10 W to 5 W and 50 N to 55 N.
Model half_degrees() { return {.x = nodes_from(-10.0, 0.5, 11), .y = nodes_from(50.0, 0.5, 11)}; }

int count_of_values(const json& list) {
  return static_cast<int>(std::ranges::count_if(list, [](const json& value) { return !value.is_null(); }));
}

TEST_F(EdrShapesTest, ADiscIsAskedAtTheNodesInIt) {
  store(half_degrees());
  const json disc = get(currents + "radius?coords=POINT(-7.5+52.5)&within=20&within-units=km" + at_noon);
  EXPECT_EQ(axis(disc, "x"), json::array({-7.5}));
  EXPECT_EQ(axis(disc, "y"), json::array({52.5}));
  EXPECT_EQ(values(disc), json::array({0.3}));
  EXPECT_EQ(disc.at("source").at("sampling"), "every node of the data in the shape");
  EXPECT_EQ(disc.at("source").at("dataset_id"), "currents-00000000");
}

TEST_F(EdrShapesTest, AShapeBetweenNodesIsAnsweredAtItsMiddle) {
  store(half_degrees());
  const json disc = get(currents + "radius?coords=POINT(-7.3+52.2)&within=5" + at_noon);
  EXPECT_EQ(axis(disc, "x"), json::array({-7.3}));
  EXPECT_EQ(values(disc), json::array({0.3}));
  const json sliver =
      get(currents + "area?coords=POLYGON((-9.4+51.1,-6.1+51.2,-9.4+51.3,-9.4+51.1))" + at_noon);
  EXPECT_EQ(values(sliver), json::array({0.3}));
  EXPECT_EQ(values(get(currents + "cube?bbox=-7.4,52.1,-7.1,52.4" + at_noon)), json::array({0.3}));
}

TEST_F(EdrShapesTest, ADiamondHoldsTheNodesInItAndOnItsEdges) {
  store(half_degrees());
  const json diamond =
      get(currents + "area?coords=POLYGON((-8+52.5,-7.5+52,-7+52.5,-7.5+53,-8+52.5))" + at_noon);
  EXPECT_EQ(axis(diamond, "x"), json::array({-8.0, -7.5, -7.0}));
  EXPECT_EQ(axis(diamond, "y"), json::array({52.0, 52.5, 53.0}));
  EXPECT_EQ(values(diamond), json::array({nullptr, 0.3, nullptr, 0.3, 0.3, 0.3, nullptr, 0.3, nullptr}));
}

TEST_F(EdrShapesTest, ACubeHasTheNodesOfTheModelAlongBothAxes) {
  store(half_degrees());
  const json cube = get(currents + "cube?bbox=-8,52,-7,53" + at_noon);
  EXPECT_EQ(axis(cube, "x"), json::array({-8.0, -7.5, -7.0}));
  EXPECT_EQ(axis(cube, "y"), json::array({52.0, 52.5, 53.0}));
  EXPECT_EQ(count_of_values(values(cube)), 9);
  // By the standard, the first and the last of the requested places lie on the edges of the cube.
  const json asked = get(currents + "cube?bbox=-8,52,-7,53&resolution-x=2&resolution-y=3" + at_noon);
  EXPECT_EQ(axis(asked, "x"), json::array({-8.0, -7.0}));
  EXPECT_EQ(axis(asked, "y"), json::array({52.0, 52.5, 53.0}));
}

TEST_F(EdrShapesTest, AGridThatIsAskedForIsCentredInAShape) {
  store(half_degrees());
  const json disc =
      get(currents + "radius?coords=POINT(-7.3+52.2)&within=40&resolution-x=2&resolution-y=2" + at_noon);
  EXPECT_EQ(values(disc), json::array({0.3, 0.3, 0.3, 0.3}));
}

TEST_F(EdrShapesTest, AHoleOfAPolygonIsLeftOut) {
  store(half_degrees());
  const json ring = get(currents +
                        "area?coords=POLYGON((-8.6+51.4,-6.4+51.4,-6.4+53.6,-8.6+53.6,-8.6+51.4),"
                        "(-7.8+52.2,-7.8+52.8,-7.2+52.8,-7.2+52.2,-7.8+52.2))" +
                        at_noon);
  ASSERT_EQ(values(ring).size(), 25U);
  EXPECT_TRUE(values(ring).at(12).is_null());
  EXPECT_EQ(count_of_values(values(ring)), 24);
}

TEST_F(EdrShapesTest, AShapeHalfOutsideTheDataHasTheNodesInside) {
  store(half_degrees());
  const json cube = get(currents + "cube?bbox=-5.6,54.4,40,80" + at_noon);
  EXPECT_EQ(axis(cube, "x"), json::array({-5.5, -5.0}));
  EXPECT_EQ(axis(cube, "y"), json::array({54.5, 55.0}));
  EXPECT_EQ(get(currents + "cube?bbox=0,0,1,1" + at_noon, 404).at("type"), "/problems/no-data");
}

TEST_F(EdrShapesTest, NoAnswerIsMadeUpWhereTheMiddleIsLand) {
  Model model = half_degrees();
  model.u_m_s = [](std::size_t ix, std::size_t) { return ix < 5 ? 0.3 : NAN; };
  store(model);
  const json refusal = get(currents + "radius?coords=POINT(-6.3+52.2)&within=5" + at_noon, 404);
  EXPECT_NE(refusal.at("detail").get<std::string>().find("-6.3 52.2"), std::string::npos) << refusal;
  // Nodes on land are null, because the data have no value there.
  EXPECT_EQ(count_of_values(values(get(currents + "cube?bbox=-6.6,52,-6,53" + at_noon))), 0);
}

TEST_F(EdrShapesTest, NodesAcrossTheAntimeridianAscendBeyond180) {
  store({.x = nodes_from(178.0, 0.5, 9), .y = nodes_from(60.0, 0.5, 5), .depths_m = {0.0, 50.0, 200.0}});
  const json cube = get(currents + "cube?bbox=179,60,0,-179,61,60&datetime=2026-11-20T12:00:00Z");
  EXPECT_EQ(axis(cube, "x"), json::array({179.0, 179.5, 180.0, 180.5, 181.0}));
  EXPECT_EQ(axis(cube, "y"), json::array({60.0, 60.5, 61.0}));
  EXPECT_EQ(axis(cube, "z"), json::array({0.0, 50.0}));
  EXPECT_EQ(count_of_values(values(cube)), 30);
  const json area = get(
      currents + "area?coords=POLYGON((179.4+60.4,-179.4+60.4,-179.4+61.1,179.4+61.1,179.4+60.4))" + at_noon);
  EXPECT_EQ(axis(area, "x"), json::array({179.5, 180.0, 180.5}));
  EXPECT_EQ(count_of_values(values(area)), 6);
}

TEST_F(EdrShapesTest, APolygonRoundTheGlobeHoldsEveryNode) {
  store({.x = nodes_from(0.0, 30.0, 12), .y = nodes_from(-60.0, 30.0, 5)});
  const json globe =
      get(currents + "area?coords=POLYGON((-180+-90,180+-90,180+90,-180+90,-180+-90))" + at_noon);
  EXPECT_EQ(axis(globe, "x").front(), -180.0);
  EXPECT_EQ(count_of_values(values(globe)), 60);
}

TEST_F(EdrShapesTest, WhatIsTooMuchIsThinnedByWholeStepsAndSaysSo) {
  Model model{.x = nodes_from(-40.0, 0.01, 800), .y = nodes_from(50.0, 0.01, 700)};
  model.u_m_s = [](std::size_t ix, std::size_t iy) { return static_cast<double>((ix * 7 + iy * 3) % 1000); };
  store(model);
  const json cube =
      get(currents + "cube?bbox=-41,49,-30,60&parameter-name=" + east_name + at_noon);  // 560,000 nodes
  ASSERT_EQ(axis(cube, "x").size(), 400U);
  ASSERT_EQ(axis(cube, "y").size(), 350U);
  EXPECT_NE(cube.at("source").at("sampling").get<std::string>().find("one node of the data in 2"),
            std::string::npos);
  const json x = axis(cube, "x");
  const json y = axis(cube, "y");
  const json found = values(cube);
  for (std::size_t index = 0; index < 400U * 350U; index += 977) {
    const auto ix = std::lround((x.at(index % 400).get<double>() + 40.0) / 0.01);
    const auto iy = std::lround((y.at(index / 400).get<double>() - 50.0) / 0.01);
    ASSERT_EQ(found.at(index), static_cast<double>((ix * 7 + iy * 3) % 1000));
  }
}

TEST_F(EdrShapesTest, TheDepthsOfABoxOfSixNumbersAreObeyed) {
  Model model = half_degrees();
  model.depths_m = {0.0, 50.0, 200.0};
  store(model);
  const auto depths = [&](const std::string& query) {
    return axis(get(currents + "cube?" + query + "&datetime=2026-11-20T12:00:00Z"), "z");
  };
  EXPECT_EQ(depths("bbox=-8,52,0,-7,53,50"), json::array({0.0, 50.0}));
  EXPECT_EQ(depths("bbox=-8,52,-7,53&z=0/50"), json::array({0.0, 50.0}));
  EXPECT_EQ(depths("bbox=-8,52,-7,53"), json::array({0.0, 50.0, 200.0}));
  EXPECT_EQ(depths("bbox=-8,52,100,-7,53,100"), json::array({100.0})) << "one depth is interpolated";
  EXPECT_NE(get(currents + "cube?bbox=-8,52,0,-7,53" + at_noon, 400).dump().find("or six"),
            std::string::npos);
  EXPECT_NE(ask("GET", "/collections/nogo-zones/items?bbox=-8,52,0,-7,53,50").body.find("are not searched"),
            std::string::npos);
  for (const std::string query :
       {"cube?bbox=-8,52,-50,-7,53,0", "cube?bbox=-8,52,50,-7,53,0", "cube?bbox=-8,52,0,-7,53,50&z=0",
        "cube?bbox=-8,52,-7,53&z=-5", "position?coords=POINT+Z(-7.5+52.5+-5)",
        "area?coords=POLYGON+Z((-8+52+5,-7+52+5,-7+53+5,-8+52+5))",
        "trajectory?coords=LINESTRING(-8+52,-7+53)&z=0/50"})
    get(currents + query, 400);
  Model surface = half_degrees();
  surface.id = "currents-11111111";
  surface.depths_m = {};
  store(surface);
  const json nothing = get(currents + "cube?bbox=-8,52,60,-7,53,150", 404);
  EXPECT_NE(nothing.at("detail").get<std::string>().find("0 m to 200 m"), std::string::npos) << nothing;
  EXPECT_EQ(axis(get(currents + "radius?coords=POINT+Z(-7.5+52.5+50)&within=20"), "z"), json::array({50.0}));
}

TEST_F(EdrShapesTest, FeaturesAndDataWithoutDepthsTakeFourNumbers) {
  for (const std::string target :
       {"/collections/icebergs/items?bbox=-8,52,0,-7,53,50",
        "/edr/collections/bathymetry/cube?bbox=-8,52,0,-7,53,50", "/map/coast?bbox=-8,52,0,-7,53,50"})
    EXPECT_EQ(get(target, 400).at("errors").at(0).at("pointer"), "?bbox") << target;
}

TEST_F(EdrShapesTest, LatitudeFirstIsRefusedByName) {
  store(half_degrees());
  for (const std::string crs : {"EPSG:4326", "http://www.opengis.net/def/crs/EPSG/0/4326", "EPSG:3857"})
    get(currents + "position?coords=POINT(52.25+-7.25)&crs=" + crs, 400);
  for (const std::string crs :
       {"CRS84", "CRS:84", "OGC:CRS84", "http://www.opengis.net/def/crs/OGC/1.3/CRS84"})
    get(currents + "position?coords=POINT(-7.25+52.25)&crs=" + crs);
}

TEST_F(EdrShapesTest, OnlyCoveragesAreGiven) {
  store(half_degrees());
  const std::string position = currents + "position?coords=POINT(-7.25+52.25)&f=";
  for (const char* format : {"CoverageJSON", "coveragejson", "json", "application/vnd.cov%2Bjson"})
    get(position + format);
  for (const char* format : {"GeoJSON", "geojson", "html", "netcdf"}) {
    const json refusal = get(position + format, 400);
    EXPECT_NE(refusal.dump().find("CoverageJSON"), std::string::npos) << refusal;
  }
  EXPECT_NE(get("/collections?f=xml", 400).dump().find("CoverageJSON"), std::string::npos);
}

TEST_F(EdrShapesTest, TheExtentIsOfAllDatasetsAndEachAnswersWhereItIs) {
  Model west = half_degrees();
  west.depths_m = {0.0, 100.0};
  Model pacific{.id = "currents-11111111",
                .x = nodes_from(170.0, 5.0, 5),
                .y = nodes_from(60.0, 5.0, 3),
                .depths_m = {0.0, 300.0},
                .times_s = {noon_s + 864'000.0, noon_s + 867'600.0},
                .ingested_s = 1.1e9};
  store(pacific);
  const auto extent = [&] { return get("/edr/collections/currents").at("extent"); };
  EXPECT_EQ(extent().at("spatial").at("bbox"), json::parse("[[170.0,60.0,-170.0,70.0]]"));
  store(west);
  EXPECT_EQ(extent().at("spatial").at("bbox"),
            json::parse("[[170.0,50.0,-5.0,70.0],[170.0,60.0,-170.0,70.0],[-10.0,50.0,-5.0,55.0]]"));
  EXPECT_EQ(extent().at("temporal").at("interval"),
            json::parse(R"([["2026-11-20T12:00:00Z","2026-11-30T13:00:00Z"],
                            ["2026-11-20T12:00:00Z","2026-11-20T12:00:00Z"],
                            ["2026-11-30T12:00:00Z","2026-11-30T13:00:00Z"]])"));
  EXPECT_EQ(extent().at("vertical").at("interval"), json::parse("[[0.0,300.0]]"));
  EXPECT_EQ(extent().at("vertical").at("values"), json::parse("[0.0,100.0,300.0]"));
  get(currents + "position?coords=POINT(-7.25+52.25)");
  get(currents + "position?coords=POINT(-175+62)");
}

TEST_F(EdrShapesTest, WhereTheNewestDatasetHasAGapAnOlderOneAnswers) {
  Model older = half_degrees();
  Model newer = half_degrees();
  newer.id = "currents-11111111";
  newer.ingested_s = 1.1e9;
  newer.u_m_s = [](std::size_t ix, std::size_t) { return ix < 5 ? 0.7 : NAN; };
  store(older);
  store(newer);
  EXPECT_EQ(at_position(-9.0, 52.0), 0.7);
  EXPECT_EQ(at_position(-6.0, 52.0), 0.3);
  const json gap = get(currents + "cube?bbox=-6.1,52,-5.9,52" + at_noon);
  EXPECT_EQ(values(gap), json::array({0.3}));
  EXPECT_EQ(gap.at("source").at("dataset_id"), "currents-00000000");
  const json way = get(currents + "trajectory?coords=LINESTRING(-9+52,-6+52)" + at_noon);
  EXPECT_EQ(values(way), json::array({0.7, 0.3}));
}

TEST_F(EdrShapesTest, RunsOfOneModelAreJoinedInAPeriodThatIsAskedFor) {
  Model older = half_degrees();
  older.times_s = {noon_s, noon_s + 3600.0, noon_s + 7200.0, noon_s + 10800.0, noon_s + 36000.0};
  Model newer = half_degrees();
  newer.id = "currents-11111111";
  newer.ingested_s = 1.1e9;
  newer.times_s = {noon_s + 3600.0, noon_s + 7200.0};
  newer.u_m_s = [](auto...) { return 0.7; };
  Model another{.id = "currents-22222222", .x = {-10.0, -5.0}, .y = {50.0, 55.0}, .ingested_s = 0.9e9};
  another.times_s = {noon_s - 3600.0};
  store(older);
  store(newer);
  store(another);
  const std::string day = "&z=0&datetime=2026-11-20T11:00:00Z/2026-11-20T15:00:00Z";
  const json series = get(currents + "position?coords=POINT(-7+52)" + day);
  EXPECT_EQ(axis(series, "t"), json::array({"2026-11-20T12:00:00Z", "2026-11-20T13:00:00Z",
                                            "2026-11-20T14:00:00Z", "2026-11-20T15:00:00Z"}));
  EXPECT_EQ(values(series), json::array({0.3, 0.7, 0.7, 0.3}));
  EXPECT_EQ(series.at("source").at("further_dataset_ids"), json::array({"currents-00000000"}));
  const json cube = get(currents + "cube?bbox=-7,52,-6.5,52" + day);
  EXPECT_EQ(values(cube), json::array({0.3, 0.3, 0.7, 0.7, 0.7, 0.7, 0.3, 0.3}));
  EXPECT_EQ(axis(get(currents + "position?coords=POINT(-7+52)&z=0"), "t").size(), 2U) << "of the newest run";
}

TEST_F(EdrShapesTest, APeriodBetweenStepsIsRefusedWithTheSteps) {
  Model model = half_degrees();
  model.times_s = {noon_s, noon_s + 3600.0};
  store(model);
  const json refusal =
      get(currents + "position?coords=POINT(-7+52)&datetime=2026-11-20T12:10:00Z/2026-11-20T12:50:00Z", 404);
  EXPECT_NE(refusal.at("detail").get<std::string>().find("2026-11-20T13:00:00Z"), std::string::npos);
}

/// A shape inside the data: its query without depth and time, and whether a place is inside by a margin
/// (positive), outside by a margin (negative) or too close to the edge to decide (0). The test computes this
/// independently of the server.
struct Shape {
  std::string query;
  std::function<int(double lon_deg, double lat_deg)> side;
};

std::string text_of(double value) {
  std::ostringstream text;
  text.precision(12);
  text << value;
  return text.str();
}

double wrapped(double lon_deg) { return lon_deg - 360.0 * std::floor((lon_deg + 180.0) / 360.0); }

Shape random_cube(std::mt19937_64& rng, double west, double south, double width, double height) {
  const double x0 = west + uniform(rng, 0.0, 0.9) * width;
  const double y0 = south + uniform(rng, 0.0, 0.9) * height;
  const double x1 = x0 + uniform(rng, 0.01, 1.0) * (west + width - x0);
  const double y1 = y0 + uniform(rng, 0.01, 1.0) * (south + height - y0);
  return {"cube?bbox=" + text_of(wrapped(x0)) + "," + text_of(y0) + "," + text_of(wrapped(x1)) + "," +
              text_of(y1),
          [=](double lon, double lat) {
            const double room = std::min({lon - x0, x1 - lon, lat - y0, y1 - lat});
            return room > 1e-4 ? 1 : room < -1e-4 ? -1 : 0;
          }};
}

Shape random_triangle(std::mt19937_64& rng, double west, double south, double width, double height) {
  std::array<double, 3> x{};
  std::array<double, 3> y{};
  double twice_area = 0.0;
  while (std::abs(twice_area) < 1e-3 * width * height) {
    for (std::size_t i = 0; i < 3; ++i) {
      x[i] = west + uniform(rng, 0.0, 1.0) * width;
      y[i] = south + uniform(rng, 0.0, 1.0) * height;
    }
    twice_area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
  }
  std::string query = "area?coords=POLYGON((";
  for (const std::size_t i : {0U, 1U, 2U, 0U})
    query += (query.back() == '(' ? "" : ",") + text_of(wrapped(x[i])) + "+" + text_of(y[i]);
  const double turn = twice_area > 0.0 ? 1.0 : -1.0;
  return {query + "))", [=](double lon, double lat) {
            double room = INFINITY;
            for (std::size_t i = 0; i < 3; ++i) {
              const std::size_t k = (i + 1) % 3;
              const double side = (x[k] - x[i]) * (lat - y[i]) - (lon - x[i]) * (y[k] - y[i]);
              room = std::min(room, turn * side / std::hypot(x[k] - x[i], y[k] - y[i]));
            }
            return room > 1e-4 ? 1 : room < -1e-4 ? -1 : 0;
          }};
}

/// A disc in the middle of the data. The haversine formula decides on which side of its rim a place lies; it
/// is within 0.6 % of the ellipsoid.
Shape random_disc(std::mt19937_64& rng, double west, double south, double width, double height) {
  const double lon0 = west + uniform(rng, 0.3, 0.7) * width;
  const double lat0 = south + uniform(rng, 0.3, 0.7) * height;
  const double radians = std::acos(-1.0) / 180.0;
  const double room_deg = std::min(width * std::cos((std::abs(lat0) + height) * radians), height) * 0.25;
  const double radius_km = uniform(rng, 0.02, 1.0) * std::max(room_deg, 0.001) * 111.0;
  return {"radius?coords=POINT(" + text_of(wrapped(lon0)) + "+" + text_of(lat0) +
              ")&within=" + text_of(radius_km) + "&within-units=km",
          [=](double lon, double lat) {
            const double a = std::pow(std::sin((lat - lat0) * radians / 2.0), 2.0) +
                             std::cos(lat * radians) * std::cos(lat0 * radians) *
                                 std::pow(std::sin((lon - lon0) * radians / 2.0), 2.0);
            const double km = 2.0 * 6371.0 * std::asin(std::sqrt(a));
            return km < 0.99 * radius_km ? 1 : km > 1.01 * radius_km ? -1 : 0;
          }};
}

TEST_F(EdrShapesTest, AShapeInTheDataHasAValueAndEveryNodeInItItsOwn) {
  for_each_seed(150, [&](std::mt19937_64& rng) {
    const double dx = uniform(rng, 0.05, 2.0);
    const double dy = uniform(rng, 0.05, 2.0);
    const double west = uniform(rng, -180.0, 340.0);  // also longitudes from 0 to 360, and across both seams
    Model model{.x = nodes_from(west, dx, uniform_int(rng, 2, 12)),
                .y = nodes_from(uniform(rng, -75.0, 50.0), dy, uniform_int(rng, 2, 12))};
    model.u_m_s = [](std::size_t ix, std::size_t iy) {
      return 0.01 * static_cast<double>(ix) + 0.5 * static_cast<double>(iy) +
             0.001 * static_cast<double>(ix * iy % 7);
    };
    store(model);
    const double width = model.x.back() - west;
    const double height = model.y.back() - model.y.front();
    const int kind = uniform_int(rng, 0, 2);
    const Shape shape = (kind == 0   ? random_cube
                         : kind == 1 ? random_triangle
                                     : random_disc)(rng, west, model.y.front(), width, height);

    const json coverage = get(currents + shape.query + at_noon);
    ASSERT_TRUE(coverage.contains("ranges"));
    std::map<std::pair<std::size_t, std::size_t>, double> at_nodes;
    int known = 0;
    std::size_t index = 0;
    for (const json& lat : axis(coverage, "y")) {
      for (const json& lon : axis(coverage, "x")) {
        const json value = values(coverage).at(index++);
        if (value.is_null()) continue;
        ++known;
        if (known <= 5) {
          const auto there = at_position(wrapped(lon.get<double>()), lat.get<double>());
          ASSERT_TRUE(there);
          EXPECT_NEAR(value.get<double>(), *there, 1.5e-4);
        }
        const double turns = std::round((lon.get<double>() - west - width / 2.0) / 360.0);
        const double ix = (lon.get<double>() - 360.0 * turns - west) / dx;
        const double iy = (lat.get<double>() - model.y.front()) / dy;
        EXPECT_GE(shape.side(west + ix * dx, lat.get<double>()), 0) << shape.query;
        if (std::abs(ix - std::round(ix)) > 1e-6 || std::abs(iy - std::round(iy)) > 1e-6) continue;
        at_nodes[{std::lround(ix), std::lround(iy)}] = value.get<double>();
      }
    }
    EXPECT_GE(known, 1) << shape.query;
    for (std::size_t iy = 0; iy < model.y.size(); ++iy) {
      for (std::size_t ix = 0; ix < model.x.size(); ++ix) {
        if (shape.side(model.x[ix], model.y[iy]) <= 0) continue;
        ASSERT_TRUE(at_nodes.contains({ix, iy})) << shape.query << " node " << ix << ' ' << iy;
        EXPECT_NEAR((at_nodes.at({ix, iy})), model.u_m_s(ix, iy), 1e-4);
      }
    }
    remove(model.id);
  });
}

TEST_F(EdrShapesTest, DataOnAPolarGridAnswerEveryShapeInThem) {
  Model model{.frame = geo::PolarStereographicFrame{.north = true, .lat_ts_deg = 70.0, .lon_0_deg = -45.0},
              .x = nodes_from(-500'000.0, 25'000.0, 41),
              .y = nodes_from(-2'700'000.0, 25'000.0, 41)};
  model.u_m_s = [](std::size_t ix, std::size_t iy) { return 0.01 * static_cast<double>(ix + 2 * iy); };
  store(model);
  for_each_seed(60, [&](std::mt19937_64& rng) {
    // Inside by a good margin: the grid reaches from 65 N to 75 N and further than 4 degrees to both sides.
    const Shape shape = (uniform_int(rng, 0, 1) == 0 ? random_triangle : random_disc)(
        rng, -48.0, 67.5, 6.0, 5.0 * uniform(rng, 0.01, 1.0));
    const json coverage = get(currents + shape.query + at_noon);
    ASSERT_TRUE(coverage.contains("ranges"));
    EXPECT_GE(count_of_values(values(coverage)), 1) << shape.query;
    std::size_t index = 0;
    for (const json& lat : axis(coverage, "y")) {
      for (const json& lon : axis(coverage, "x")) {
        const json value = values(coverage).at(index++);
        if (value.is_null() || index % 7 != 1) continue;
        EXPECT_NEAR(value.get<double>(), at_position(lon, lat).value_or(NAN), 1.5e-4);
      }
    }
  });
}

TEST_F(EdrShapesTest, TheDatasetThatHoldsMostOfAShapeAnswersIt) {
  store(half_degrees());
  Model harbour{.id = "currents-11111111", .x = nodes_from(-7.0, 0.05, 5), .y = nodes_from(52.0, 0.05, 5)};
  harbour.ingested_s = 2e9;
  harbour.u_m_s = [](auto...) { return 1.5; };
  store(harbour);
  const auto source = [&](const std::string& bbox) {
    return get(currents + "cube?bbox=" + bbox + at_noon).at("source").at("dataset_id");
  };

  EXPECT_EQ(source("-11,51,-6,53"), "currents-00000000") << "none holds the whole box";
  EXPECT_EQ(source("-6.95,52.05,-6.85,52.15"), "currents-11111111") << "both hold it: the newer one";
  EXPECT_EQ(source("-9,51,-6,53"), "currents-00000000") << "the larger one alone holds it";
}

TEST_F(EdrShapesTest, ATrajectoryNamesTheDatasetsThatAnsweredIt) {
  store(half_degrees());
  Model harbour{.id = "currents-11111111", .x = nodes_from(-7.0, 0.05, 5), .y = nodes_from(52.0, 0.05, 5)};
  harbour.ingested_s = 2e9;
  store(harbour);
  const auto source = [&](const std::string& line) {
    return get(currents + "trajectory?coords=LINESTRING(" + line + ")" + at_noon).at("source");
  };

  const json both = source("-6.9+52.1,-8+53");
  EXPECT_EQ(both.at("dataset_id"), "currents-11111111");
  EXPECT_EQ(both.at("further_dataset_ids"), json::array({"currents-00000000"}));
  EXPECT_FALSE(source("-6.9+52.1,-6.85+52.1").contains("further_dataset_ids"));
}

TEST_F(EdrShapesTest, DepthsOfTheSeaBedAreThoseOfTheNodes) {
  repository::Dataset dataset;
  dataset.id = {"bathymetry-00000000"};
  dataset.kind = repository::DatasetKind::bathymetry;
  dataset.bounds = {-8.0, 52.0, -7.0, 53.0};
  repository::DatasetRepository{db_}.insert(dataset);
  repository::FieldRepository fields{db_};
  fields.create(dataset.id, {{geo::GeographicFrame{}, ocean::Axis{nodes_from(-8.0, 0.1, 11)},
                              ocean::Axis{nodes_from(52.0, 0.1, 11)}},
                             {},
                             {}});
  std::vector<float> depths_m;
  for (int i = 0; i < 121; ++i) depths_m.push_back(static_cast<float>(100 + i));
  fields.write_slice(dataset.id, "depth_m", 0, 0, depths_m);

  // A coarser chart of the world that was ingested later is not used here.
  dataset.id = {"bathymetry-11111111"};
  dataset.bounds = {-180.0, -90.0, 180.0, 90.0};
  dataset.provenance = {.file_name = {},
                        .file_size_bytes = 0,
                        .sha256 = "1",
                        .ingested = core::from_unix_seconds(2e9),
                        .tool_version = {}};
  repository::DatasetRepository{db_}.insert(dataset);
  fields.create(dataset.id, {{geo::GeographicFrame{}, ocean::Axis{nodes_from(-180.0, 30.0, 13)},
                              ocean::Axis{nodes_from(-90.0, 30.0, 7)}},
                             {},
                             {}});
  fields.write_slice(dataset.id, "depth_m", 0, 0, std::vector<float>(91, 4000.0F));

  const std::string radius = "/edr/collections/bathymetry/radius?coords=POINT(-7.5+52.5)&within=5";
  const json disc = get(radius);
  EXPECT_EQ(disc.at("ranges").at("sea_floor_depth_below_mean_sea_level").at("values"), json::array({160.0}));
  const json world = get("/edr/collections/bathymetry/cube?bbox=-60,0,60,60");
  EXPECT_EQ(world.at("source").at("dataset_id"), "bathymetry-11111111") << "it alone holds the whole box";
}

/// A chart so fine that the answer for a large shape uses only every n-th node of it.
TEST_F(EdrShapesTest, AFineChartIsThinnedToItsOwnNodes) {
  repository::Dataset dataset;
  dataset.id = {"bathymetry-00000000"};
  dataset.kind = repository::DatasetKind::bathymetry;
  dataset.bounds = {-8.0, 52.0, -5.601, 53.899};
  repository::DatasetRepository{db_}.insert(dataset);
  repository::FieldRepository fields{db_};
  fields.create(dataset.id, {{geo::GeographicFrame{}, ocean::Axis{nodes_from(-8.0, 0.001, 2400)},
                              ocean::Axis{nodes_from(52.0, 0.001, 1900)}},
                             {},
                             {}});
  const auto depth_m = [](std::int64_t ix, std::int64_t iy) {
    return static_cast<double>((ix * 7 + iy * 3) % 1000);
  };
  std::vector<float> depths_m;
  for (int iy = 0; iy < 1900; ++iy)
    for (int ix = 0; ix < 2400; ++ix) depths_m.push_back(static_cast<float>(depth_m(ix, iy)));
  fields.write_slice(dataset.id, "depth_m", 0, 0, depths_m);
  repository::FieldOverviews{db_}.make(dataset.id, "depth_m");

  const json cube = get("/edr/collections/bathymetry/cube?bbox=-9,51,0,60");
  EXPECT_NE(cube.at("source").at("sampling").get<std::string>().find("one node of the data in 4"),
            std::string::npos)
      << cube.at("source");
  const json depths = cube.at("ranges").at("sea_floor_depth_below_mean_sea_level").at("values");
  const json x = axis(cube, "x");
  const json y = axis(cube, "y");
  const std::size_t columns = x.size();
  for (std::size_t index = 0; index < depths.size(); index += 991) {
    const auto ix = std::lround((x.at(index % columns).get<double>() + 8.0) / 0.001);
    const auto iy = std::lround((y.at(index / columns).get<double>() - 52.0) / 0.001);
    ASSERT_EQ(depths.at(index), depth_m(ix, iy));
  }
  const json sliver = get("/edr/collections/bathymetry/radius?coords=POINT(-7.2345+52.3)&within=0.01");
  EXPECT_EQ(sliver.at("ranges").at("sea_floor_depth_below_mean_sea_level").at("values").size(), 1U);
}

}  // namespace
}  // namespace floeplan::routes::edr_shapes_test
