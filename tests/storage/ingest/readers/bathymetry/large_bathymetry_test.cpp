#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest::large_bathymetry_test {
namespace {

using testing::HasSubstr;

/// Grids of more nodes than are read at once.
class LargeBathymetry : public StoreFixture {
 protected:
  static constexpr std::size_t columns = 2500;
  static constexpr std::size_t rows = 2000;

  /// Elevations, rows from the north; every node of a neighbourhood has its own.
  static std::vector<float> relief() {
    std::vector<float> elevation_m;
    for (std::size_t row = 0; row < rows; ++row)
      for (std::size_t column = 0; column < columns; ++column)
        elevation_m.push_back(-100.0F - static_cast<float>((row * 7 + column * 13) % 997));
    return elevation_m;
  }

  std::filesystem::path write_tiff(std::vector<float> elevation_m) const {
    register_drivers();
    const std::unique_ptr<GDALDataset> dataset{GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
        path("large.tif").c_str(), columns, rows, 1, GDT_Float32, nullptr)};
    OGRSpatialReference degrees;
    degrees.SetWellKnownGeogCS("WGS84");
    dataset->SetSpatialRef(&degrees);
    std::array<double, 6> transform{10.0, 0.002, 0.0, 70.0, 0.0, -0.002};
    dataset->SetGeoTransform(transform.data());
    EXPECT_EQ(dataset->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, columns, rows, elevation_m.data(), columns,
                                                  rows, GDT_Float32, 0, 0, nullptr),
              CE_None);
    return path("large.tif");
  }

  void expect_stored(const std::filesystem::path& file, const std::vector<float>& elevation_m) {
    const auto report = ingest(file, {.positive = "up"});
    ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
    EXPECT_THAT(words(report), HasSubstr("1 value was left out, because it stands for a missing depth"));
    const auto sea = repository::FieldRepository{db_}.load_bathymetry(report.dataset->id, everywhere_);
    ASSERT_EQ(sea->depth_m().size(), rows * columns);
    std::size_t different = 0;
    for (std::size_t row = 0; row < rows; ++row) {
      for (std::size_t column = 0; column < columns; ++column) {
        const float expected = elevation_m[(rows - 1 - row) * columns + column];
        const float found = sea->depth_m()[row * columns + column];
        if (expected == 9999.0F ? !std::isnan(found) : found != -expected) ++different;
      }
    }
    EXPECT_EQ(different, 0U);
  }

  const geo::BoundingBox everywhere_{-180.0, -90.0, 180.0, 90.0};
};

TEST_F(LargeBathymetry, KeepsEveryNodeAndLeavesOutAMarkerWhereverItIs) {
  auto elevation_m = relief();
  elevation_m[3] = 9999.0F;  // in the last rows that are read
  expect_stored(write_tiff(elevation_m), elevation_m);
}

TEST_F(LargeBathymetry, IsRefusedForADepthThatIsNoneWhereverItIsAndLeavesNothing) {
  auto elevation_m = relief();
  elevation_m[3] = -13000.0F;
  expect_refused(write_tiff(elevation_m), "a depth of 13000 m at longitude 10.007, latitude 69.999",
                 {.positive = "up"});
  EXPECT_TRUE(repository::DatasetRepository{db_}.list().empty());
}

}  // namespace
}  // namespace floeplan::ingest::large_bathymetry_test
