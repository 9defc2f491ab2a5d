#include "engine/geo/grid_frame.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests/support/property.hpp"

namespace floeplan::geo::grid_frame_test {
namespace {

struct Golden {
  const char* name;
  GridFrame frame;
  LonLat place;
  GridPoint point;  // by PROJ (gdaltransform 9.1, pyproj 9.5)
};

const Golden goldens[] = {
    {"EPSG:3413",
     PolarStereographicFrame{true, 70.0, -45.0, 0.0, 0.0},
     {-50.0, 69.1},
     {-199453.257, -2279761.159}},
    {"EPSG:3995",
     PolarStereographicFrame{true, 71.0, 0.0, 0.0, 0.0},
     {-50.0, 69.1},
     {-1758330.789, -1475414.717}},
    {"EPSG:3996",
     PolarStereographicFrame{true, 75.0, 0.0, 0.0, 0.0},
     {-50.0, 69.1},
     {-1776763.746, -1490881.804}},
    {"EPSG:3031",
     PolarStereographicFrame{false, -71.0, 0.0, 0.0, 0.0},
     {170.3, -77.8},
     {224156.325, -1311368.515}},
    {"EPSG:32622",
     TransverseMercatorFrame{-51.0, 0.0, 0.9996, 500'000.0, 0.0},
     {-50.5, 69.1},
     {519906.051, 7665593.798}},
    {"EPSG:32734",
     TransverseMercatorFrame{21.0, 0.0, 0.9996, 500'000.0, 10'000'000.0},
     {18.2, -33.9},
     {241084.219, 6245401.470}},
    {"EPSG:32661",
     PolarStereographicFrame{true, 90.0, 0.0, 2e6, 2e6, wgs84, 0.994},
     {-50.0, 83.1},
     {1412479.089, 1507011.421}},
    {"polar stereographic on a sphere",
     PolarStereographicFrame{true, 60.0, -45.0, 0.0, 0.0, {6378273.0, 0.0}},
     {-50.0, 69.1},
     {-191321.445, -2186814.125}},
    {"transverse Mercator on a sphere",
     TransverseMercatorFrame{-51.0, 10.0, 1.0, 200.0, 100.0, {6371229.0, 0.0}},
     {-50.5, 69.1},
     {20034.253, 6572037.226}},
    {"EPSG:3034",
     LambertConformalFrame{35.0, 65.0, 1.0, 52.0, 10.0, 4e6, 2.8e6},
     {5.2, 61.3},
     {3747182.274, 3814889.282}},
    {"EPSG:3978",
     LambertConformalFrame{49.0, 77.0, 1.0, 49.0, -95.0},
     {-62.5, 75.1},
     {884579.696, 3076303.691}},
    {"conformal conic on a sphere",
     LambertConformalFrame{63.0, 63.0, 1.0, 63.0, 15.0, 0.0, 0.0, {6371000.0, 0.0}},
     {2.1, 70.3},
     {-484631.419, 862866.260}},
    {"EPSG:3395",
     LambertConformalFrame{0.0, 0.0, 1.0, 0.0, 0.0},
     {-50.0, 69.1},
     {-5565974.540, 10741953.974}},
    {"EPSG:3832",
     LambertConformalFrame{0.0, 0.0, 1.0, 0.0, 150.0},
     {-170.0, 54.1},
     {4452779.632, 7154480.222}},
    {"EPSG:3857, on a sphere in spite of its name",
     LambertConformalFrame{0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, {6378137.0, 0.0}},
     {-50.0, 69.1},
     {-5565974.540, 10781920.286}},
    {"Mercator true to scale at 41 degrees",
     LambertConformalFrame{41.0, -41.0, 1.0, 0.0, 30.0, 10.0, 20.0},
     {33.3, 43.2},
     {277656.111, 4015735.789}},
    {"EPSG:3338", AlbersFrame{55.0, 65.0, 50.0, -154.0}, {-166.2, 71.4}, {-443209.773, 2418607.178}},
    {"EPSG:6931", AlbersFrame{90.0, 90.0, 90.0, 0.0}, {-50.0, 69.1}, {-1777588.647, -1491573.978}},
    {"EPSG:6932", AlbersFrame{-90.0, -90.0, -90.0, 0.0}, {170.3, -77.8}, {229126.742, -1340446.653}},
    {"EPSG:6933", AlbersFrame{30.0, -30.0, 0.0, 0.0}, {-50.0, 69.1}, {-4824314.013, 6855221.783}},
    {"EPSG:3035",
     AzimuthalEqualAreaFrame{52.0, 10.0, 4'321'000.0, 3'210'000.0},
     {-20.5, 66.3},
     {2993910.990, 5097067.444}},
    {"azimuthal in the south",
     AzimuthalEqualAreaFrame{-60.0, -57.0, 1000.0, -2000.0},
     {-61.5, -64.2},
     {-217592.260, -477460.089}},
};

GridPoint to_grid(const GridFrame& frame, LonLat place) { return FrameProjection{frame}.to_grid(place); }

LonLat to_lon_lat(const GridFrame& frame, GridPoint point) {
  return FrameProjection{frame}.to_lon_lat(point);
}

TEST(GridFrame, AgreesWithProj) {
  for (const Golden& golden : goldens) {
    SCOPED_TRACE(golden.name);
    EXPECT_NEAR(to_grid(golden.frame, golden.place).x, golden.point.x, 0.001);
    EXPECT_NEAR(to_grid(golden.frame, golden.place).y, golden.point.y, 0.001);
  }
}

TEST(GridFrame, ComesBackToThePlaceItStartedFrom) {
  for (const Golden& golden : goldens) {
    SCOPED_TRACE(golden.name);
    const LonLat back = to_lon_lat(golden.frame, to_grid(golden.frame, golden.place));
    EXPECT_NEAR(back.lon_deg, golden.place.lon_deg, 1e-10);
    EXPECT_NEAR(back.lat_deg, golden.place.lat_deg, 1e-10);
  }
}

TEST(GridFrame, KeepsPlacesNearItsCentreAndItsPolesApart) {
  const FrameProjection projection{AzimuthalEqualAreaFrame{.lat_0_deg = 72.0, .lon_0_deg = -20.0}};
  for (const LonLat place : {LonLat{-20.0, 72.0}, LonLat{-20.0, 72.0 + 1e-9}, LonLat{-20.0 + 1e-9, 72.0},
                             LonLat{160.0, 90.0 - 1e-9}, LonLat{70.0, 89.999}, LonLat{-20.0, -89.999}}) {
    const LonLat back = projection.to_lon_lat(projection.to_grid(place));
    EXPECT_NEAR(back.lat_deg, place.lat_deg, 1e-11);
    EXPECT_NEAR(longitude_difference(back.lon_deg, place.lon_deg) * (90.0 - std::abs(place.lat_deg)), 0.0,
                1e-9);
  }
}

TEST(GridFrame, HasNoPlaceBeyondTheRimOfAnAzimuthalMap) {
  const FrameProjection projection{AzimuthalEqualAreaFrame{.lat_0_deg = 52.0, .lon_0_deg = 10.0}};
  EXPECT_FALSE(std::isfinite(projection.to_lon_lat({13e6, 0.0}).lat_deg));
}

TEST(GridFrame, IsCutOppositeItsCentralMeridianIfItIsConicOrCylindrical) {
  EXPECT_EQ(FrameProjection{LambertConformalFrame{.lon_0_deg = -95.0}}.cut_deg(), 85.0);
  EXPECT_EQ((FrameProjection{AlbersFrame{.lat_1_deg = 55.0, .lat_2_deg = 65.0}}.cut_deg()), -180.0);
  EXPECT_EQ((FrameProjection{AlbersFrame{.lat_1_deg = 90.0, .lat_2_deg = 90.0}}.cut_deg()), std::nullopt);
  EXPECT_EQ(FrameProjection{PolarStereographicFrame{}}.cut_deg(), std::nullopt);
}

TEST(GridFrame, RefusesParametersThatNoProjectionHas) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const GridFrame& frame :
       {GridFrame{LambertConformalFrame{.lat_1_deg = 91.0}}, GridFrame{AlbersFrame{.lat_1_deg = nan}},
        GridFrame{TransverseMercatorFrame{.scale_0 = 0.0}},
        GridFrame{PolarStereographicFrame{.ellipsoid = {-1.0, 298.0}}},
        GridFrame{AzimuthalEqualAreaFrame{.lat_0_deg = 90.0}},
        GridFrame{AzimuthalEqualAreaFrame{.lat_0_deg = nan}}})
    EXPECT_THROW(FrameProjection{frame}, std::invalid_argument) << frame_text(frame);
}

TEST(GridFrame, IsReadBackFromItsTextToTheLastBit) {
  support::for_each_seed(100, [](std::mt19937_64& rng) {
    const auto number = [&] { return support::uniform(rng, -1e6, 1e6); };
    const GridFrame frames[] = {
        GeographicFrame{},
        PolarStereographicFrame{rng() % 2 == 0, number(), number(), number(), number()},
        PolarStereographicFrame{true, number(), number(), number(), number(), {number(), number()}},
        PolarStereographicFrame{true, number(), number(), number(), number(), wgs84, number()},
        TransverseMercatorFrame{number(), number(), number(), number(), number()},
        LambertConformalFrame{number(), number(), number(), number(), number(), number(), number()},
        AlbersFrame{number(), number(), number(), number(), number(), number(), {number(), 0.0}},
        AzimuthalEqualAreaFrame{number(), number(), number(), number(), {number(), number()}}};
    for (const GridFrame& frame : frames) EXPECT_EQ(parse_frame(frame_text(frame)), frame);
  });
}

TEST(GridFrame, RefusesTextThatIsNoFrame) {
  for (const char* text :
       {"", "mercator", "polar_stereographic", "polar_stereographic up 70 0 0 0", "transverse_mercator 1 2",
        "lambert_conformal 1 2 3", "albers", "azimuthal_equal_area 1 2 3"}) {
    EXPECT_FALSE(parse_frame(text).has_value()) << text;
  }
}

}  // namespace
}  // namespace floeplan::geo::grid_frame_test
