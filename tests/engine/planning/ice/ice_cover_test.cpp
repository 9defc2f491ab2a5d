#include "engine/planning/ice/ice_cover.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::ice::ice_cover_test {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
const geo::LocalProjection projection{{-53.0, 69.0}};
constexpr plane::PlaneBox area{{-40'000.0, -40'000.0}, {40'000.0, 40'000.0}};

IceCover cover_of(const std::shared_ptr<const ocean::IceField>& ice, const UnderIceRules& rules = {}) {
  return {*ice, rules, projection, area, core::from_unix_seconds(support::sea_start_s)};
}

core::Seconds hours(double count) { return core::Seconds{3600.0 * count}; }

TEST(IceCover, LetsTheVehicleSurfaceUpToTheLimit) {
  UnderIceRules rules;
  rules.max_concentration_to_surface = 0.3;
  const auto at_concentration = [&](double concentration) {
    return cover_of(support::ice_from([=](geo::LonLat, double) { return concentration; }, {0.0}), rules)
        .above({0.0, 0.0}, hours(0.0));
  };

  EXPECT_TRUE(at_concentration(0.0).may_surface);
  EXPECT_TRUE(at_concentration(0.29).may_surface);
  EXPECT_FALSE(at_concentration(0.31).may_surface);
  EXPECT_TRUE(at_concentration(0.31).known);
}

TEST(IceCover, AgreesWithTheFieldItIsMadeOf) {
  support::for_each_seed(100, [](std::mt19937_64& rng) {
    const double phase = support::uniform(rng, 0.0, 6.28);
    const auto ice = support::ice_from(
        [&](geo::LonLat p, double hour) {
          return 0.5 + 0.4 * std::sin(3.0 * p.lon_deg + 5.0 * p.lat_deg + hour + phase);
        },
        {0.0, 10.0, 30.0});
    const geo::PlanePoint point{support::uniform(rng, -30'000.0, 30'000.0),
                                support::uniform(rng, -30'000.0, 30'000.0)};
    const core::Seconds time = hours(support::uniform(rng, 0.0, 30.0));
    const double concentration =
        ice->at(projection.to_lon_lat(point), core::from_unix_seconds(support::sea_start_s) + time)
            ->concentration;

    // The cover's table of coordinates is accurate to a metre, which changes the concentration by less than 1e-4 here.
    UnderIceRules rules;
    rules.max_concentration_to_surface = concentration + 1e-4;
    EXPECT_TRUE(cover_of(ice, rules).above(point, time).may_surface);
    rules.max_concentration_to_surface = concentration - 1e-4;
    EXPECT_FALSE(cover_of(ice, rules).above(point, time).may_surface);
  });
}

TEST(IceCover, HoldsTheFirstAndTheLastStepForThreeDays) {
  const IceCover cover = cover_of(
      support::ice_from([](geo::LonLat, double hour) { return hour < 1.0 ? 0.0 : 1.0; }, {0.0, 24.0}));

  EXPECT_TRUE(cover.above({0.0, 0.0}, hours(-71.0)).may_surface);
  EXPECT_FALSE(cover.above({0.0, 0.0}, hours(-73.0)).known);
  EXPECT_FALSE(cover.above({0.0, 0.0}, hours(24.0 + 71.0)).may_surface);
  EXPECT_TRUE(cover.above({0.0, 0.0}, hours(24.0 + 71.0)).known);
  EXPECT_FALSE(cover.above({0.0, 0.0}, hours(24.0 + 73.0)).known);
}

TEST(IceCover, IsUnknownInALongGapAndKeepsTheKeelsOnBothSidesOfIt) {
  const auto cover_with_gap = [](double before, double after) {
    return cover_of(support::ice_from([=](geo::LonLat, double hour) { return hour < 1.0 ? before : after; },
                                      {0.0, 480.0}, 1.0));
  };
  const IceCover open = cover_with_gap(0.0, 0.0);
  const IceCover closes = cover_with_gap(0.0, 0.9);
  const IceCover opens = cover_with_gap(0.9, 0.0);

  EXPECT_TRUE(open.above({0.0, 0.0}, hours(71.0)).may_surface);
  EXPECT_FALSE(open.above({0.0, 0.0}, hours(73.0)).known);
  EXPECT_EQ(open.above({0.0, 0.0}, hours(240.0)).draft_m, 0.0);
  EXPECT_FALSE(closes.above({0.0, 0.0}, hours(409.0)).may_surface) << "the step after the gap is held";
  for (const IceCover& cover : {closes, opens}) {
    EXPECT_FALSE(cover.above({0.0, 0.0}, hours(240.0)).known);
    EXPECT_EQ(cover.above({0.0, 0.0}, hours(240.0)).draft_m, 8.0);
  }
}

TEST(IceCover, TellsOfWhichKeelsTheDraftIsAssumed) {
  const auto closed = [](geo::LonLat, double) { return 0.9; };
  const IceCover::Keels told = cover_of(support::ice_from(closed, {0.0}, 1.5)).keels({0.0, 0.0}, hours(0.0));
  const IceCover::Keels assumed = cover_of(support::ice_from(closed, {0.0})).keels({0.0, 0.0}, hours(0.0));

  EXPECT_TRUE(told.all_told);
  EXPECT_NEAR(told.told_m, 12.0, 1e-5);
  EXPECT_FALSE(assumed.all_told);
  EXPECT_EQ(assumed.told_m, 0.0);
}

/// A gap in a later step removes no keel: it only means that nothing was observed.
TEST(IceCover, KeepsTheKeelsThatALaterStepDoesNotTellOf) {
  const IceCover cover = cover_of(support::ice_from(
      [](geo::LonLat, double hour) { return hour < 1.0 ? 0.9 : unknown; }, {0.0, 24.0}, 1.0));

  for (const double hour : {1.0, 23.0, 24.0, 90.0, 200.0}) {
    EXPECT_FALSE(cover.above({0.0, 0.0}, hours(hour)).known) << hour;
    EXPECT_EQ(cover.above({0.0, 0.0}, hours(hour)).draft_m, 8.0) << hour;
  }
  EXPECT_EQ(cover.least_way_to_dense_ice({0.0, 0.0}).value, 0.0);
}

TEST(IceCover, KeepsTheKeelsThatWereKnownLast) {
  const IceCover cover = cover_of(
      support::ice_from([](geo::LonLat, double hour) { return hour < 1.0 ? 0.0 : 1.0; }, {0.0, 24.0}, 1.0));

  EXPECT_EQ(cover.above({0.0, 0.0}, hours(-73.0)).draft_m, 0.0);
  EXPECT_EQ(cover.above({0.0, 0.0}, hours(24.0 + 73.0)).draft_m, 8.0);
  EXPECT_FALSE(cover.above({0.0, 0.0}, hours(24.0 + 73.0)).may_surface);
}

TEST(IceCover, KnowsHowFarItIsAtLeastToOpenWaterAndToDenseIce) {
  support::for_each_seed(40, [](std::mt19937_64& rng) {
    const double phase = support::uniform(rng, 0.0, 6.28);
    const IceCover cover = cover_of(support::ice_from(
        [&](geo::LonLat p, double hour) {
          return std::clamp(0.6 + 0.6 * std::sin(5.0 * p.lon_deg + phase) * std::sin(9.0 * p.lat_deg + hour),
                            0.0, 1.0);
        },
        {0.0, 24.0}));
    const auto anywhere = [&] {
      return geo::PlanePoint{support::uniform(rng, -30'000.0, 30'000.0),
                             support::uniform(rng, -30'000.0, 30'000.0)};
    };

    const geo::PlanePoint from = anywhere();
    for (int i = 0; i < 200; ++i) {
      const geo::PlanePoint to = anywhere();
      const IceAbove ice = cover.above(to, hours(support::uniform(rng, 0.0, 24.0)));
      const core::Metres least =
          ice.may_surface ? cover.least_way_to_opening(from) : cover.least_way_to_dense_ice(from);
      EXPECT_LE(least.value, std::hypot(to.x_m - from.x_m, to.y_m - from.y_m));
    }
  });
}

TEST(IceCover, KnowsEightThicknessesOfKeelOrTheAssumedOne) {
  const auto closed = [](geo::LonLat, double) { return 0.9; };

  EXPECT_NEAR(cover_of(support::ice_from(closed, {0.0}, 1.5)).above({0.0, 0.0}, hours(0.0)).draft_m, 12.0,
              1e-5);
  EXPECT_NEAR(cover_of(support::ice_from(closed, {0.0})).above({0.0, 0.0}, hours(0.0)).draft_m, 30.0, 1e-5);
  EXPECT_NEAR(cover_of(support::ice_from(closed, {0.0}, 0.0)).above({0.0, 0.0}, hours(0.0)).draft_m, 30.0,
              1e-5)
      << "dense ice without thickness";
}

TEST(IceCover, ANodeOfLandTakesTheMostIceAroundItOneRingDeep) {
  // Land west of 53 W, ice of the south and open water of the north touch it.
  const IceCover cover = cover_of(support::ice_from(
      [](geo::LonLat p, double) { return p.lon_deg < -53.0   ? unknown
                                         : p.lat_deg < 68.99 ? 0.8
                                                             : 0.0; },
      {0.0}));
  const auto above = [&](double lon_deg, double lat_deg) {
    return cover.above(projection.to_plane({lon_deg, lat_deg}), hours(0.0));
  };

  EXPECT_TRUE(above(-53.05, 69.2).may_surface);
  EXPECT_TRUE(above(-53.05, 68.8).known);
  EXPECT_FALSE(above(-53.05, 68.8).may_surface);
  EXPECT_FALSE(above(-53.25, 69.2).known);
}

}  // namespace
}  // namespace floeplan::planning::ice::ice_cover_test
