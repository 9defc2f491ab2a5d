#include "engine/mission/document/packed_degrees.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests/engine/mission/list_reader.hpp"
#include "tests/support/property.hpp"

namespace floeplan::mission::packed_degrees_test {
namespace {

TEST(PackedDegrees, HoldWholeDegreesAndMinutes) {
  EXPECT_EQ(packed_degrees(-73.8), "-7348.0000");
  EXPECT_EQ(packed_degrees(39.0 + 17.0 / 60.0), "3917.0000");
  EXPECT_EQ(packed_degrees(-70.0 - 32.0640 / 60.0), "-7032.0640");
  EXPECT_EQ(packed_degrees(151.25), "15115.0000");
}

TEST(PackedDegrees, KeepTheSignBelowOneDegree) {
  EXPECT_EQ(packed_degrees(-0.5), "-0030.0000");
  EXPECT_EQ(packed_degrees(-1e-5), "-0000.0006");
}

TEST(PackedDegrees, HaveNoSignAtZero) {
  EXPECT_EQ(packed_degrees(0.0), "0000.0000");
  EXPECT_EQ(packed_degrees(-0.0), "0000.0000");
  EXPECT_EQ(packed_degrees(-1e-9), "0000.0000");
}

TEST(PackedDegrees, CarrySixtyMinutesOverToTheNextDegree) {
  EXPECT_EQ(packed_degrees(44.99999999), "4500.0000");
  EXPECT_EQ(packed_degrees(-0.99999999), "-0100.0000");
}

TEST(PackedDegrees, WriteTheAntimeridianInOneWay) {
  EXPECT_EQ(packed_degrees(180.0), "18000.0000");
  EXPECT_EQ(packed_degrees(-180.0), "18000.0000");
  EXPECT_EQ(packed_degrees(-179.99999999), "18000.0000");
  EXPECT_EQ(packed_degrees(-179.9999), "-17959.9940");
}

TEST(PackedDegrees, RefuseWhatIsNoAngle) {
  EXPECT_THROW((void)packed_degrees(180.1), std::invalid_argument);
  EXPECT_THROW((void)packed_degrees(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  EXPECT_THROW((void)packed_degrees(std::numeric_limits<double>::infinity()), std::invalid_argument);
}

TEST(PackedDegrees, ReadBackWithinHalfOfTheirLastDigit) {
  support::for_each_seed(2000, [](std::mt19937_64& rng) {
    const double near_whole =
        std::round(support::uniform(rng, -179.0, 179.0)) + support::uniform(rng, -1e-6, 1e-6);
    for (const double angle_deg : {support::uniform(rng, -179.99, 179.99), near_whole}) {
      EXPECT_NEAR(support::degrees_of_packed(packed_degrees(angle_deg)), angle_deg, 0.5001e-4 / 60.0);
    }
  });
}

}  // namespace
}  // namespace floeplan::mission::packed_degrees_test
