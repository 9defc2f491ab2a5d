#include "api/service/low_water.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "api/service/plan_check.hpp"
#include "api/service/plan_service.hpp"
#include "api/service/threads.hpp"
#include "engine/core/utc_text.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/fields/water_level_repository.hpp"
#include "storage/repository/store/migrations.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::service::low_water_test {
namespace {

using nlohmann::json;

/// A flat bed 40 m below the chart datum, and water levels that fall from the datum at 06:00 by 2 m an hour, but only
/// west of 52.95 W; east of it they stay at the datum.
class LowWater : public testing::Test {
 protected:
  void add_bed(float depth_m) {
    const auto id = add("bathymetry-12345678", repository::DatasetKind::bathymetry, "bed");
    repository::FieldRepository fields{db_};
    const ocean::HorizontalGrid grid{geo::GeographicFrame{}, ocean::Axis{{-54.0, -53.0, -52.0}},
                                     ocean::Axis{{68.0, 69.0, 70.0}}};
    fields.create(id, {grid, std::nullopt, std::nullopt});
    fields.write_slice(id, "depth_m", 0, 0, std::vector<float>(9, depth_m));
  }

  void add_falling_levels() {
    const auto id = add("water-levels-12345678", repository::DatasetKind::water_levels, "bay levels");
    std::vector<double> hours_s;
    for (int hour = 0; hour <= 24; ++hour) hours_s.push_back(core::unix_seconds(six_) + 3600.0 * hour);
    const ocean::HorizontalGrid grid{geo::GeographicFrame{}, ocean::Axis{{-54.0, -52.96, -52.95, -52.0}},
                                     ocean::Axis{{68.0, 70.0}}};
    repository::WaterLevelRepository levels{db_};
    levels.create(id, "mean sea level", {grid, std::nullopt, ocean::Axis{hours_s}});
    for (std::size_t hour = 0; hour <= 24; ++hour) {
      const float fallen_m = -2.0F * static_cast<float>(hour);
      levels.write(id, hour, std::vector<float>{fallen_m, fallen_m, 0, 0, fallen_m, fallen_m, 0, 0});
    }
  }

  /// A plan that leaves at an hour after six, eastward from 53.3 W: it passes 52.96 W about 11 h later.
  json plan(int hours_later, double altimeter_margin_m) {
    const auto inputs =
        codec::parse_plan_inputs(json{{"from", {-53.3, 69.0}},
                                      {"to", {-52.7, 69.0}},
                                      {"depart", core::iso8601(six_ + core::Seconds{3600.0 * hours_later})},
                                      {"vehicle", {{"altimeter_margin_m", altimeter_margin_m}}},
                                      {"method", "direct"}})
            .value();
    json document = plan_route_document(db_, inputs, Threads{1}, {}, {}, six_).value();
    EXPECT_EQ(document.at("status"), "ok") << document.dump(1);
    return document;
  }

  std::optional<json> caution(int hours_later, double altimeter_margin_m) {
    const json document = plan(hours_later, altimeter_margin_m);
    if (document.contains("messages"))
      for (const json& message : document.at("messages"))
        if (message.at("code") == "low-water-at-bed") return message;
    return std::nullopt;
  }

  /// Whether a check of the stored plan tells it.
  bool is_told_again(const json& document) {
    const auto record = repository::PlanRepository{db_}.find({document.at("plan_id").get<std::string>()});
    const std::vector<messages::Message> told = all_of(check_plan(db_, record.value()));
    return std::ranges::count(told, "low-water-at-bed", &messages::Message::code) == 1;
  }

 private:
  repository::DatasetId add(const std::string& id, repository::DatasetKind kind, const std::string& name) {
    repository::Dataset dataset;
    dataset.id = {id};
    dataset.kind = kind;
    dataset.name = name;
    dataset.bounds = {-54.0, 68.0, -52.0, 70.0};
    dataset.provenance.sha256 = name;
    if (kind == repository::DatasetKind::water_levels) {
      dataset.time_start = six_;
      dataset.time_end = six_ + core::Seconds{86'400.0};
    }
    repository::DatasetRepository{db_}.insert(dataset);
    return dataset.id;
  }

  support::TemporaryFolder store_;
  sql::Connection db_{repository::open_store(store_.path())};
  core::UtcTime six_{core::parse_iso8601("2026-11-20T06:00:00Z").value()};
};

TEST_F(LowWater, ThatTheMarginDoesNotHideIsACautionWhereItIsLowestOnTheRoute) {
  add_bed(40.0F);
  add_falling_levels();

  const auto told = caution(0, 10.0);

  ASSERT_TRUE(told);
  EXPECT_EQ(told->at("rank"), "caution");
  const json& values = told->at("values");
  EXPECT_EQ(values.at("datum"), "mean sea level");
  EXPECT_NEAR(values.at("below_m").get<double>(), values.at("fall_m").get<double>() - 10.0, 1e-6);
  EXPECT_GT(values.at("fall_m"), 15.0);
  EXPECT_NEAR(told->at("place").at("lon").get<double>(), -52.96, 0.01) << "the last of the falling water";
  EXPECT_GE(values.at("margin_m"), values.at("fall_m"));

  EXPECT_FALSE(caution(0, values.at("margin_m"))) << "the margin that the message names hides it";
  EXPECT_FALSE(caution(-48, 10.0)) << "before the levels begin";
}

TEST_F(LowWater, AboveABedThatTheDivesDoNotReachIsNoCaution) {
  add_bed(400.0F);
  add_falling_levels();
  EXPECT_FALSE(caution(0, 10.0));
}

TEST_F(LowWater, IsToldByACheckOfAPlanThatIsOlderThanTheLevels) {
  add_bed(40.0F);
  const json before = plan(0, 10.0);
  EXPECT_FALSE(is_told_again(before));
  add_falling_levels();
  EXPECT_TRUE(is_told_again(before));
}

TEST_F(LowWater, IsNoMatterWithoutDepths) {
  add_falling_levels();
  EXPECT_FALSE(caution(0, 10.0));
}

}  // namespace
}  // namespace floeplan::service::low_water_test
