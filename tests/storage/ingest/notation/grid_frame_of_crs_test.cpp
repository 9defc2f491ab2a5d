#include "storage/ingest/notation/grid_frame_of_crs.hpp"

#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <string>
#include <vector>

#include "storage/ingest/common/prepared_dataset.hpp"

namespace floeplan::ingest::grid_frame_of_crs_test {
namespace {

std::optional<geo::GridFrame> frame_of(const std::string& text) {
  OGRSpatialReference crs;
  EXPECT_EQ(crs.SetFromUserInput(text.c_str()), OGRERR_NONE) << text;
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return grid_frame_of(crs);
}

ocean::HorizontalGrid grid_in(const geo::GridFrame& frame, double first_x, double first_y, double step) {
  std::vector<double> x;
  std::vector<double> y;
  for (int i = 0; i < 41; ++i) {
    x.push_back(first_x + step * i);
    y.push_back(first_y + step * i);
  }
  return {frame, ocean::Axis{std::move(x)}, ocean::Axis{std::move(y)}};
}

/// Whether the frame puts places where PROJ does is checked by grid_frame_of itself.
TEST(GridFrameOfCrs, KnowsTheProjectionsOfHydrography) {
  for (const char* crs : {"EPSG:32622",
                          "EPSG:3413",
                          "EPSG:32661",
                          "EPSG:32761",
                          "EPSG:3034",
                          "EPSG:3035",
                          "EPSG:3338",
                          "EPSG:6931",
                          "EPSG:6932",
                          "EPSG:6933",
                          "EPSG:3395",
                          "EPSG:3857",
                          "EPSG:3832",
                          "EPSG:2154",
                          "EPSG:3978",
                          "EPSG:9354",
                          "+proj=merc +lat_ts=41 +lon_0=30 +datum=WGS84",
                          "+proj=lcc +lat_1=63 +lat_0=63 +lon_0=15 +R=6371000",
                          "+proj=stere +lat_0=90 +lat_ts=60 +lon_0=-45 +R=6378273",
                          "+proj=laea +lat_0=0 +lon_0=10 +R=6371229"})
    EXPECT_TRUE(frame_of(crs).has_value()) << crs;
  EXPECT_EQ(frame_of("EPSG:3857"),
            (geo::GridFrame{geo::LambertConformalFrame{.ellipsoid = {geo::wgs84.semi_major_m, 0.0}}}));
}

TEST(GridFrameOfCrs, LeavesOtherDatumsMethodsAndUnitsToProj) {
  for (const char* crs : {"EPSG:27700", "EPSG:23031", "EPSG:28992", "EPSG:26931", "EPSG:2048", "EPSG:2225",
                          "+proj=aeqd +lat_0=70 +lon_0=-50 +datum=WGS84", "+proj=utm +zone=22 +ellps=intl",
                          "+proj=tmerc +lon_0=3 +pm=paris +datum=WGS84",
                          "+proj=ob_tran +o_proj=longlat +o_lon_p=0 +o_lat_p=25 +lon_0=-40 +datum=WGS84",
                          "+proj=longlat +R=6371000"})
    EXPECT_FALSE(frame_of(crs).has_value()) << crs;
}

TEST(GridFrameOfCrs, AGridLiesInItsProjectionIfEveryNodeHasAPlaceOfItsOwn) {
  const geo::LambertConformalFrame mercator;
  const geo::LambertConformalFrame conic{.lat_1_deg = 77.5, .lat_2_deg = 77.5, .lat_0_deg = 77.5};
  const geo::AzimuthalEqualAreaFrame azimuthal{.lat_0_deg = 52.0, .lon_0_deg = 10.0};
  const geo::PolarStereographicFrame polar{.lat_ts_deg = 70.0};

  EXPECT_TRUE(lies_in_projection(grid_in(mercator, -20.0e6, -10.0e6, 0.5e6)));
  EXPECT_FALSE(lies_in_projection(grid_in(mercator, 10.0e6, -10.0e6, 0.5e6))) << "across its cut";
  EXPECT_TRUE(lies_in_projection(grid_in(conic, -1.0e6, -1.5e6, 50'000.0)));
  EXPECT_FALSE(lies_in_projection(grid_in(conic, -1.0e6, 0.5e6, 50'000.0)))
      << "round the pole, across its cut";
  EXPECT_TRUE(lies_in_projection(grid_in(polar, -1.0e6, -1.0e6, 50'000.0))) << "round the pole";
  EXPECT_TRUE(lies_in_projection(grid_in(azimuthal, -2.0e6, -2.0e6, 100'000.0)));
  EXPECT_FALSE(lies_in_projection(grid_in(azimuthal, -10.0e6, -10.0e6, 0.5e6))) << "beyond its rim";
}

TEST(GridFrameOfCrs, OnlyGridsThatOlderVersionsHadKeepTheirIds) {
  for (const char* crs : {"EPSG:4326", "EPSG:32622", "EPSG:3413", "EPSG:3411"})
    EXPECT_EQ(keeping_on(frame_of(crs).value()), Keeping::on_a_grid) << crs;
  for (const char* crs : {"EPSG:32661", "EPSG:26917", "EPSG:3035", "EPSG:3338", "EPSG:3395",
                          "+proj=stere +lat_0=90 +lat_ts=60 +lon_0=-45 +R=6378273",
                          "+proj=tmerc +lon_0=9 +k=0.9996 +R=6371000"})
    EXPECT_EQ(keeping_on(frame_of(crs).value()), Keeping::on_a_projected_grid) << crs;
}

}  // namespace
}  // namespace floeplan::ingest::grid_frame_of_crs_test
