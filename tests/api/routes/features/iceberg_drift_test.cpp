#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/features/iceberg_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "tests/api/routes/api_fixture.hpp"

namespace floeplan::routes::iceberg_drift_test {
namespace {

using nlohmann::json;
using support::json_of;

constexpr double start_s = 1.8e9;  // 2027-01-15T08:00:00Z

/// A store with one iceberg in an eastward current of 0.5 m/s, which is known for two days.
class IcebergDriftTest : public support::ApiTest {
 protected:
  IcebergDriftTest() {
    insert("icebergs-1", repository::DatasetKind::icebergs, start_s, start_s);
    ocean::Iceberg berg;
    berg.id = "B-1";
    berg.place = {-53.0, 69.0};
    berg.observed = core::from_unix_seconds(start_s);
    berg.length = core::Metres{100.0};
    berg.position_uncertainty = core::Metres{200.0};
    repository::IcebergRepository{db_}.insert({"icebergs-1"}, {berg});

    const ocean::Axis times{{start_s, start_s + 86'400.0, start_s + 172'800.0}};
    insert("currents-1", repository::DatasetKind::currents, times.front(), times.back());
    repository::FieldRepository fields{db_};
    fields.create(
        {"currents-1"},
        {{geo::GeographicFrame{}, ocean::Axis{{-54.0, -52.0}}, ocean::Axis{{68.0, 70.0}}}, {}, times});
    for (std::size_t step = 0; step < 3; ++step) {
      fields.write_slice({"currents-1"}, "u_m_s", step, 0, std::vector<float>(4, 0.5F));
      fields.write_slice({"currents-1"}, "v_m_s", step, 0, std::vector<float>(4, 0.0F));
    }
  }

  void insert(const std::string& id, repository::DatasetKind kind, double from_s, double to_s) {
    repository::DatasetRepository{db_}.insert({.id = {id},
                                               .kind = kind,
                                               .name = id,
                                               .variables = {"u_m_s", "v_m_s"},
                                               .bounds = {-54.0, 68.0, -52.0, 70.0},
                                               .time_start = core::from_unix_seconds(from_s),
                                               .time_end = core::from_unix_seconds(to_s),
                                               .rows_accepted = 1,
                                               .rows_refused = 0,
                                               .warnings = {},
                                               .provenance = {}});
  }
};

TEST_F(IcebergDriftTest, ABergIsExpectedWhereTheCurrentTakesItWithinAnErrorThatGrows) {
  const json drift = json_of(
      ask("GET", "/map/drift?bbox=-54,68,-52,70&as_of=2027-01-15T08:00:00Z&until=2027-01-15T18:00:00Z"));

  ASSERT_EQ(drift["bergs"].size(), 1U);
  const json& berg = drift["bergs"][0];
  EXPECT_EQ(berg["berg_id"], "B-1");
  EXPECT_EQ(berg["time"].front(), "2027-01-15T08:00:00Z");
  EXPECT_EQ(berg["time"].back(), "2027-01-15T18:00:00Z");
  EXPECT_EQ(berg["lon"].size(), berg["time"].size());
  EXPECT_EQ(berg["error_m"].front(), 200.0);
  EXPECT_EQ(berg["error_m"].back(), 7700.0);
  // 18 km along the parallel of 69 degrees, on which a degree is 40.0 km long
  EXPECT_NEAR(berg["lon"].back().get<double>(), -53.0 + 18.0 / 40.0, 0.01);
  EXPECT_NEAR(berg["lat"].back().get<double>(), 69.0, 0.001);
}

TEST_F(IcebergDriftTest, ABergThatWasNotSeenYetIsNotExpectedAnywhere) {
  const json drift = json_of(
      ask("GET", "/map/drift?bbox=-54,68,-52,70&as_of=2027-01-15T07:00:00Z&until=2027-01-15T18:00:00Z"));
  EXPECT_TRUE(drift["bergs"].empty());
}

TEST_F(IcebergDriftTest, BoxesAndPeriodsOutOfBoundsAreRefusedTogether) {
  const Response wide =
      ask("GET", "/map/drift?bbox=-64,60,-50,70&as_of=2027-01-15T08:00:00Z&until=2027-02-15T18:00:00Z");
  EXPECT_EQ(wide.status, 400);
  EXPECT_EQ(json_of(wide)["errors"].size(), 2U);
  EXPECT_EQ(ask("GET", "/map/drift").status, 400);
  EXPECT_EQ(ask("GET",
                "/map/drift?bbox=-54,68,-52,70&as_of=2027-01-15T08:00:00Z&until=2027-01-15T18:00:00Z&"
                "dataset=nowhere")
                .status,
            400);
}

}  // namespace
}  // namespace floeplan::routes::iceberg_drift_test
