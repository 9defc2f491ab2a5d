#include "api/service/export_sea.hpp"

#include "api/codec/documents/plan_document.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "tests/api/routes/api_fixture.hpp"

namespace floeplan::routes::export_sea_test {
namespace {

using nlohmann::json;
using support::json_of;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr double start_s = 1.8e9;

/// A sea 300 m deep with land in the west, a bank of 45 m at 53 W, and ice east of 52.5 W.
class ExportSeaTest : public support::ApiTest {
 protected:
  ExportSeaTest() {
    const ocean::Axis y{{68.5, 69.5}};
    add("bathymetry-1", repository::DatasetKind::bathymetry);
    repository::FieldRepository fields{db_};
    fields.create(
        {"bathymetry-1"},
        {{geo::GeographicFrame{}, ocean::Axis{{-54.0, -53.8, -53.2, -53.0, -52.8, -52.0}}, y}, {}, {}});
    fields.write_slice({"bathymetry-1"}, "depth_m", 0, 0,
                       std::vector<float>{-50.0F, 300.0F, 300.0F, 45.0F, 300.0F, 300.0F, -50.0F, 300.0F,
                                          300.0F, 45.0F, 300.0F, 300.0F});
    add("ice-1", repository::DatasetKind::ice);
    const ocean::Axis times{{start_s, start_s + 86400.0}};
    fields.create({"ice-1"},
                  {{geo::GeographicFrame{}, ocean::Axis{{-54.0, -52.6, -52.4, -52.0}}, y}, {}, times});
    for (std::size_t day = 0; day < 2; ++day)
      fields.write_slice({"ice-1"}, "concentration", day, 0,
                         std::vector<float>{0.0F, 0.0F, 0.9F, 0.9F, 0.0F, 0.0F, 0.9F, 0.9F});
  }

  void add(const std::string& id, repository::DatasetKind kind) {
    repository::Dataset dataset;
    dataset.id = {id};
    dataset.kind = kind;
    dataset.bounds = {-54.0, 68.5, -52.0, 69.5};
    if (kind != repository::DatasetKind::bathymetry) {
      dataset.time_start = core::from_unix_seconds(start_s);
      dataset.time_end = core::from_unix_seconds(start_s + 86400.0);
    }
    repository::DatasetRepository{db_}.insert(dataset);
  }

  /// A plan of one leg on 69 N whose dives turn at this depth.
  void store(const std::string& id, double from_deg, double to_deg, double upper_turn_m) {
    planning::Plan plan;
    plan.vehicle = "slocum-g3-200";
    plan.departure = core::from_unix_seconds(start_s);
    plan.arrival = plan.departure + core::Seconds{30'000.0};
    plan.datasets = {{.id = "ice-1", .kind = "ice", .name = "ice", .sha256 = ""}};
    plan.waypoints.resize(2);
    plan.waypoints[0].place = {from_deg, 69.0};
    plan.waypoints[0].eta = plan.departure;
    plan.waypoints[1].place = {to_deg, 69.0};
    plan.waypoints[1].eta = plan.arrival;
    plan.waypoints[1].leg_length = core::Metres{10'000.0};
    plan.surfacing.emplace();
    plan.surfacing->waypoints.resize(2);
    plan.surfacing->waypoints[1].leg_upper_turn = core::Metres{upper_turn_m};
    repository::PlanRecord record;
    record.id = {id};
    record.departure = plan.departure;
    record.arrival = plan.arrival;
    record.request_json =
        json{{"from", {from_deg, 69.0}}, {"to", {to_deg, 69.0}}, {"depart", "2027-01-15T08:00:00Z"}}.dump();
    record.document_json = codec::plan_document(plan, id, "").dump();
    repository::PlanRepository{db_}.insert(record);
  }

  /// The answer to an export that accepts all dangers of the newest data.
  routes::Response answer(const std::string& id, const std::string& what) {
    const std::string separator = what.find('?') == std::string::npos ? "?" : "&";
    return ask("GET", "/collections/plans/items/" + id + "/" + what + separator + "accept_dangers=true");
  }
};

TEST_F(ExportSeaTest, OneYoForAWayBelowIceIsNotWrittenOverABank) {
  store("p1", -53.4, -52.6, 58.0);
  store("p2", -53.7, -53.3, 58.0);

  const auto over_the_bank = answer("p1", "mission?safe=-53.5,69");
  const auto beside_it = answer("p2", "mission?safe=-53.5,69");

  EXPECT_EQ(over_the_bank.status, 400);
  EXPECT_THAT(over_the_bank.body, HasSubstr("lead over water of only 45 m at "));
  ASSERT_EQ(beside_it.status, 200) << beside_it.body;
  EXPECT_THAT(json_of(beside_it)["files"][0]["text"].get<std::string>(),
              HasSubstr("u_max_expected_iceberg_depth(m) 48\n"));
}

TEST_F(ExportSeaTest, OneYoForAWayBelowIceIsNotWrittenWhereItMeetsTooStrongACurrent) {
  // Water that flows west at 1 m/s below 60 m and stands above 40 m.
  const ocean::Axis levels{{0.0, 40.0, 60.0, 300.0}};
  const ocean::Axis times{{start_s, start_s + 86400.0}};
  add("currents-1", repository::DatasetKind::currents);
  repository::FieldRepository fields{db_};
  fields.create(
      {"currents-1"},
      {{geo::GeographicFrame{}, ocean::Axis{{-54.0, -52.0}}, ocean::Axis{{68.5, 69.5}}}, levels, times});
  for (std::size_t day = 0; day < 2; ++day) {
    for (std::size_t level = 0; level < 4; ++level) {
      fields.write_slice({"currents-1"}, "u_m_s", day, level,
                         std::vector<float>(4, level < 2 ? 0.0F : -1.0F));
      fields.write_slice({"currents-1"}, "v_m_s", day, level, std::vector<float>(4, 0.0F));
    }
  }
  store("p1", -53.7, -53.3, 58.0);

  const auto refused = answer("p1", "mission?safe=-53.5,69");

  EXPECT_EQ(refused.status, 400);
  EXPECT_THAT(refused.body,
              AllOf(HasSubstr("cannot be flown by the one yo of the mission, which turns between "
                              "58 m and 180 m on the whole route"),
                    HasSubstr("too strong")));
}

TEST_F(ExportSeaTest, PlacesToRecoverToAreOpenWater) {
  store("p1", -53.7, -53.3, 58.0);
  const auto of_place = [&](const char* place) { return answer("p1", "mission?safe=" + std::string{place}); };

  EXPECT_THAT(of_place("-53.5,69;-52.2,69").body, AllOf(HasSubstr("/safe/1"), HasSubstr("90 % of ice")));
  EXPECT_THAT(of_place("-53.99,69").body, HasSubstr("on land"));
  EXPECT_EQ(of_place("-53.99,69").status, 400);
  EXPECT_THAT(of_place("-53.5,69").body, Not(HasSubstr("data on")));
  EXPECT_EQ(of_place("-53.5,68").status, 200);
  EXPECT_THAT(of_place("-53.5,68").body, HasSubstr("data on the sea bed and the ice"));
  EXPECT_EQ(of_place("0,95").status, 400);
}

TEST_F(ExportSeaTest, FilesThatDoNotTellHowDeepTheDivesTurnBelowIceSaySo) {
  store("p1", -53.7, -53.3, 58.0);

  EXPECT_EQ(answer("p1", "mission.targets").status, 400);
  EXPECT_EQ(answer("p1", "mission?format=seaglider").status, 400);
  const auto warns = [&](const std::string& format) {
    const auto response = answer("p1", "mission." + format);
    EXPECT_EQ(response.status, 200) << format;
    return std::ranges::any_of(response.headers, [](const auto& header) {
      return header.first == "Floeplan-Warning" &&
             header.second.find("upper turn must be at 58 m or deeper") != std::string::npos;
    });
  };
  for (const char* format : {"gpx", "kml", "csv", "nmea", "imc"}) EXPECT_TRUE(warns(format)) << format;
  for (const char* format : {"geojson", "html", "pdf"}) EXPECT_FALSE(warns(format)) << format;

  store("p2", -53.7, -53.3, 0.0);
  EXPECT_EQ(answer("p2", "mission.targets").status, 200);
}

TEST_F(ExportSeaTest, TheBriefShowsTheIceOfThePlanAsLongAsItIsStored) {
  store("p1", -52.8, -52.2, 58.0);
  EXPECT_THAT(answer("p1", "mission.html").body, HasSubstr("class=\"hatch\""));

  repository::DatasetRepository{db_}.remove({"ice-1"});
  const auto without = answer("p1", "mission.html");
  EXPECT_EQ(without.status, 200);
  EXPECT_THAT(without.body, Not(HasSubstr("class=\"hatch\"")));
}

TEST_F(ExportSeaTest, DivesOfOtherVehiclesHeedTheBank) {
  store("p1", -53.4, -52.6, 0.0);

  const json imc = json_of(answer("p1", "mission.imc"));
  EXPECT_EQ(imc["maneuvers"].back()["data"]["z"], 35.0);
  EXPECT_THAT(answer("p1", "mission?format=seaglider").body, HasSubstr("the sea is only 45 m deep at "));
}

}  // namespace
}  // namespace floeplan::routes::export_sea_test
