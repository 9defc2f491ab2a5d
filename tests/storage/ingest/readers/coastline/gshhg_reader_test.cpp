#include "storage/ingest/readers/coastline/gshhg_reader.hpp"

#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <ostream>
#include <string>

#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/recognise.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::ingest::gshhg_reader_test {
namespace {

const std::filesystem::path shoreline{"/usr/share/gmt-gshhg/binned_GSHHS_f.nc"};

class GshhgReader : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(shoreline))
      GTEST_SKIP() << "install the package gmt-gshhg-full to run this test";
  }
};

/// Land with its boxes, so that many places can be asked for.
class Land {
 public:
  explicit Land(std::vector<geo::Polygon> pieces) : pieces_{std::move(pieces)} {
    for (const geo::Polygon& piece : pieces_) boxes_.push_back(geo::bounding_box(piece));
  }
  [[nodiscard]] int pieces_around(geo::LonLat place) const {
    int count = 0;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (geo::contains(boxes_[i], place) && geo::contains(pieces_[i], place)) ++count;
    }
    return count;
  }

 private:
  std::vector<geo::Polygon> pieces_;
  std::vector<geo::BoundingBox> boxes_;
};

TEST_F(GshhgReader, FindsTheIslandsThatSmallScaleCoastlinesLack) {
  const auto land = read_gshhg(shoreline, {-54.0, 68.8, -53.0, 69.2});
  ASSERT_TRUE(land.has_value());
  const Land disko_bay{*land};

  int found = 0;
  for (double lon = -53.5; lon < -53.25; lon += 0.002) {
    for (double lat = 68.96; lat < 69.06; lat += 0.002) found += disko_bay.pieces_around({lon, lat});
  }

  EXPECT_GT(found, 20);
  EXPECT_EQ(disko_bay.pieces_around({-53.2, 69.2}), 0);
}

TEST_F(GshhgReader, GivesValidPlacesAcrossTheAntimeridian) {
  const auto land = read_gshhg(shoreline, {179.0, 66.0, -179.0, 69.0});

  ASSERT_TRUE(land.has_value());
  ASSERT_FALSE(land->empty());
  for (const geo::Polygon& piece : *land) {
    for (const geo::LonLat place : piece.outer) {
      ASSERT_TRUE(geo::is_valid(place));
      ASSERT_TRUE(std::abs(place.lon_deg) >= 178.0 && std::abs(place.lon_deg) <= 180.0);
    }
  }
}

TEST_F(GshhgReader, IsChosenForAShorelineFile) {
  const auto recognised = recognise(shoreline, {});

  ASSERT_TRUE(recognised.has_value()) << reason_of(recognised.error());
  EXPECT_EQ(recognised->kinds, std::vector{repository::DatasetKind::coastline});
}

TEST_F(GshhgReader, TellsWhyAnotherNetcdfFileIsRefused) {
  const std::filesystem::path river{"/usr/share/gmt-gshhg/binned_river_f.nc"};
  if (!std::filesystem::exists(river)) GTEST_SKIP() << "the package gmt-gshhg-full has no river file";

  const auto land = read_gshhg(river, {-54.0, 68.0, -50.0, 70.0});

  EXPECT_TRUE(is_gshhg(shoreline));
  EXPECT_FALSE(is_gshhg(river));
  ASSERT_FALSE(land.has_value());
  EXPECT_NE(land.error().rule.find("it has no array Embedded_node_levels_in_a_bin"), std::string::npos)
      << land.error().rule;
}

TEST_F(GshhgReader, RefusesAFileThatIsNoNetcdf) {
  const support::TemporaryFolder folder;
  const auto path = folder.path() / "no_shoreline.nc";
  std::ofstream{path} << "not NetCDF";

  EXPECT_FALSE(is_gshhg(path));
  EXPECT_FALSE(read_gshhg(path, {-54.0, 68.0, -50.0, 70.0}).has_value());
}

/// GMT's own land mask (1 land, 0 sea, 0 lakes) at nodes that avoid the bin borders.
struct Mask {
  int columns{};
  int rows{};
  std::array<double, 6> transform{};
  std::vector<float> values;
};

Mask mask_by_gmt(const std::string& region) {
  const support::TemporaryFolder folder;  // also for the history that GMT writes where it runs
  const auto path = folder.path() / "mask.tif";
  const std::string command = "cd " + folder.path().string() + " && gmt grdlandmask -R" + region +
                              " -I0.02/0.0096 -Df -N0/1/0/1/0 -G" + path.string() +
                              "=gd:GTiff > /dev/null 2>&1";
  if (std::system(command.c_str()) != 0) return {};
  register_drivers();
  const std::unique_ptr<GDALDataset> dataset{GDALDataset::Open(path.c_str())};
  if (!dataset) return {};
  Mask mask{dataset->GetRasterXSize(), dataset->GetRasterYSize(), {}, {}};
  dataset->GetGeoTransform(mask.transform.data());
  mask.values.resize(static_cast<std::size_t>(mask.columns) * static_cast<std::size_t>(mask.rows));
  if (dataset->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, mask.columns, mask.rows, mask.values.data(),
                                          mask.columns, mask.rows, GDT_Float32, 0, 0, nullptr) != CE_None)
    return {};
  return mask;
}

struct Region {
  const char* name;
  const char* gmt;  // west/east/south/north, a whole number of steps apart
  geo::BoundingBox box;

  friend void PrintTo(const Region& region, std::ostream* out) { *out << region.name; }
};

class GshhgReaderAgainstGmt : public testing::TestWithParam<Region> {};

TEST_P(GshhgReaderAgainstGmt, AgreesOnLandAndSea) {
  if (!std::filesystem::exists(shoreline))
    GTEST_SKIP() << "install the package gmt-gshhg-full to run this test";
  if (std::system("command -v gmt > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "install the package gmt to run this test";
  const Mask mask = mask_by_gmt(GetParam().gmt);
  ASSERT_GE(mask.values.size(), 20'000U);
  const auto read = read_gshhg(shoreline, GetParam().box);
  ASSERT_TRUE(read.has_value());
  const Land land{*read};

  std::size_t differing = 0;
  for (int row = 0; row < mask.rows; ++row) {
    for (int column = 0; column < mask.columns; ++column) {
      const geo::LonLat place{mask.transform[0] + (column + 0.5) * mask.transform[1],
                              mask.transform[3] + (row + 0.5) * mask.transform[5]};
      const bool by_gmt = mask.values[static_cast<std::size_t>(row * mask.columns + column)] > 0.5F;
      const int pieces = land.pieces_around(place);
      ASSERT_LE(pieces, 1) << "pieces of land overlap at " << place.lon_deg << ' ' << place.lat_deg;
      if ((pieces == 1) != by_gmt) ++differing;
    }
  }

  EXPECT_LT(differing * 1000, mask.values.size());
}

INSTANTIATE_TEST_SUITE_P(
    Regions, GshhgReaderAgainstGmt,
    testing::Values(Region{"DiskoBay", "-54.4937/-50.5137/68.4031/69.5935", {-54.5, 68.4, -50.5, 69.6}},
                    Region{"FinnishLakes", "26.0063/29.9863/61.4031/62.5935", {26.0, 61.4, 30.0, 62.6}}),
    [](const auto& region) { return std::string{region.param.name}; });

}  // namespace
}  // namespace floeplan::ingest::gshhg_reader_test
