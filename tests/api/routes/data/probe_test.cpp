#include <limits>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/features/iceberg_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "tests/api/routes/api_fixture.hpp"

namespace floeplan::routes::probe_test {
namespace {

using nlohmann::json;
using repository::DatasetKind;
using support::json_of;

constexpr double start_s = 1.8e9;  // 2027-01-15T08:00:00Z
constexpr double hour_s = 3600.0;

class ProbeTest : public support::ApiTest {
 protected:
  repository::DatasetId add(const std::string& id, DatasetKind kind, std::optional<double> from_s = {},
                            std::optional<double> to_s = {}, std::optional<double> run_s = {}) {
    repository::Dataset dataset;
    dataset.id = {id};
    dataset.kind = kind;
    dataset.name = id;
    dataset.variables = {"uo", "vo"};
    dataset.bounds = {-54.0, 68.0, -52.0, 70.0};
    if (from_s) dataset.time_start = core::from_unix_seconds(*from_s);
    if (to_s) dataset.time_end = core::from_unix_seconds(*to_s);
    if (run_s) dataset.run = core::from_unix_seconds(*run_s);
    repository::DatasetRepository{db_}.insert(dataset);
    return {id};
  }

  /// Currents to the east, of one speed at every step.
  void add_run(const std::string& id, const std::vector<double>& times_s, float speed_m_s) {
    add(id, DatasetKind::currents, times_s.front(), times_s.back(), times_s.front());
    repository::FieldRepository fields{db_};
    fields.create({id}, {square_, {}, ocean::Axis{times_s}});
    for (std::size_t step = 0; step < times_s.size(); ++step) {
      fields.write_slice({id}, "u_m_s", step, 0, std::vector<float>(4, speed_m_s));
      fields.write_slice({id}, "v_m_s", step, 0, std::vector<float>(4, 0.0F));
    }
  }

  void add_depths(const std::string& id, const ocean::HorizontalGrid& grid,
                  const std::vector<float>& depths_m) {
    add(id, DatasetKind::bathymetry);
    repository::FieldRepository fields{db_};
    fields.create({id}, {grid, {}, {}});
    fields.write_slice({id}, "depth_m", 0, 0, depths_m);
  }

  const ocean::HorizontalGrid square_{geo::GeographicFrame{}, ocean::Axis{{-54.0, -52.0}},
                                      ocean::Axis{{68.0, 70.0}}};
};

TEST_F(ProbeTest, TellsTheCurrentBetweenTwoRunsThatAreJoined) {
  add_run("run-1", {start_s, start_s + hour_s}, 0.1F);
  add_run("run-2", {start_s + 2.0 * hour_s, start_s + 3.0 * hour_s}, 0.3F);

  const json probe = json_of(ask("GET", "/probe?lon=-53&lat=69&time=2027-01-15T09:30:00Z"));

  EXPECT_NEAR(probe["currents"]["u_m_s"], 0.2, 1e-6) << probe;
  EXPECT_EQ(probe["currents"]["dataset_id"], "run-1");
  EXPECT_EQ(probe["currents"]["time_before"], "2027-01-15T09:00:00Z");
  EXPECT_EQ(probe["currents"]["time_after"], "2027-01-15T10:00:00Z");
}

TEST_F(ProbeTest, TellsTheDepthOfTheFinestDatasetThatKnowsIt) {
  constexpr float unknown = std::numeric_limits<float>::quiet_NaN();
  add_depths("coarse", square_, std::vector<float>(4, 400.0F));
  add_depths("survey",
             {geo::GeographicFrame{}, ocean::Axis{{-54.0, -53.5, -53.0, -52.5}}, ocean::Axis{{68.0, 70.0}}},
             {100.0F, 100.0F, unknown, unknown, 100.0F, 100.0F, unknown, unknown});

  EXPECT_EQ(json_of(ask("GET", "/probe?lon=-53.7&lat=69&time=2027-01-15T08:00:00Z"))["depth_m"], 100.0);
  EXPECT_EQ(json_of(ask("GET", "/probe?lon=-52.4&lat=69&time=2027-01-15T08:00:00Z"))["depth_m"], 400.0);
}

TEST_F(ProbeTest, AsksTheNamedDatasetsOfEachKindAlone) {
  add_run("run-1", {start_s, start_s + hour_s}, 0.1F);
  add_run("run-2", {start_s, start_s + hour_s}, 0.3F);
  add_depths("coarse", square_, std::vector<float>(4, 400.0F));
  add_depths("fine",
             {geo::GeographicFrame{}, ocean::Axis{{-54.0, -53.0, -52.0}}, ocean::Axis{{68.0, 69.0, 70.0}}},
             std::vector<float>(9, 100.0F));
  for (const std::string id : {"list", "other-list"}) {
    add(id, DatasetKind::icebergs, start_s, start_s);
    ocean::Iceberg berg;
    berg.id = "berg of " + id;
    berg.place = {-53.0, 69.1};
    berg.observed = core::from_unix_seconds(start_s);
    repository::IcebergRepository{db_}.insert({id}, {berg});
  }
  const std::string here = "/probe?lon=-53&lat=69&time=2027-01-15T08:00:00Z";

  const json unnamed = json_of(ask("GET", here));
  const json named = json_of(ask("GET", here + "&dataset=run-1,coarse,list"));

  EXPECT_EQ(unnamed["depth_m"], 100.0);
  EXPECT_EQ(unnamed["icebergs_within"].size(), 2U);
  EXPECT_EQ(named["currents"]["dataset_id"], "run-1");
  EXPECT_NEAR(named["currents"]["u_m_s"], 0.1, 1e-6);
  EXPECT_EQ(named["depth_m"], 400.0);
  ASSERT_EQ(named["icebergs_within"].size(), 1U) << named;
  EXPECT_EQ(named["icebergs_within"][0]["berg_id"], "berg of list");
  EXPECT_EQ(json_of(ask("GET", here + "&dataset=coarse,fine"))["depth_m"], 400.0) << "the first has priority";
  EXPECT_EQ(ask("GET", here + "&dataset=run-1,unknown").status, 404);
}

TEST_F(ProbeTest, NamesABergOfTwoListsOnceWhereItWasSeenLast) {
  for (const auto& [id, lat] : {std::pair{"list", 69.0}, {"update", 69.1}}) {
    add(id, DatasetKind::icebergs, start_s, start_s);
    ocean::Iceberg berg;
    berg.id = "A";
    berg.place = {-53.0, lat};
    berg.observed = core::from_unix_seconds(start_s - (lat < 69.05 ? 20.0 : 1.0) * hour_s);
    repository::IcebergRepository{db_}.insert({id}, {berg});
  }

  const json probe = json_of(ask("GET", "/probe?lon=-53&lat=69&time=2027-01-15T08:00:00Z"));
  const json latest =
      json_of(ask("GET", "/collections/icebergs/items?latest=true&datetime=2027-01-15T08:00:00Z"));

  ASSERT_EQ(probe["icebergs_within"].size(), 1U) << probe;
  ASSERT_EQ(latest["features"].size(), 1U) << latest;
  EXPECT_EQ(latest["features"][0]["geometry"]["coordinates"][1], 69.1);
}

}  // namespace
}  // namespace floeplan::routes::probe_test
