#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/features/ice_chart_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "tests/api/routes/api_fixture.hpp"

namespace floeplan::routes::ice_test {
namespace {

using nlohmann::json;
using support::json_of;

/// A store with two days of ice that thickens from a fifth to three fifths.
class IceRoutesTest : public support::ApiTest {
 protected:
  IceRoutesTest() { add_ice("ice-1", 1.8e9, 1.8e9 + 86400.0, {0.2F, 0.6F}); }

  /// Two steps, ingested after those before.
  void add_ice(const std::string& id, double first_s, double second_s, std::array<float, 2> concentration) {
    repository::Provenance provenance;
    provenance.ingested = core::from_unix_seconds(1.8e9 + added_++);
    repository::DatasetRepository{db_}.insert({.id = {id},
                                               .kind = repository::DatasetKind::ice,
                                               .name = "ice of the strait",
                                               .variables = {"siconc", "sithick"},
                                               .bounds = {-54.0, 68.0, -52.0, 70.0},
                                               .time_start = core::from_unix_seconds(first_s),
                                               .time_end = core::from_unix_seconds(second_s),
                                               .rows_accepted = 4,
                                               .rows_refused = 0,
                                               .warnings = {},
                                               .provenance = provenance});
    repository::FieldRepository fields{db_};
    fields.create({id}, {{geo::GeographicFrame{}, ocean::Axis{{-54.0, -52.0}}, ocean::Axis{{68.0, 70.0}}},
                         {},
                         ocean::Axis{{first_s, second_s}}});
    for (std::size_t step = 0; step < 2; ++step) {
      fields.write_slice({id}, "concentration", step, 0, std::vector<float>(4, concentration[step]));
      fields.write_slice({id}, "thickness_m", step, 0, std::vector<float>(4, 1.5F));
    }
  }

 private:
  int added_{0};
};

TEST_F(IceRoutesTest, AProbeInALongGapTellsWhatOthersKnowOrNothing) {
  add_ice("gap", 1.8e9 - 10.0 * 86400.0, 1.8e9 + 10.0 * 86400.0, {0.0F, 0.0F});

  const json known = json_of(ask("GET", "/probe?lon=-53&lat=69&time=2027-01-15T20:00:00Z"));
  EXPECT_EQ(known["ice"]["dataset_id"], "ice-1");
  EXPECT_NEAR(known["ice_concentration"], 0.4, 1e-6);

  const json unknown = json_of(ask("GET", "/probe?lon=-53&lat=69&time=2027-01-20T20:00:00Z"));
  EXPECT_TRUE(unknown["ice_concentration"].is_null());
  EXPECT_THAT(unknown["ice_concentration_reason"], testing::HasSubstr("a gap of the data"));
}

TEST_F(IceRoutesTest, AProbeTellsConcentrationAndThicknessBetweenTwoSteps) {
  const auto response = ask("GET", "/probe?lon=-53&lat=69&time=2027-01-15T20:00:00Z");

  ASSERT_EQ(response.status, 200) << response.body;
  const json document = json_of(response);
  EXPECT_NEAR(document["ice_concentration"], 0.4, 1e-6);
  EXPECT_TRUE(document["ice_concentration_reason"].is_null());
  EXPECT_NEAR(document["ice"]["thickness_m"], 1.5, 1e-6);
  EXPECT_EQ(document["ice"]["dataset_id"], "ice-1");
  EXPECT_EQ(document["ice"]["time_before"], "2027-01-15T08:00:00Z");
  EXPECT_EQ(document["ice"]["time_after"], "2027-01-16T08:00:00Z");
}

TEST_F(IceRoutesTest, AProbeBeyondAreaOrPeriodHasAReasonAndNoValue) {
  const json later = json_of(ask("GET", "/probe?lon=-53&lat=69&time=2027-01-20T00:00:00Z&dataset=ice-1"));
  EXPECT_TRUE(later["ice_concentration"].is_null());
  EXPECT_THAT(later["ice_concentration_reason"], testing::HasSubstr("outside the period"));

  const json elsewhere = json_of(ask("GET", "/probe?lon=10&lat=69&time=2027-01-15T20:00:00Z"));
  EXPECT_TRUE(elsewhere["ice_concentration"].is_null());
  EXPECT_THAT(elsewhere["ice_concentration_reason"], testing::HasSubstr("no ice data"));
}

TEST_F(IceRoutesTest, AProbeHoldsTheLastStepAsPlansDo) {
  const json later = json_of(ask("GET", "/probe?lon=-53&lat=69&time=2027-01-18T00:00:00Z"));
  EXPECT_NEAR(later["ice_concentration"], 0.6, 1e-6);
  EXPECT_EQ(later["ice"]["time_before"], "2027-01-16T08:00:00Z");
  EXPECT_EQ(later["ice"]["time_after"], "2027-01-16T08:00:00Z");
}

/// The values of a grid of the map, all variables one after the other.
std::vector<int> values_of(const std::string& grid) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(grid.at(i)); };
  const std::size_t start = 4U + byte(0) + 256U * byte(1);
  std::vector<int> values;
  for (std::size_t i = start; i + 1 < grid.size(); i += 2)
    values.push_back(static_cast<std::int16_t>(byte(i) | byte(i + 1) << 8U));
  return values;
}

TEST_F(IceRoutesTest, TheMapShowsConcentrationAndThicknessBetweenTwoSteps) {
  const auto response = ask("GET", "/map/sea-ice?bbox=-54,68,-52,70&nx=2&ny=2&time=2027-01-15T20:00:00Z");

  ASSERT_EQ(response.status, 200) << response.body;
  EXPECT_THAT(response.body, testing::HasSubstr(R"("variables":["concentration","thickness_m"])"));
  EXPECT_THAT(response.body, testing::HasSubstr(R"("scale":[0.0001,0.04])"));
  EXPECT_THAT(values_of(response.body), testing::ElementsAre(4000, 4000, 4000, 4000, 38, 38, 38, 38));
}

TEST_F(IceRoutesTest, TheMapHasNoIceBesideTheDataAndNoAnswerAfterTheirEnd) {
  const auto beside = ask("GET", "/map/sea-ice?bbox=-54,68,-50,70&nx=2&ny=2&time=2027-01-15T08:00:00Z");
  EXPECT_THAT(values_of(beside.body),
              testing::ElementsAre(2000, -32768, 2000, -32768, 38, -32768, 38, -32768));

  const auto later = ask("GET", "/map/sea-ice?bbox=-54,68,-52,70&nx=2&ny=2&time=2027-01-16T09:00:00Z");
  EXPECT_EQ(later.status, 404);
  EXPECT_THAT(later.body, testing::HasSubstr("No ice data cover this area and time"));
}

TEST_F(IceRoutesTest, TheMapShowsThePolygonsOfAChartWithTheirEggs) {
  const auto rectangle = [](double west, double east) {
    geo::Ring ring;
    for (double lon_deg = west; lon_deg < east; lon_deg += 0.001) ring.push_back({lon_deg, 68.5});
    for (double lon_deg = east; lon_deg > west; lon_deg -= 0.001) ring.push_back({lon_deg, 69.5});
    return geo::Polygon{ring, {}};
  };
  repository::IceChartRepository{db_}.insert(
      {"ice-1"}, {{{{"CT", "91"}, {"CA", "60"}, {"SA", "87"}, {"FA", "04"}, {"CB", "30"}, {"SB", "84"}},
                   rectangle(-53.5, -53.0)},
                  {{{"CT", "55"}}, rectangle(-53.0, -52.5)},
                  {{{"CT", "92"}}, rectangle(-52.3, -52.2999)}});

  const json chart = json_of(ask("GET", "/map/ice-chart?bbox=-54,68,-52,70&nx=200&dataset=ice-1"));

  EXPECT_EQ(chart["complete"], true);
  EXPECT_EQ(chart["time"], "2027-01-15T08:00:00Z");
  ASSERT_EQ(chart["features"].size(), 2U) << "a polygon narrower than a pixel is not drawn";
  const json egg = chart["features"][0]["properties"];
  EXPECT_EQ(egg["codes"]["SB"], "84");
  EXPECT_EQ(egg["total"], "9 to 10 tenths");
  EXPECT_EQ(egg["parts"],
            json::parse(R"([{"concentration": "6 tenths", "stage": "thin first-year ice, 30 to 70 cm",
      "form": "medium floes, 100 to 500 m"}, {"concentration": "3 tenths", "stage": "grey ice, 10 to 15 cm",
      "form": null}])"));
  EXPECT_EQ(chart["features"][1]["properties"]["total"], "ice free");
  const json ring = chart["features"][0]["geometry"]["coordinates"][0];
  EXPECT_EQ(ring.front(), ring.back());
  EXPECT_LT(ring.size(), 120U) << "one corner a pixel";

  EXPECT_EQ(ask("GET", "/map/ice-chart?bbox=-54,68,-52,70&nx=200&dataset=no").status, 404);
  EXPECT_EQ(ask("GET", "/map/ice-chart?bbox=-54,68,-52,70&nx=200").status, 400);
}

TEST_F(IceRoutesTest, TheMapShowsNoPolygonsOfIceThatIsNoChart) {
  const json chart = json_of(ask("GET", "/map/ice-chart?bbox=-54,68,-52,70&nx=200&dataset=ice-1"));
  EXPECT_EQ(chart["features"], json::array());
}

TEST_F(IceRoutesTest, TheListOfDatasetsNamesItsTimes) {
  const json dataset = json_of(ask("GET", "/datasets/ice-1"));

  EXPECT_EQ(dataset["kind"], "ice");
  EXPECT_EQ(dataset["times"].size(), 2U);
}

TEST_F(IceRoutesTest, AnExecutionNamesEveryFaultOfTheInputsUnderIce) {
  const json inputs{{"inputs",
                     {{"from", {-53.5, 69.0}},
                      {"to", {-52.5, 69.0}},
                      {"depart", "2027-01-15T08:00:00Z"},
                      {"ice", "ice-2"},
                      {"under_ice", {{"escape_plan", "yes"}, {"margin_below_ice_m", -1}}}}}};

  const auto response =
      ask("POST", "/processes/plan-route/execution", inputs.dump(), {{"content-type", "application/json"}});

  EXPECT_EQ(response.status, 400);
  EXPECT_THAT(response.body, testing::AllOf(testing::HasSubstr("/inputs/under_ice/escape_plan"),
                                            testing::HasSubstr("/inputs/under_ice/margin_below_ice_m")));
}

}  // namespace
}  // namespace floeplan::routes::ice_test
