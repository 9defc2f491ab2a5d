#include "engine/core/units.hpp"

#include <gtest/gtest.h>

#include <type_traits>

namespace floeplan::core::units_test {
namespace {

template <class A, class B>
concept Addable = requires(A a, B b) { a + b; };
template <class A, class B>
concept Multipliable = requires(A a, B b) { a* b; };

TEST(Units, HaveAnOperatorOnlyWhereTheDimensionIsRight) {
  EXPECT_TRUE((Addable<Metres, Metres>));
  EXPECT_FALSE((Addable<Metres, MetresPerSecond>));
  EXPECT_FALSE((Multipliable<Metres, Metres>));
  EXPECT_FALSE((Addable<UtcTime, UtcTime>));
  EXPECT_FALSE((std::is_convertible_v<double, Metres>));
}

TEST(Units, DivideADistanceByASpeedIntoATime) {
  EXPECT_DOUBLE_EQ((Metres{700.0} / MetresPerSecond{0.35}).count(), 2000.0);
  EXPECT_DOUBLE_EQ(Metres{700.0} / Metres{350.0}, 2.0);
}

TEST(Units, CountPosixSecondsFromTheEpoch) {
  EXPECT_EQ(unix_seconds(UtcTime{std::chrono::sys_days{std::chrono::January / 2 / 1970}}), 86'400.0);
  EXPECT_EQ(unix_seconds(from_unix_seconds(1.25)), 1.25);
}

TEST(Units, TurnDegreesIntoRadiansAndBack) {
  EXPECT_DOUBLE_EQ(degrees_to_radians(180.0), std::numbers::pi);
  EXPECT_DOUBLE_EQ(radians_to_degrees(degrees_to_radians(37.5)), 37.5);
}

}  // namespace
}  // namespace floeplan::core::units_test
