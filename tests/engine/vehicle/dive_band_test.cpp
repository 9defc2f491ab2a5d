#include "engine/vehicle/dive_band.hpp"

#include <gtest/gtest.h>

namespace floeplan::vehicle::dive_band_test {
namespace {

constexpr DiveLimits limits{.climb_to = {5.0}, .dive_to = {200.0}, .altimeter_margin = {10.0}};

TEST(FlownBand, IsWhatWasAskedForInDeepWater) {
  EXPECT_EQ(flown_band(limits, core::Metres{500.0}), (DiveBand{{5.0}, {200.0}}));
  EXPECT_EQ(flown_band(limits, std::nullopt), (DiveBand{{5.0}, {200.0}}));
}

TEST(FlownBand, EndsAtTheMarginAboveABank) {
  EXPECT_EQ(flown_band(limits, core::Metres{60.0}), (DiveBand{{5.0}, {50.0}}));
  EXPECT_EQ(flown_band(limits, core::Metres{210.0}), (DiveBand{{5.0}, {200.0}}));
}

TEST(FlownBand, IsNeverThinnerThanTheLowestTooth) {
  EXPECT_EQ(flown_band(limits, core::Metres{12.0}), (DiveBand{{5.0}, {7.0}}));
  EXPECT_EQ(flown_band(limits, core::Metres{-3.0}), (DiveBand{{5.0}, {7.0}}));
}

}  // namespace
}  // namespace floeplan::vehicle::dive_band_test
