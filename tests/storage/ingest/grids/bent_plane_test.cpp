#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "storage/repository/fields/field_repository.hpp"
#include "tests/storage/ingest/support/model_grid_writer.hpp"
#include "tests/storage/ingest/support/netcdf_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest::bent_plane_test {
namespace {

using testing::HasSubstr;

/// A field that is linear in longitude and latitude, on a bent grid whose places are tables.
class BentPlanes : public StoreFixture {
 protected:
  static double depth_m(geo::LonLat place) {
    return 800.0 + 60.0 * (place.lat_deg - 70.0) - 9.0 * (place.lon_deg - 15.0);
  }
  static double cover(geo::LonLat place) {
    return 0.5 + 0.05 * (place.lat_deg - 70.0) + 0.01 * (place.lon_deg - 15.0);
  }

  template <class Field>
  void write(const std::string& name, const std::string& standard_name, const std::string& unit,
             const Field& field) {
    std::vector<double> lon_deg;
    std::vector<double> lat_deg;
    std::vector<double> values;
    for (std::size_t j = 0; j < grid_.rows; ++j)
      for (std::size_t i = 0; i < grid_.columns; ++i) {
        const geo::LonLat place = grid_.place(static_cast<double>(i), static_cast<double>(j));
        lon_deg.push_back(place.lon_deg);
        lat_deg.push_back(place.lat_deg);
        values.push_back(field(i, j, place));
      }
    NetcdfWriter file{path("bent.nc")};
    file.dimension("y", grid_.rows);
    file.dimension("x", grid_.columns);
    const auto add = [&](const std::string& variable, const std::vector<double>& content,
                         const std::map<std::string, std::string>& texts) {
      file.variable({.name = variable,
                     .dimensions = {"y", "x"},
                     .values = content,
                     .texts = texts,
                     .numbers = {},
                     .fill = {},
                     .type = NetcdfWriter::Type::float64});
    };
    add("nav_lon", lon_deg, {{"units", "degrees_east"}});
    add("nav_lat", lat_deg, {{"units", "degrees_north"}});
    add(name, values,
        {{"units", unit}, {"standard_name", standard_name}, {"coordinates", "nav_lon nav_lat"}});
  }

  repository::FieldRepository::Planes planes(const repository::DatasetId& id,
                                             const std::vector<std::string>& names) {
    return repository::FieldRepository{db_}.load_planes(id, {-180.0, 40.0, 180.0, 90.0}, names).value();
  }

  ModelGrid grid_;
};

TEST_F(BentPlanes, OfDepthsAreStoredOnARegularGrid) {
  write("deptho", "sea_floor_depth_below_geoid", "m",
        [](std::size_t, std::size_t, geo::LonLat place) { return depth_m(place); });

  const auto report = ingest(path("bent.nc"));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_THAT(words(report), HasSubstr("bent grid of 30 x 40"));
  const auto stored = planes(report.dataset->id, {"depth_m", "shoalest_m"});
  std::size_t known = 0;
  for (std::size_t i = 0; i < stored.grid.size(); ++i) {
    const float depth = stored.values[0][i];
    if (std::isnan(depth)) continue;
    ++known;
    const auto place = stored.grid.place(i % stored.grid.x().size(), i / stored.grid.x().size());
    EXPECT_NEAR(depth, depth_m(place), 2.0);
    EXPECT_LE(stored.values[1][i], depth);
  }
  EXPECT_GT(known, stored.grid.size() / 4);
}

TEST_F(BentPlanes, KeepTheShoalestOfTheirPoints) {
  write("deptho", "sea_floor_depth_below_geoid", "m", [](std::size_t i, std::size_t j, geo::LonLat place) {
    return i == 17 && j == 11 ? 12.5 : depth_m(place);
  });

  const auto report = ingest(path("bent.nc"));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  const auto stored = planes(report.dataset->id, {"shoalest_m"});
  float shoalest = 1e6F;
  for (const float depth : stored.values[0])
    if (depth < shoalest) shoalest = depth;
  EXPECT_EQ(shoalest, 12.5F);
}

TEST_F(BentPlanes, OfSeaIceAreStoredOnARegularGrid) {
  write("siconc", "sea_ice_area_fraction", "1",
        [](std::size_t, std::size_t, geo::LonLat place) { return cover(place); });

  const auto report = ingest(path("bent.nc"), {.time = core::from_unix_seconds(1.8e9)});

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  const auto stored = planes(report.dataset->id, {"concentration"});
  std::size_t known = 0;
  for (std::size_t i = 0; i < stored.grid.size(); ++i) {
    if (std::isnan(stored.values[0][i])) continue;
    ++known;
    const auto place = stored.grid.place(i % stored.grid.x().size(), i / stored.grid.x().size());
    EXPECT_NEAR(stored.values[0][i], cover(place), 0.002);
  }
  EXPECT_GT(known, stored.grid.size() / 4);
}

}  // namespace
}  // namespace floeplan::ingest::bent_plane_test
