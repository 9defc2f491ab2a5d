#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "engine/core/utc_text.hpp"
#include "engine/geo/geodesic.hpp"
#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/readers/coastline/gshhg_reader.hpp"
#include "tests/storage/demo/demo_files.hpp"
#include "tests/support/places.hpp"

namespace floeplan::demo::disko_demo_test {
namespace {

class DiskoDemo : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_shoreline()) GTEST_SKIP() << "install the package gmt-gshhg-full to run this test";
    files_ = demo_files(Scenario::disko, 1, "disko");
  }

  [[nodiscard]] const std::filesystem::path& bathymetry() const { return files_[0]; }
  [[nodiscard]] const std::filesystem::path& currents() const { return files_[1]; }
  [[nodiscard]] const std::filesystem::path& ice() const { return files_[2]; }
  [[nodiscard]] const std::filesystem::path& icebergs() const { return files_[3]; }
  [[nodiscard]] const std::filesystem::path& coastline() const { return files_[4]; }

  std::vector<std::filesystem::path> files_;
};

/// The whole relief, north up.
struct Elevation {
  std::array<double, 6> transform{};
  int columns{};
  int rows{};
  std::vector<float> metres;

  [[nodiscard]] double at(double lon_deg, double lat_deg) const {
    const int column = static_cast<int>((lon_deg - transform[0]) / transform[1]);
    const int row = static_cast<int>((lat_deg - transform[3]) / transform[5]);
    return static_cast<double>(metres[static_cast<std::size_t>(row * columns + column)]);
  }
};

Elevation read_elevation(GDALDataset& dataset) {
  Elevation elevation{{}, dataset.GetRasterXSize(), dataset.GetRasterYSize(), {}};
  dataset.GetGeoTransform(elevation.transform.data());
  elevation.metres.resize(static_cast<std::size_t>(elevation.columns) *
                          static_cast<std::size_t>(elevation.rows));
  EXPECT_EQ(dataset.GetRasterBand(1)->RasterIO(GF_Read, 0, 0, elevation.columns, elevation.rows,
                                               elevation.metres.data(), elevation.columns, elevation.rows,
                                               GDT_Float32, 0, 0, nullptr),
            CE_None);
  return elevation;
}

std::unique_ptr<GDALDataset> open_raster(const std::filesystem::path& file) {
  ingest::register_drivers();
  return std::unique_ptr<GDALDataset>{GDALDataset::Open(file.c_str(), GDAL_OF_RASTER)};
}

TEST_F(DiskoDemo, WritesTheSameBytesForTheSameSeedAndOthersForAnother) {
  const auto again = demo_files(Scenario::disko, 1, "disko again");
  const auto other = demo_files(Scenario::disko, 2, "disko other");

  for (std::size_t i = 0; i < files_.size(); ++i)
    EXPECT_EQ(bytes_of(files_[i]), bytes_of(again[i])) << files_[i];
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NE(bytes_of(files_[i]), bytes_of(other[i])) << files_[i];
  EXPECT_EQ(bytes_of(coastline()), bytes_of(other[4]));
}

TEST_F(DiskoDemo, WritesTheFilesThatItWroteFromTheBeginning) {
  // Speeds and routes are compared over time on exactly these files.
  const auto kept = std::filesystem::path{support::source_folder()} / "../shared/data/disko";
  if (!std::filesystem::exists(kept / "README.txt")) GTEST_SKIP() << "the kept files are not here: " << kept;

  for (const std::filesystem::path& file : files_)
    EXPECT_EQ(bytes_of(file), bytes_of(kept / file.filename())) << file;
  EXPECT_EQ(bytes_of(coastline().parent_path() / "README.txt"), bytes_of(kept / "README.txt"));
}

TEST_F(DiskoDemo, SaysInEveryFileThatItIsSyntheticAndNotForNavigation) {
  for (const std::filesystem::path& file : {bathymetry(), currents(), icebergs()}) {
    EXPECT_NE(file.filename().string().find("synthetic"), std::string::npos);
    const std::string bytes = bytes_of(file);
    EXPECT_NE(bytes.find("ynthetic, not for navigation"), std::string::npos) << file;
  }
  EXPECT_NE(bytes_of(coastline()).find("GSHHG, Wessel and Smith 1996, LGPL"), std::string::npos);
  EXPECT_NE(bytes_of(coastline().parent_path() / "README.txt").find("NOT FOR NAVIGATION"), std::string::npos);
}

TEST_F(DiskoDemo, PlacesTheReliefInWgs84WithTheFeaturesOfTheBay) {
  const auto dataset = open_raster(bathymetry());
  ASSERT_TRUE(dataset);
  const Elevation elevation = read_elevation(*dataset);

  EXPECT_STREQ(dataset->GetSpatialRef()->GetAuthorityCode(nullptr), "4326");
  EXPECT_NEAR(elevation.transform[0], -54.5, 1e-9);
  EXPECT_NEAR(elevation.transform[3], 69.6, 1e-9);
  EXPECT_NEAR(-elevation.at(-51.10, 69.16), 225.0, 30.0);   // sill
  EXPECT_NEAR(-elevation.at(-50.90, 69.15), 750.0, 100.0);  // icefjord
  EXPECT_NEAR(-elevation.at(-52.40, 69.02), 450.0, 100.0);  // trough
  EXPECT_LT(elevation.at(-53.85, 68.82), -550.0);           // Egedesminde deep
  EXPECT_GT(elevation.at(-53.00, 69.50), 100.0);            // Disko island
}

TEST_F(DiskoDemo, HasCurrentsThatStayOffTheLandAndBelowOneMetrePerSecond) {
  const Component east = read_component(currents(), "uo");
  const Component north = read_component(currents(), "vo");
  const auto land = ingest::read_gshhg("/usr/share/gmt-gshhg/binned_GSHHS_f.nc", {-54.5, 68.4, -50.5, 69.6});
  ASSERT_TRUE(land.has_value());
  std::vector<geo::BoundingBox> boxes;
  for (const geo::Polygon& piece : *land) boxes.push_back(geo::bounding_box(piece));

  ASSERT_EQ(east.times_s.size(), 145U);
  EXPECT_EQ(east.times_s.front(), core::unix_seconds(first_hour));
  EXPECT_LT(std::filesystem::file_size(currents()), 40'000'000U);
  double fastest_m_s = 0.0;
  for (std::size_t i = 0; i < east.m_s.size(); ++i) {
    ASSERT_EQ(std::isfinite(east.m_s[i]), std::isfinite(north.m_s[i]));
    if (std::isfinite(east.m_s[i]))
      fastest_m_s = std::max(fastest_m_s, std::hypot(east.m_s[i], north.m_s[i]));
  }
  EXPECT_LE(fastest_m_s, 1.0);
  EXPECT_GT(fastest_m_s, 0.4);

  for (std::size_t row = 0; row < east.lat_deg.size(); row += 3) {
    for (std::size_t column = 0; column < east.lon_deg.size(); column += 3) {
      if (!std::isfinite(east.at(0, 0, row, column))) continue;
      const geo::LonLat place{east.lon_deg[column], east.lat_deg[row]};
      for (std::size_t k = 0; k < land->size(); ++k)
        ASSERT_FALSE(geo::contains(boxes[k], place) && geo::contains((*land)[k], place))
            << place.lon_deg << ' ' << place.lat_deg;
    }
  }
}

TEST_F(DiskoDemo, HasATideOverTheSillThatTurnsEverySixHours) {
  const Component east = read_component(currents(), "uo");
  constexpr std::size_t row = 76;      // 69.16 N
  constexpr std::size_t column = 136;  // 51.10 W
  constexpr std::size_t depth = 3;     // 100 m, below the outflow
  ASSERT_NEAR(east.lat_deg[row], 69.16, 1e-9);
  ASSERT_NEAR(east.lon_deg[column], -51.10, 1e-9);
  double mean = 0.0;
  for (std::size_t hour = 0; hour < 145; ++hour) mean += east.at(hour, depth, row, column) / 145.0;

  std::vector<double> turns;
  double strongest = 0.0;
  for (std::size_t hour = 1; hour < 145; ++hour) {
    const double before = east.at(hour - 1, depth, row, column) - mean;
    const double after = east.at(hour, depth, row, column) - mean;
    strongest = std::max(strongest, std::abs(after));
    if ((before < 0.0) != (after < 0.0))
      turns.push_back(static_cast<double>(hour) - after / (after - before));
  }

  EXPECT_GT(strongest, 0.15);
  EXPECT_LE(strongest, 0.36);
  ASSERT_GE(turns.size(), 20U);
  EXPECT_NEAR((turns.back() - turns.front()) / static_cast<double>(turns.size() - 1), 6.2, 0.1);
}

TEST_F(DiskoDemo, ScattersSixtyIcebergsInWaterDeepEnoughForTheirDraft) {
  const auto document = nlohmann::json::parse(bytes_of(icebergs()));
  const auto dataset = open_raster(bathymetry());
  const Elevation elevation = read_elevation(*dataset);

  ASSERT_EQ(document["features"].size(), 60U);
  for (const auto& feature : document["features"]) {
    const double lon = feature["geometry"]["coordinates"][0];
    const double lat = feature["geometry"]["coordinates"][1];
    const auto& berg = feature["properties"];
    EXPECT_GE(-elevation.at(lon, lat), berg["draft_m"].get<double>()) << berg["id"];
    EXPECT_GE(berg["length_m"].get<double>(), 20.0);
    EXPECT_LE(berg["length_m"].get<double>(), 600.0);
    const auto observed = core::parse_iso8601(berg["observed"].get<std::string>());
    ASSERT_TRUE(observed.has_value());
    EXPECT_LE(*observed, first_hour);
    EXPECT_GE(*observed, first_hour - core::Seconds{20.0 * 3600.0});
  }
}

TEST_F(DiskoDemo, LeavesTheUsualWayAcrossTheBayPassable) {
  const auto document = nlohmann::json::parse(bytes_of(icebergs()));

  int close = 0;
  for (const auto& feature : document["features"]) {
    const double lon = feature["geometry"]["coordinates"][0];
    const double lat = feature["geometry"]["coordinates"][1];
    const geo::LonLat nearest{std::clamp(lon, -53.2, -51.6), 69.2};
    if (geo::geodesic_between({lon, lat}, nearest).length.value < 6900.0) ++close;
  }

  EXPECT_LE(close, 1);
}

}  // namespace
}  // namespace floeplan::demo::disko_demo_test
