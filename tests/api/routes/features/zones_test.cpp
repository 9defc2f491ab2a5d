#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/features/zone_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "tests/api/routes/api_fixture.hpp"

namespace floeplan::routes::zones_test {
namespace {

using nlohmann::json;
using support::json_of;

/// A store with a zone of one day and two steps of wind over the same square.
class ZoneRoutesTest : public support::ApiTest {
 protected:
  ZoneRoutesTest() {
    repository::Dataset dataset{.id = {"zones-1"},
                                .kind = repository::DatasetKind::zones,
                                .name = "exercises",
                                .variables = {"no_go"},
                                .bounds = {-54.0, 68.0, -52.0, 70.0},
                                .time_start = {},
                                .time_end = {},
                                .rows_accepted = 1,
                                .rows_refused = 0,
                                .warnings = {},
                                .provenance = {}};
    repository::DatasetRepository{db_}.insert(dataset);
    ocean::Zone zone;
    zone.name = "gunnery";
    zone.area.outer = {{-54.0, 68.0}, {-52.0, 68.0}, {-52.0, 70.0}, {-54.0, 70.0}};
    zone.from = core::from_unix_seconds(1.8e9);
    zone.until = core::from_unix_seconds(1.8e9 + 86'400.0);
    zone.bottom = {100.0};
    repository::ZoneRepository{db_}.insert({"zones-1"}, {zone});

    const ocean::Axis times{{1.8e9, 1.8e9 + 3600.0}};
    dataset.id = {"wind-1"};
    dataset.kind = repository::DatasetKind::wind;
    dataset.time_start = core::from_unix_seconds(times.front());
    dataset.time_end = core::from_unix_seconds(times.back());
    repository::DatasetRepository{db_}.insert(dataset);
    repository::FieldRepository fields{db_};
    fields.create(
        {"wind-1"},
        {{geo::GeographicFrame{}, ocean::Axis{{-54.0, -52.0}}, ocean::Axis{{68.0, 70.0}}}, {}, times});
    for (std::size_t step = 0; step < 2; ++step) {
      fields.write_slice({"wind-1"}, "u_m_s", step, 0, std::vector<float>(4, 8.0F));
      fields.write_slice({"wind-1"}, "v_m_s", step, 0, std::vector<float>(4, -6.0F));
    }
  }
};

TEST_F(ZoneRoutesTest, AProbeTellsTheZonesOfThePlaceAndWhetherTheyAreInForce) {
  const json now = json_of(ask("GET", "/probe?lon=-53&lat=69&time=2027-01-15T20:00:00Z"));
  const json later = json_of(ask("GET", "/probe?lon=-53&lat=69&time=2027-01-18T00:00:00Z"));
  const json beside = json_of(ask("GET", "/probe?lon=-51&lat=69&time=2027-01-15T20:00:00Z"));

  ASSERT_EQ(now["zones"].size(), 1U);
  EXPECT_EQ(now["zones"][0]["name"], "gunnery");
  EXPECT_EQ(now["zones"][0]["kind"], "no_go");
  EXPECT_EQ(now["zones"][0]["from"], "2027-01-15T08:00:00Z");
  EXPECT_EQ(now["zones"][0]["bottom_m"], 100.0);
  EXPECT_EQ(now["zones"][0]["in_force"], true);
  EXPECT_EQ(now["zones"][0]["dataset_id"], "zones-1");
  EXPECT_EQ(later["zones"][0]["in_force"], false);
  EXPECT_TRUE(beside["zones"].empty());
}

TEST_F(ZoneRoutesTest, AProbeTellsTheWind) {
  const json probe = json_of(ask("GET", "/probe?lon=-53&lat=69&time=2027-01-15T08:30:00Z&depth_m=50"));
  const json later = json_of(ask("GET", "/probe?lon=-53&lat=69&time=2027-01-18T00:00:00Z"));

  EXPECT_NEAR(probe["wind"]["u_m_s"], 8.0, 1e-6);
  EXPECT_NEAR(probe["wind"]["v_m_s"], -6.0, 1e-6);
  EXPECT_EQ(probe["wind"]["dataset_id"], "wind-1");
  EXPECT_TRUE(later["wind"]["u_m_s"].is_null());
  EXPECT_THAT(later["wind"]["reason"], testing::HasSubstr("outside the period"));
}

TEST_F(ZoneRoutesTest, APlanNamesOnlyZonesAndWindThatAreStored) {
  const auto plan = [&](const std::string& more) {
    return ask(
        "POST", "/processes/plan-route/execution",
        R"({"inputs":{"from":[-53,69],"to":[-52.5,69],"depart":"2027-01-15T20:00:00Z",)" + more + "}}");
  };

  EXPECT_TRUE(plan(R"("zones":["zones-1"],"wind":"wind-1")").wait);
  EXPECT_TRUE(plan(R"("zones":"all","wind":"newest")").wait);
  EXPECT_TRUE(plan(R"("zones":"none","wind":"none")").wait);
  const json unknown = json_of(plan(R"("zones":"zones-9","wind":"zones-1")"));
  ASSERT_EQ(unknown["errors"].size(), 2U) << unknown;
  EXPECT_EQ(unknown["errors"][0]["pointer"], "/inputs/wind");
  EXPECT_EQ(unknown["errors"][1]["pointer"], "/inputs/zones");
  EXPECT_EQ(plan(R"("zones":7)").status, 400);
}

}  // namespace
}  // namespace floeplan::routes::zones_test
