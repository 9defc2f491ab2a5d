#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "engine/core/utc_text.hpp"
#include "storage/repository/fields/water_level_repository.hpp"
#include "tests/storage/ingest/support/s100_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest::s104_test {
namespace {

using repository::WaterLevelRepository;
using repository::WaterLevelStation;
using testing::HasSubstr;

constexpr float fill = -9999.0F;

/// 0.5 to 1.0 m over the nodes, falling by a metre in 20 minutes.
float falling(std::size_t column, std::size_t row, std::size_t time) {
  return 0.5F + 0.1F * static_cast<float>(column + 3 * row) - 1.0F * static_cast<float>(time);
}

core::UtcTime at(const char* text) { return core::parse_iso8601(text).value(); }

class S104 : public StoreFixture {
 protected:
  repository::DatasetId stored(const std::filesystem::path& file) {
    report_ = ingest(file);
    EXPECT_EQ(report_.status, IngestStatus::stored) << words(report_);
    if (!report_.dataset) return {};
    EXPECT_EQ(report_.dataset->kind, repository::DatasetKind::water_levels);
    return report_.dataset->id;
  }

  std::optional<double> level(const repository::DatasetId& id, geo::LonLat place, core::UtcTime time) {
    const auto level = WaterLevelRepository{db_}.at(id, place, time);
    if (!level) return std::nullopt;
    return level->height.value;
  }

  /// Expects a refusal of the sample after a change.
  void refused(const std::string& reason, const std::function<void(S100Sample&)>& change) {
    S100Sample sample = s104_sample(falling);
    change(sample);
    expect_refused(sample.write(path("104.h5")), reason);
  }

  IngestReport report_;
};

TEST_F(S104, IsAHeightAboveTheDatumOfTheFileAtItsNodesAndLinearBetweenTimes) {
  const auto id = stored(s104_sample(falling).write(path("104.h5")));
  for (std::size_t node = 0; node < 6; ++node) {
    const geo::LonLat place{-50.0 + 0.1 * static_cast<double>(node % 3),
                            47.0 + 0.1 * static_cast<double>(node / 3)};
    EXPECT_NEAR(level(id, place, at("2026-01-11T00:00:00Z")).value(), falling(node % 3, node / 3, 0), 1e-6);
    EXPECT_NEAR(level(id, place, at("2026-01-11T00:20:00Z")).value(), falling(node % 3, node / 3, 1), 1e-6);
    EXPECT_NEAR(level(id, place, at("2026-01-11T00:05:00Z")).value(), falling(node % 3, node / 3, 0) - 0.25,
                1e-6);
  }
  EXPECT_NEAR(level(id, {-49.95, 47.05}, at("2026-01-11T00:00:00Z")).value(), 0.7, 1e-6)
      << "in the middle of a cell";
  EXPECT_EQ(WaterLevelRepository{db_}.datum(id), "lowest astronomical tide");
  EXPECT_FALSE(level(id, {-49.95, 47.05}, at("2026-01-11T00:21:00Z"))) << "after its end";
  EXPECT_FALSE(level(id, {-49.0, 47.05}, at("2026-01-11T00:00:00Z"))) << "beyond its area";
}

/// The water falls 0.5 m below the datum: a sign read the wrong way round would add this water to the depth.
TEST_F(S104, BelowItsDatumIsNegativeAndTheReportWarnsOfDepthsThatAreTooGreat) {
  const auto id = stored(s104_sample(falling).write(path("104.h5")));
  EXPECT_NEAR(level(id, {-50.0, 47.0}, at("2026-01-11T00:20:00Z")).value(), -0.5, 1e-6);
  EXPECT_THAT(words(report_), HasSubstr("falls to 0.5 m below its datum (lowest astronomical tide)"));
  const auto above = ingest(s104_sample([](auto, auto, auto) { return 0.5F; }).write(path("above.h5")));
  EXPECT_THAT(words(above), testing::Not(HasSubstr("falls to")));
}

TEST_F(S104, InFeetIsStoredInMetres) {
  S100Sample sample = s104_sample(falling);
  sample.values[0].unit = "ft";
  EXPECT_NEAR(level(stored(sample.write(path("104.h5"))), {-50.0, 47.0}, at("2026-01-11T00:00:00Z")).value(),
              0.5 * 0.3048, 1e-6);
}

TEST_F(S104, HasNoLevelWhereTheFileHasNone) {
  const auto with_gap = [](std::size_t column, std::size_t row, std::size_t time) {
    return column == 2 ? fill : falling(column, row, time);
  };
  const auto id = stored(s104_sample(with_gap).write(path("104.h5")));
  EXPECT_TRUE(level(id, {-49.95, 47.05}, at("2026-01-11T00:00:00Z")));
  EXPECT_FALSE(level(id, {-49.85, 47.05}, at("2026-01-11T00:00:00Z")));
}

TEST_F(S104, BetweenTimesMoreThanAnHourApartHasNoLevel) {
  S100Sample sample = s104_sample(falling);
  sample.records[1].time = "20260111T020000Z";
  const auto id = stored(sample.write(path("104.h5")));
  EXPECT_TRUE(level(id, {-50.0, 47.0}, at("2026-01-11T02:00:00Z")));
  EXPECT_FALSE(level(id, {-50.0, 47.0}, at("2026-01-11T01:00:00Z")));
}

TEST_F(S104, WithAnotherVerticalAxisOrWithoutADatumIsRefused) {
  refused("verticalCS is 6498, not 6499", [](S100Sample& s) { s.file_numbers["verticalCS"] = 6498.0; });
  refused("verticalCoordinateBase is 1, not 2",
          [](S100Sample& s) { s.file_numbers["verticalCoordinateBase"] = 1.0; });
  refused("verticalDatum missing", [](S100Sample& s) { s.file_numbers.erase("verticalDatum"); });
  refused("verticalDatum 48", [](S100Sample& s) { s.file_numbers["verticalDatum"] = 48.0; });
  refused("verticalDatum 0.5", [](S100Sample& s) { s.file_numbers["verticalDatum"] = 0.5; });
  S100Sample epsg = s104_sample(falling);
  epsg.file_numbers["verticalDatumReference"] = 2.0;
  epsg.file_numbers["verticalDatum"] = 5829.0;
  EXPECT_EQ(WaterLevelRepository{db_}.datum(stored(epsg.write(path("epsg.h5")))), "EPSG:5829");
}

TEST_F(S104, ThatCannotBeIsRefused) {
  refused("unit \"degree\"", [](S100Sample& s) { s.values[0].unit = "degree"; });
  refused("is 120 m, but", [](S100Sample& s) { s.records[1].values[0][2] = 120.0F; });
  refused("is -120 m, but", [](S100Sample& s) { s.records[1].values[0][2] = -120.0F; });
  refused("every water level", [](S100Sample& s) {
    for (auto& record : s.records) record.values[0].assign(6, fill);
  });
  refused("unreadable time", [](S100Sample& s) { s.records[1].time = "yesterday"; });
  refused("timePoint", [](S100Sample& s) { s.records[1].time = s.records[0].time; });
  refused("announces 3 records", [](S100Sample& s) { s.announced_records = 3.0; });
  refused("2 areas of WaterLevel", [](S100Sample& s) { s.areas = 2; });
  refused("moving platform", [](S100Sample& s) { s.feature_numbers["dataCodingFormat"] = 4.0; });
  refused("cells of several sizes", [](S100Sample& s) { s.feature_numbers["dataCodingFormat"] = 6.0; });
}

/// Four places that two triangles join; a fifth lies in no triangle.
TEST_F(S104, OnATriangulatedMeshIsThatOfItsNodesAndLinearBetweenThem) {
  S100Sample sample = s104_sample(falling);
  sample.feature_numbers["dataCodingFormat"] = 7.0;
  sample.places = {{-50.0, 47.0}, {-49.9, 47.0}, {-49.9, 47.1}, {-50.0, 47.1}, {-49.0, 47.0}};
  sample.triangles = {{0, 1, 2}, {0, 2, 3}};
  for (auto& record : sample.records)
    record.values = {{0.1F, 0.2F, 0.4F, -0.3F, 0.9F}, std::vector<float>(5, 3.0F)};
  const auto id = stored(sample.write(path("7.h5")));
  const auto time = at("2026-01-11T00:00:00Z");
  EXPECT_NEAR(level(id, {-50.0, 47.1}, time).value(), -0.3, 1e-6);
  EXPECT_NEAR(level(id, {-49.9, 47.1}, time).value(), 0.4, 1e-6);
  EXPECT_NEAR(level(id, {-49.95, 47.05}, time).value(), 0.25, 1e-4) << "in the middle of the side that they share";
  EXPECT_FALSE(level(id, {-49.0, 47.0}, time)) << "a node of no triangle";
  EXPECT_THAT(words(report_), HasSubstr("4 points (a triangulated mesh)"));
}

TEST_F(S104, AtPlacesOfTheirOwnIsReadAsAMesh) {
  S100Sample sample = s104_sample(falling);
  sample.feature_numbers["dataCodingFormat"] = 3.0;
  for (int node = 0; node < 64; ++node)
    sample.places.emplace_back(-50.0 + 0.1 * (node % 8), 60.0 + 0.05 * (node / 8));
  for (auto& record : sample.records)
    record.values = {std::vector<float>(64, 1.25F), std::vector<float>(64, 3.0F)};
  EXPECT_NEAR(level(stored(sample.write(path("3.h5"))), {-49.73, 60.11}, at("2026-01-11T00:10:00Z")).value(),
              1.25, 1e-6);
}

TEST_F(S104, OfStationsKeepsTheSeriesOfEach) {
  const auto id = stored(s104_stations().write(path("8.h5")));
  const auto stations = WaterLevelRepository{db_}.stations(id);
  ASSERT_EQ(stations.size(), 2U);
  EXPECT_EQ(stations[0].name, "St. John's");
  EXPECT_EQ(stations[1].place.lat_deg, 47.8);
  EXPECT_NEAR(level_at(stations[0], at("2026-01-11T00:30:00Z"))->height.value, 0.8, 1e-6);
  EXPECT_NEAR(level_at(stations[1], at("2026-01-11T01:00:00Z"))->height.value, 2.1, 1e-6);
  EXPECT_FALSE(level_at(stations[1], at("2026-01-11T01:00:01Z"))) << "after its end";
  EXPECT_EQ(core::iso8601(report_.dataset->time_end.value()), "2026-01-11T01:00:00Z");
  EXPECT_FALSE(level(id, {-52.7, 47.56}, at("2026-01-11T00:00:00Z"))) << "stations are no field";
}

TEST_F(S104, OfAStationWithTimesOfItsOwnIsReadAtThem) {
  S100Sample sample = s104_stations();
  sample.records[1].numbers = {{"timeIntervalIndex", 0.0}};
  sample.records[1].times = {"20260111T000600Z", "20260111T000000Z", "20260111T001200Z", "20260111T001800Z"};
  const auto stations = WaterLevelRepository{db_}.stations(stored(sample.write(path("8.h5"))));
  EXPECT_NEAR(level_at(stations.at(1), at("2026-01-11T00:00:00Z"))->height.value, 1.7, 1e-6)
      << "the second of the file";
  EXPECT_NEAR(level_at(stations.at(1), at("2026-01-11T00:06:00Z"))->height.value, 1.5, 1e-6);
  sample.records[1].times[2] = "noon";
  expect_refused(sample.write(path("noon.h5")), "unreadable time \"noon\"");
}

TEST_F(S104, OfStationsByTimeIsTheSameAsOneByOne) {
  S100Sample sample = s104_sample(falling);
  sample.feature_numbers["dataCodingFormat"] = 1.0;
  sample.places = {{-52.7, 47.56}, {-53.4, 47.8}};
  sample.records[0].values = {{0.5F, fill}, {3.0F, 3.0F}};
  sample.records[1].values = {{0.7F, 1.7F}, {3.0F, 3.0F}};
  const auto stations = WaterLevelRepository{db_}.stations(stored(sample.write(path("1.h5"))));
  ASSERT_EQ(stations.size(), 2U);
  EXPECT_NEAR(level_at(stations[0], at("2026-01-11T00:10:00Z"))->height.value, 0.6, 1e-6);
  EXPECT_FALSE(level_at(stations[1], at("2026-01-11T00:10:00Z"))) << "one side is missing";
  EXPECT_NEAR(level_at(stations[1], at("2026-01-11T00:20:00Z"))->height.value, 1.7, 1e-6);
}

TEST_F(S104, OfStationsThatAreIncompleteIsRefused) {
  S100Sample sample = s104_stations();
  sample.places.pop_back();
  expect_refused(sample.write(path("a.h5")), "2 series for 1 stations");
  sample = s104_stations();
  sample.records[0].texts.erase("startDateTime");
  expect_refused(sample.write(path("b.h5")), "values");
}

/// Values as h5py 3 reads them.
TEST_F(S104, OfTheIhoReadsAsAnIndependentReaderDoes) {
  const auto file = sample_folder() / "s100/104US00_Florida_Ovp_20260111_20260120.h5";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the sample file is not here";
  const auto id = stored(file);
  EXPECT_EQ(WaterLevelRepository{db_}.datum(id), "lowest astronomical tide");
  struct Golden {
    const char* time;
    geo::LonLat place;
    double height_m;
  };
  for (const Golden& golden : {Golden{"2026-01-11T00:00:00Z", {-80.15172755510001, 25.5291666669}, 4.01},
                               Golden{"2026-01-11T12:00:00Z", {-80.0128386651, 25.6513888901}, 2.85},
                               Golden{"2026-01-15T03:40:00Z", {-80.0406164431, 25.7513888909}, 3.93},
                               Golden{"2026-01-20T23:40:00Z", {-79.9711719981, 25.7986111135}, 3.72}})
    EXPECT_NEAR(level(id, golden.place, at(golden.time)).value_or(NAN), golden.height_m, 1e-6) << golden.time;
}

}  // namespace
}  // namespace floeplan::ingest::s104_test
