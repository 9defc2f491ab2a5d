#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "tests/storage/ingest/support/model_grid_writer.hpp"
#include "tests/storage/ingest/support/netcdf_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"
#include "tests/support/property.hpp"

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

  ocean::Bathymetry depths_in(const repository::DatasetId& id, const geo::BoundingBox& area) {
    return repository::FieldRepository{db_}.load_bathymetry(id, area).value();
  }
  static geo::BoundingBox at_place(geo::LonLat place) {
    return {place.lon_deg, place.lat_deg, place.lon_deg, place.lat_deg};
  }

  ModelGrid grid_;
};

constexpr geo::BoundingBox everywhere{-180.0, 40.0, 180.0, 90.0};

TEST_F(BentPlanes, OfDepthsAreKeptAtTheModelsOwnPoints) {
  write("deptho", "sea_floor_depth_below_geoid", "m", [](std::size_t i, std::size_t j, geo::LonLat place) {
    return depth_m(place) + 30.0 * static_cast<double>((i + j) % 3);
  });

  const auto report = ingest(path("bent.nc"));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_THAT(words(report), HasSubstr("kept at its own place (1200 points, a bent grid)"));
  for (std::size_t j = 0; j < grid_.rows; ++j)
    for (std::size_t i = 0; i < grid_.columns; ++i) {
      const geo::LonLat place = grid_.place(static_cast<double>(i), static_cast<double>(j));
      const auto here = depths_in(report.dataset->id, at_place(place));
      const double model_m = depth_m(place) + 30.0 * static_cast<double>((i + j) % 3);
      ASSERT_NEAR(here.depth(place).value().value, model_m, 1e-3) << i << " " << j;
      ASSERT_NEAR(here.shoalest(place).value().value, model_m, 1e-3) << i << " " << j;
    }
}

TEST_F(BentPlanes, OfDepthsAreInterpolatedForPlans) {
  write("deptho", "sea_floor_depth_below_geoid", "m",
        [](std::size_t, std::size_t, geo::LonLat place) { return depth_m(place); });

  const auto sea = depths_in(ingest(path("bent.nc")).dataset.value().id, everywhere);

  std::size_t known = 0;
  for (std::size_t i = 0; i < sea.grid().size(); ++i) {
    if (std::isnan(sea.depth_m()[i])) continue;
    ++known;
    const auto place = sea.grid().place(i % sea.grid().x().size(), i / sea.grid().x().size());
    EXPECT_NEAR(sea.depth_m()[i], depth_m(place), 2.0);
    EXPECT_LE(sea.shoalest_m()[i], sea.depth_m()[i]);
  }
  EXPECT_GT(known, sea.grid().size() / 4);
}

TEST_F(BentPlanes, AreNowhereDeeperThanTheShoalestCornerOfACell) {
  const auto model_m = [](std::size_t i, std::size_t j) {
    return 20.0 + static_cast<double>((7919 * i + 104729 * j) % 977);
  };
  write("deptho", "sea_floor_depth_below_geoid", "m",
        [&](std::size_t i, std::size_t j, geo::LonLat) { return model_m(i, j); });

  const auto id = ingest(path("bent.nc")).dataset.value().id;

  const auto sea = depths_in(id, everywhere);
  support::for_each_seed(20, [&](std::mt19937_64& rng) {
    for (std::size_t j = 0; j + 1 < grid_.rows; ++j)
      for (std::size_t i = 0; i + 1 < grid_.columns; ++i) {
        const geo::LonLat place = grid_.place(static_cast<double>(i) + support::uniform(rng, 0.05, 0.95),
                                              static_cast<double>(j) + support::uniform(rng, 0.05, 0.95));
        const double shoalest_m =
            std::min({model_m(i, j), model_m(i + 1, j), model_m(i, j + 1), model_m(i + 1, j + 1)});
        const auto for_plans = sea.shoalest(place);
        if (for_plans) {
          ASSERT_LE(for_plans->value, shoalest_m + 1e-3) << i << " " << j;
        }
        if (i % 10 == 0 && j % 10 == 0) {
          ASSERT_NEAR(depths_in(id, at_place(place)).shoalest(place).value().value, shoalest_m, 1e-3);
        }
      }
  });
}

TEST_F(BentPlanes, OfSeaIceAreKeptAtTheModelsOwnPoints) {
  write("siconc", "sea_ice_area_fraction", "1",
        [](std::size_t, std::size_t, geo::LonLat place) { return cover(place); });

  const auto report = ingest(path("bent.nc"), {.time = core::from_unix_seconds(1.8e9)});

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  const repository::FieldRepository fields{db_};
  const auto ice = fields.load_ice(report.dataset->id, everywhere, std::nullopt).value();
  for (std::size_t j = 1; j + 1 < grid_.rows; ++j)
    for (std::size_t i = 1; i + 1 < grid_.columns; ++i) {
      const geo::LonLat place = grid_.place(static_cast<double>(i), static_cast<double>(j));
      const auto own = fields.load_ice(report.dataset->id, at_place(place), std::nullopt).value();
      EXPECT_NEAR(own.at(place, core::from_unix_seconds(1.8e9)).value().concentration, cover(place), 1e-6);
      EXPECT_NEAR(ice.at(place, core::from_unix_seconds(1.8e9)).value().concentration, cover(place), 0.002);
    }
}

TEST_F(BentPlanes, OfAnEarlierVersionStayAndTheSameFileMakesANewDataset) {
  write("deptho", "sea_floor_depth_below_geoid", "m",
        [](std::size_t, std::size_t, geo::LonLat place) { return depth_m(place); });
  const auto fresh = ingest(path("bent.nc"));
  repository::Dataset earlier = fresh.dataset.value();
  earlier.id = {"bathymetry-" + earlier.provenance.sha256.substr(0, 8)};
  earlier.warnings = {
      "\"deptho\" was resampled from a bent grid of 30 x 40 points to a regular grid of 0.09 x 0.2 "
      "degrees of longitude and latitude; the shoalest of the points around each node is kept "
      "beside it"};
  repository::DatasetRepository datasets{db_};
  datasets.remove(fresh.dataset->id);
  datasets.insert(earlier);

  const auto again = ingest(path("bent.nc"));

  EXPECT_EQ(again.status, IngestStatus::stored) << words(again);
  EXPECT_EQ(again.dataset->id, fresh.dataset->id);
  EXPECT_NE(again.dataset->id, earlier.id);
  EXPECT_EQ(stored_datasets(), 2U);
  EXPECT_EQ(ingest(path("bent.nc")).status, IngestStatus::unchanged);
}

}  // namespace
}  // namespace floeplan::ingest::bent_plane_test
