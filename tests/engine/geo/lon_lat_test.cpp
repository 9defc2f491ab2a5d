#include "engine/geo/lon_lat.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/geo/written_place.hpp"
#include "tests/support/property.hpp"

namespace floeplan::geo::lon_lat_test {
namespace {

TEST(Longitude, WrapsIntoTheHalfOpenCircle) {
  EXPECT_EQ(wrap_longitude(180.0), -180.0);
  EXPECT_EQ(wrap_longitude(-180.0), -180.0);
  EXPECT_EQ(wrap_longitude(190.0), -170.0);
  EXPECT_EQ(wrap_longitude(-190.0), 170.0);
  EXPECT_EQ(wrap_longitude(0.1), 0.1) << "to the bit";
  EXPECT_EQ(wrap_longitude(360.0), 0.0);
  EXPECT_EQ(wrap_longitude(-53.5), -53.5);
}

TEST(Longitude, DiffersTheShortWayRound) {
  EXPECT_EQ(longitude_difference(179.0, -179.0), 2.0);
  EXPECT_EQ(longitude_difference(-179.0, 179.0), -2.0);
  EXPECT_EQ(longitude_difference(10.0, 350.0), -20.0);
  EXPECT_EQ(longitude_difference(0.0, 180.0), -180.0);
}

TEST(Longitude, WrapsToTheSameMeridian) {
  support::for_each_seed(1000, [](std::mt19937_64& rng) {
    const double lon_deg = support::uniform(rng, -1000.0, 1000.0);
    const double wrapped_deg = wrap_longitude(lon_deg);

    EXPECT_GE(wrapped_deg, -180.0);
    EXPECT_LT(wrapped_deg, 180.0);
    EXPECT_NEAR(std::remainder(wrapped_deg - lon_deg, 360.0), 0.0, 1e-9);
  });
}

TEST(Place, IsValidOnTheGlobeInBothConventionsOfLongitude) {
  EXPECT_TRUE(is_valid({-180.0, -90.0}));
  EXPECT_TRUE(is_valid({360.0, 90.0}));
  EXPECT_FALSE(is_valid({-180.1, 0.0}));
  EXPECT_FALSE(is_valid({360.1, 0.0}));
  EXPECT_FALSE(is_valid({0.0, 90.1}));
  EXPECT_FALSE(is_valid({std::numeric_limits<double>::quiet_NaN(), 0.0}));
  EXPECT_FALSE(is_valid({0.0, std::numeric_limits<double>::infinity()}));
}

TEST(WrittenPlace, IsTheSameHoweverItsLongitudeIsCounted) {
  support::for_each_seed(1000, [](std::mt19937_64& rng) {
    const double lon_deg = support::uniform(rng, -180.0, 180.0);
    const double lat_deg = support::uniform(rng, -90.0, 90.0);
    for (const double turn : {-360.0, 0.0, 360.0}) {
      const auto place = written_place(lon_deg + turn, lat_deg);
      if (std::abs(lon_deg + turn) > 360.0) {
        EXPECT_FALSE(place.has_value());
      } else {
        ASSERT_TRUE(place.has_value());
        EXPECT_NEAR(place->lon_deg, lon_deg, 1e-9);
        EXPECT_EQ(place->lat_deg, lat_deg);
      }
    }
  });
  EXPECT_FALSE(written_place(0.0, 90.1).has_value());
  EXPECT_FALSE(written_place(std::numeric_limits<double>::quiet_NaN(), 0.0).has_value());
}

TEST(WrittenAngles, AreDegreesAndMinutesOfOneWidth) {
  EXPECT_EQ(latitude_text(67.2), "67°12.000′N");
  EXPECT_EQ(latitude_text(-5.5), "05°30.000′S");
  EXPECT_EQ(longitude_text(-53.2), "053°12.000′W");
  EXPECT_EQ(longitude_text(190.25), "169°45.000′W");
}

TEST(WrittenAngles, CarryFullMinutesIntoTheDegrees) {
  EXPECT_EQ(latitude_text(69.9999999), "70°00.000′N");
  EXPECT_EQ(longitude_text(12.99999999), "013°00.000′E");
}

}  // namespace
}  // namespace floeplan::geo::lon_lat_test
