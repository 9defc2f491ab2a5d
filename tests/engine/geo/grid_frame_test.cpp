#include "engine/geo/grid_frame.hpp"

#include <gtest/gtest.h>

#include "tests/support/property.hpp"

namespace floeplan::geo::grid_frame_test {
namespace {

struct Golden {
  const char* name;
  GridFrame frame;
  LonLat place;
  GridPoint point;  // by PROJ 9.1 (gdaltransform)
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
};

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

TEST(GridFrame, IsReadBackFromItsTextToTheLastBit) {
  support::for_each_seed(100, [](std::mt19937_64& rng) {
    const auto number = [&] { return support::uniform(rng, -1e6, 1e6); };
    const GridFrame frames[] = {
        GeographicFrame{}, PolarStereographicFrame{rng() % 2 == 0, number(), number(), number(), number()},
        PolarStereographicFrame{true, number(), number(), number(), number(), {number(), number()}},
        TransverseMercatorFrame{number(), number(), number(), number(), number()}};
    for (const GridFrame& frame : frames) EXPECT_EQ(parse_frame(frame_text(frame)), frame);
  });
}

TEST(GridFrame, RefusesTextThatIsNoFrame) {
  for (const char* text : {"", "mercator", "polar_stereographic", "polar_stereographic up 70 0 0 0",
                           "transverse_mercator 1 2"}) {
    EXPECT_FALSE(parse_frame(text).has_value()) << text;
  }
}

}  // namespace
}  // namespace floeplan::geo::grid_frame_test
