#include "storage/ingest/notation/cf_units.hpp"

#include <gtest/gtest.h>

namespace floeplan::ingest::cf_units_test {
namespace {

TEST(SpeedFactor, KnowsEverySpellingOfMetresPerSecond) {
  for (const char* unit :
       {"m s-1", "ms-1", "m/s", "m s^-1", "m.s-1", "m s**-1", "m/sec", "meter second-1", "meters second-1",
        "metre second-1", "meters/second", "meters s-1", "Meters per second"})
    EXPECT_EQ(speed_factor(unit), 1.0) << unit;
}

TEST(SpeedFactor, ConvertsOtherSpeeds) {
  EXPECT_DOUBLE_EQ(*speed_factor("cm/s"), 0.01);
  EXPECT_DOUBLE_EQ(*speed_factor("cm s-1"), 0.01);
  EXPECT_DOUBLE_EQ(*speed_factor("centimeter second-1"), 0.01);
  EXPECT_DOUBLE_EQ(*speed_factor("mm/s"), 0.001);
  EXPECT_DOUBLE_EQ(*speed_factor("km/h"), 1.0 / 3.6);
  EXPECT_DOUBLE_EQ(*speed_factor("km h-1"), 1.0 / 3.6);
  EXPECT_DOUBLE_EQ(*speed_factor("m day-1"), 1.0 / 86400.0);
  EXPECT_DOUBLE_EQ(*speed_factor("knots"), 1852.0 / 3600.0);
  EXPECT_DOUBLE_EQ(*speed_factor("kt"), 1852.0 / 3600.0);
}

TEST(SpeedFactor, RefusesWhatIsNoSpeed) {
  for (const char* unit : {"", "m", "s-1", "m2 s-1", "degrees", "1", "furlong/fortnight", "m s-2", "K"})
    EXPECT_FALSE(speed_factor(unit).has_value()) << unit;
}

TEST(LengthFactor, KnowsMetresAndTheirRelatives) {
  EXPECT_EQ(length_factor("METERS"), 1.0);
  EXPECT_EQ(length_factor("m"), 1.0);
  EXPECT_EQ(length_factor("km"), 1000.0);
  EXPECT_EQ(length_factor("fathoms"), 1.8288);
  EXPECT_EQ(length_factor("international_feet"), 0.3048);
  EXPECT_EQ(length_factor("yards"), 0.9144);
  EXPECT_EQ(length_factor("nautical_mile"), 1852.0);
  EXPECT_FALSE(length_factor("nm").has_value());  // a nanometre by UDUNITS
  EXPECT_FALSE(length_factor("dbar").has_value());
  EXPECT_FALSE(length_factor("sigma").has_value());
}

TEST(Degrees, AreEastOrNorthInTheSpellingsOfTheConventions) {
  EXPECT_TRUE(is_degrees_east("degrees_east"));
  EXPECT_TRUE(is_degrees_east("degrees_E"));
  EXPECT_TRUE(is_degrees_north("degree_north"));
  EXPECT_TRUE(is_degrees_north("degreesN"));
  EXPECT_FALSE(is_degrees_east("degrees"));
  EXPECT_FALSE(is_degrees_north("degrees_east"));
}

TEST(CfUnits, LengthsMayBeMultiplesOfAUnit) {
  EXPECT_EQ(length_factor("100 km"), 1e5);
  EXPECT_EQ(length_factor("100  km"), 1e5);
  EXPECT_FALSE(length_factor("0 km").has_value());
  EXPECT_FALSE(length_factor("100").has_value());
}

}  // namespace
}  // namespace floeplan::ingest::cf_units_test
