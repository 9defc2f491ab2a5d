#include "engine/planning/ice/ice_covers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::ice::ice_covers_test {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr plane::PlaneBox area{{-40'000.0, -40'000.0}, {40'000.0, 40'000.0}};
constexpr double concentration_that_closes = 0.9;

using Field = std::shared_ptr<const ocean::IceField>;

core::Seconds hours(double count) { return core::Seconds{3600.0 * count}; }

/// Ice of one concentration everywhere, from one hour to another.
Field even_ice(double concentration, double from_hour, double until_hour) {
  return support::ice_from([=](geo::LonLat, double) { return concentration; }, {from_hour, until_hour}, 1.0);
}

IceCovers covers_of(Field first, std::vector<Field> others) {
  const ocean::Environment environment{.ice = std::move(first), .further_ice = std::move(others)};
  return {environment, UnderIceRules{}, geo::LocalProjection{{-53.0, 69.0}}, area,
          core::from_unix_seconds(support::sea_start_s)};
}

/// Open water in data that were ingested last but begin two days later says nothing about today.
TEST(IceCovers, AskThoseThatSpeakForTheTimeBeforeNewerOnesThatAreHeld) {
  const IceCovers covers =
      covers_of(even_ice(0.0, 48.0, 96.0), {even_ice(concentration_that_closes, -24.0, 96.0)});

  EXPECT_FALSE(covers.above({0.0, 0.0}, hours(0.0)).may_surface);
  EXPECT_EQ(covers.above({0.0, 0.0}, hours(0.0)).draft_m, 8.0);
  EXPECT_TRUE(covers.above({0.0, 0.0}, hours(47.0)).may_surface) << "half a day before its first step";
  EXPECT_TRUE(covers.above({0.0, 0.0}, hours(96.0)).may_surface);
}

TEST(IceCovers, HoldWhatNoneSpeaksFor) {
  const IceCovers covers =
      covers_of(even_ice(0.0, 0.0, 1.0), {even_ice(concentration_that_closes, -24.0, -23.0)});

  EXPECT_TRUE(covers.above({0.0, 0.0}, hours(60.0)).may_surface) << "the first of those that are held";
  EXPECT_FALSE(covers.above({0.0, 0.0}, hours(100.0)).known);
  EXPECT_EQ(covers.above({0.0, 0.0}, hours(100.0)).draft_m, 8.0) << "the deepest keel known last";
}

TEST(IceCovers, AskTheNextWhereTheFirstKnowsNothing) {
  const Field in_the_west = support::ice_from(
      [](geo::LonLat p, double) { return p.lon_deg < -53.3 ? 0.0 : unknown; }, {0.0, 24.0}, 1.0);
  const IceCovers covers = covers_of(in_the_west, {even_ice(concentration_that_closes, 0.0, 24.0)});

  EXPECT_TRUE(covers.above({-30'000.0, 0.0}, hours(1.0)).may_surface);
  EXPECT_FALSE(covers.above({30'000.0, 0.0}, hours(1.0)).may_surface);
  EXPECT_TRUE(covers.above({30'000.0, 0.0}, hours(1.0)).known);
}

/// Outside its last node a product uses that node. A product that has data there takes precedence.
TEST(IceCovers, AskForDataBeforeWhatIsExtendedToACoast) {
  const Field in_the_west = support::ice_from(
      [](geo::LonLat p, double) { return p.lon_deg < -53.05 ? 0.0 : unknown; }, {0.0, 24.0}, 1.0);
  const geo::PlanePoint beside{-1'200.0, 0.0};  // between the last node with data, at 53.1 W, and the next

  EXPECT_TRUE(covers_of(in_the_west, {}).above(beside, hours(1.0)).may_surface);
  EXPECT_FALSE(covers_of(in_the_west, {even_ice(concentration_that_closes, 0.0, 24.0)})
                   .above(beside, hours(1.0))
                   .may_surface);
}

/// A chart that was added later lies among daily data of the whole period.
TEST(IceCovers, AskDataOfTheTimeItselfBeforeANewerStepThatIsNear) {
  const Field daily = support::ice_from([](geo::LonLat, double) { return concentration_that_closes; },
                                        {-48.0, -24.0, 0.0, 24.0, 48.0}, 1.0);
  const Field chart = support::ice_from([](geo::LonLat, double) { return 0.0; }, {-18.0}, 1.0);
  const IceCovers covers = covers_of(chart, {daily});

  EXPECT_TRUE(covers.above({0.0, 0.0}, hours(-18.0)).may_surface) << "the chart's own time";
  for (const double hour : {-17.0, 1.0, 5.0, 40.0})
    EXPECT_FALSE(covers.above({0.0, 0.0}, hours(hour)).may_surface) << hour;
}

/// The order in which charts of single days were stored does not matter.
TEST(IceCovers, AskTheNearestOfTheChartsOfSingleDays) {
  const Field first_day = support::ice_from([](geo::LonLat, double) { return 0.0; }, {-18.0}, 1.0);
  const Field next_day =
      support::ice_from([](geo::LonLat, double) { return concentration_that_closes; }, {6.0}, 1.0);

  for (const IceCovers& covers : {covers_of(first_day, {next_day}), covers_of(next_day, {first_day})}) {
    EXPECT_TRUE(covers.above({0.0, 0.0}, hours(-7.0)).may_surface);
    EXPECT_FALSE(covers.above({0.0, 0.0}, hours(-5.0)).may_surface);
    EXPECT_FALSE(covers.above({0.0, 0.0}, hours(5.9)).may_surface);
  }
}

TEST(IceCovers, AskOthersInALongGapOfTheFirst) {
  const Field with_gap = even_ice(0.0, -240.0, 240.0);
  const Field daily = support::ice_from([](geo::LonLat, double) { return concentration_that_closes; },
                                        {-48.0, -24.0, 0.0, 24.0, 48.0}, 1.0);

  EXPECT_FALSE(covers_of(with_gap, {daily}).above({0.0, 0.0}, hours(1.0)).may_surface);
  EXPECT_TRUE(covers_of(with_gap, {daily}).above({0.0, 0.0}, hours(1.0)).known);
  EXPECT_FALSE(covers_of(with_gap, {}).above({0.0, 0.0}, hours(1.0)).known);
}

/// The result is the same as without stored ice, except for the time for which the first step is held.
TEST(IceCovers, TakeTheWaterToBeOpenUntilTheFirstOfThemMayBeHeld) {
  const Field later = even_ice(concentration_that_closes, 96.0, 120.0);
  const IceCovers alone = covers_of(later, {});
  const IceCovers after_another = covers_of(later, {even_ice(concentration_that_closes, -200.0, -190.0)});

  EXPECT_TRUE(alone.above({0.0, 0.0}, hours(23.0)).may_surface);
  EXPECT_FALSE(alone.above({0.0, 0.0}, hours(25.0)).may_surface);
  EXPECT_EQ(alone.least_way_to_opening({0.0, 0.0}).value, 0.0);
  EXPECT_EQ(alone.least_ways_to_opening({{0.0, 0.0}}, hours(20.0), hours(30.0))[0].value, 0.0);
  EXPECT_GT(alone.least_ways_to_opening({{0.0, 0.0}}, hours(25.0), hours(30.0))[0].value, 1e5);
  EXPECT_FALSE(after_another.above({0.0, 0.0}, hours(0.0)).known) << "there was ice before";
  EXPECT_EQ(after_another.above({0.0, 0.0}, hours(0.0)).draft_m, 8.0);
}

TEST(IceCovers, TakeTheKeelsOfAnotherWhereTheFirstTellsNoThickness) {
  const auto closed = [](geo::LonLat, double) { return concentration_that_closes; };
  const auto draft_m = [](const IceCovers& covers) { return covers.above({0.0, 0.0}, hours(1.0)).draft_m; };
  const Field without = support::ice_from(closed, {0.0, 24.0});
  const Field thick = support::ice_from(closed, {0.0, 24.0}, 6.0);
  const Field thin = support::ice_from(closed, {0.0, 24.0}, 1.0);
  const Field open = support::ice_from([](geo::LonLat, double) { return 0.0; }, {0.0, 24.0}, 0.0);
  const Field held = support::ice_from(closed, {-40.0}, 2.0);

  EXPECT_EQ(draft_m(covers_of(without, {thick})), 48.0);
  EXPECT_EQ(draft_m(covers_of(without, {thin, thick})), 8.0) << "the first that tells";
  EXPECT_EQ(draft_m(covers_of(without, {held, thin})), 8.0) << "data of the time before what is held";
  EXPECT_EQ(draft_m(covers_of(without, {held})), 16.0);
  EXPECT_EQ(draft_m(covers_of(thin, {thick})), 8.0);
  EXPECT_EQ(draft_m(covers_of(without, {open})), 30.0) << "which tells of no keels";
  EXPECT_EQ(draft_m(covers_of(without, {without})), 30.0);
}

TEST(IceCovers, HoldTheNearestStep) {
  const IceCovers covers =
      covers_of(even_ice(0.0, 96.0, 97.0), {even_ice(concentration_that_closes, 0.0, 1.0)});

  EXPECT_FALSE(covers.above({0.0, 0.0}, hours(40.0)).may_surface);
  EXPECT_TRUE(covers.above({0.0, 0.0}, hours(60.0)).may_surface);
}

/// Law: bounds on routes to openings and to dense ice hold for what all together tell.
TEST(IceCovers, BoundTheWaysToOpeningsAndToDenseIce) {
  int looks = 0;
  support::for_each_seed(40, [&](std::mt19937_64& rng) {
    const auto random_ice = [&] {
      const double phase = support::uniform(rng, 0.0, 6.28);
      const double from_hour = support::uniform(rng, -240.0, 120.0);
      return support::ice_from(
          [=](geo::LonLat p, double hour) {
            const double wave = std::sin(6.0 * p.lon_deg + 9.0 * p.lat_deg + 0.1 * hour + phase);
            return wave > 0.7 ? unknown : std::clamp(wave, 0.0, 1.0);
          },
          {from_hour, from_hour + 20.0, from_hour + support::uniform(rng, 40.0, 400.0)}, 1.0);
    };
    const IceCovers covers = covers_of(random_ice(), {random_ice(), random_ice()});
    const auto random_point = [&] {
      return geo::PlanePoint{support::uniform(rng, -30'000.0, 30'000.0),
                             support::uniform(rng, -30'000.0, 30'000.0)};
    };
    for (int i = 0; i < 100; ++i) {
      const geo::PlanePoint from = random_point();
      const geo::PlanePoint there = random_point();
      const core::Seconds time = hours(support::uniform(rng, 0.0, 300.0));
      const IceAbove ice = covers.above(there, time);
      const double way_m = geo::distance_m(from, there);
      if (ice.may_surface) {
        ++looks;
        EXPECT_LE(covers.least_way_to_opening(from).value, way_m);
        EXPECT_LE(covers.least_ways_to_opening({from}, time - hours(1.0), time + hours(1.0))[0].value, way_m);
      } else if (ice.draft_m > 0.0) {
        ++looks;
        EXPECT_LE(covers.least_way_to_dense_ice(from).value, way_m);
      }
    }
  });
  EXPECT_GT(looks, 1000);
}

}  // namespace
}  // namespace floeplan::planning::ice::ice_covers_test
