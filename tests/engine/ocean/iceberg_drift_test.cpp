#include "engine/ocean/iceberg_drift.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "engine/geo/geodesic.hpp"
#include "engine/ocean/ice/iceberg_wind.hpp"
#include "tests/engine/ocean/sample_currents.hpp"

namespace floeplan::ocean::iceberg_drift_test {
namespace {

const core::UtcTime start = core::from_unix_seconds(first_time_s);
constexpr double hour_s = 3600.0;

core::UtcTime after_hours(double hours) { return start + core::Seconds{hours * hour_s}; }

Iceberg sighted_berg() {
  Iceberg berg;
  berg.place = {-52.5, 69.0};
  berg.observed = start;
  berg.length = core::Metres{100.0};
  return berg;
}

/// Eastward currents; northwards minus half of that.
Environment sea_with(std::optional<Axis> depths_m, std::size_t hours,
                     const std::function<float(SampleIndex)>& east) {
  return {.currents = std::make_shared<const CurrentGrid>(sample_currents(std::move(depths_m), hours, east))};
}

core::Metres way(const IcebergFix& from, const IcebergFix& to) {
  return geo::geodesic_between(from.place, to.place).length;
}

TEST(IcebergDrift, FollowsTheCurrent) {
  const auto sea = sea_with(std::nullopt, 25, [](SampleIndex) { return 0.2F; });

  const auto fixes = forecast_drift(sighted_berg(), sea, after_hours(12.0));

  ASSERT_EQ(fixes.size(), 13U);
  EXPECT_EQ(fixes.back().time, after_hours(12.0));
  const auto line = geo::geodesic_between(fixes.front().place, fixes.back().place);
  EXPECT_NEAR(line.length.value, std::hypot(0.2, 0.1) * 12.0 * hour_s, 5.0);
  EXPECT_NEAR(line.course_at_start.degrees(), 90.0 + std::atan(0.5) * 180.0 / std::numbers::pi, 0.2);
}

TEST(IcebergDrift, FollowsTheCurrentsOfItsOwnWhereThereAreSome) {
  auto sea = sea_with(std::nullopt, 25, [](SampleIndex) { return 0.0F; });
  sea.drift_currents = sea_with(std::nullopt, 25, [](SampleIndex) { return 0.2F; }).currents;

  const auto fixes = forecast_drift(sighted_berg(), sea, after_hours(12.0));

  EXPECT_NEAR(way(fixes.front(), fixes.back()).value, std::hypot(0.2, 0.1) * 12.0 * hour_s, 5.0);
}

TEST(IcebergDrift, TellsWhetherTheCurrentIsKnownAllTheWay) {
  const auto sea = sea_with(std::nullopt, 25, [](SampleIndex) { return 0.2F; });
  const auto unknown_west_of_52 = sea_with(std::nullopt, 25, [](SampleIndex at) {
    return at.ix < 2 ? std::numeric_limits<float>::quiet_NaN() : 0.2F;
  });
  Iceberg outside = sighted_berg();
  outside.place.lon_deg = -55.0;

  EXPECT_TRUE(is_current_known(sighted_berg(), sea, after_hours(0.0), after_hours(12.0)));
  EXPECT_TRUE(is_current_known(sighted_berg(), sea, after_hours(0.0), after_hours(23.5)))
      << "the fix after that does not count";
  EXPECT_FALSE(is_current_known(sighted_berg(), sea, after_hours(0.0), after_hours(26.0)));
  EXPECT_TRUE(is_current_known(sighted_berg(), sea, after_hours(30.0), after_hours(29.0)))
      << "no fix lies between";
  EXPECT_FALSE(is_current_known(outside, sea, after_hours(0.0), after_hours(0.0)));
  EXPECT_FALSE(is_current_known(sighted_berg(), unknown_west_of_52, after_hours(0.0), after_hours(0.0)));
  EXPECT_FALSE(is_current_known(sighted_berg(), {}, after_hours(0.0), after_hours(0.0)));
}

TEST(IcebergDrift, CountsHowLongAForecastRestsOnKnownCurrents) {
  const auto sea = sea_with(std::nullopt, 25, [](SampleIndex) { return 0.2F; });
  Iceberg seen_before = sighted_berg();
  seen_before.observed = after_hours(-2.5);
  Iceberg outside = sighted_berg();
  outside.place.lon_deg = -55.0;

  const DriftBasis followed = drift_basis(sighted_berg(), sea, after_hours(4.5));
  const DriftBasis before = drift_basis(seen_before, sea, after_hours(4.5));
  const DriftBasis beyond = drift_basis(outside, sea, after_hours(4.5));

  EXPECT_EQ(followed.unknown.count(), 0.0);
  ASSERT_EQ(followed.known.size(), 6U);
  EXPECT_EQ(followed.known.front().time, after_hours(0.0));
  EXPECT_EQ(followed.known.back().time, after_hours(5.0)) << "whole hours";
  EXPECT_NEAR(before.unknown.count(), 2.5 * hour_s, 1e-6);
  ASSERT_EQ(before.known.size(), 6U);
  EXPECT_EQ(before.known.front().place, seen_before.place) << "it stays until the currents begin";
  EXPECT_NEAR(beyond.unknown.count(), 4.5 * hour_s, 1e-6);
  EXPECT_TRUE(beyond.known.empty());
  EXPECT_TRUE(drift_basis(sighted_berg(), sea, after_hours(-1.0)).known.empty()) << "before the sighting";
}

TEST(IcebergDrift, AveragesTheCurrentOverTheDraft) {
  // Nothing moves above 20 m, everything below 40 m; a growler floats above, half of a deep berg is below 40 m.
  const auto sea =
      sea_with(Axis{{0.0, 20.0, 40.0, 200.0}}, 25, [](SampleIndex at) { return at.level < 2 ? 0.0F : 0.3F; });
  Iceberg growler = sighted_berg();
  growler.draft = core::Metres{6.0};
  Iceberg deep = sighted_berg();
  deep.draft = core::Metres{80.0};

  const auto of_growler = forecast_drift(growler, sea, after_hours(10.0));
  const auto of_deep = forecast_drift(deep, sea, after_hours(10.0));

  EXPECT_EQ(way(of_growler.front(), of_growler.back()).value, 0.0);
  const double mean = 0.3 * (0.5 * 20.0 + 40.0) / 80.0;
  EXPECT_NEAR(way(of_deep.front(), of_deep.back()).value, mean * std::hypot(1.0, 0.5) * 10.0 * hour_s, 10.0);
}

TEST(IcebergDrift, ComesBackWithTheTide) {
  constexpr double period_h = 12.42;
  const auto sea = sea_with(std::nullopt, 50, [](SampleIndex at) {
    return static_cast<float>(0.4 *
                              std::cos(2.0 * std::numbers::pi * static_cast<double>(at.time) / period_h));
  });

  const auto fixes = forecast_drift(sighted_berg(), sea, after_hours(25.0));

  const double swing_m = 0.4 * std::hypot(1.0, 0.5) * period_h * hour_s / std::numbers::pi;
  double farthest_m = 0.0;
  for (const IcebergFix& fix : fixes) farthest_m = std::max(farthest_m, way(fixes.front(), fix).value);
  EXPECT_NEAR(farthest_m, 0.5 * swing_m, 0.05 * swing_m);
  EXPECT_LT(way(fixes.front(), fixes.back()).value, 0.05 * swing_m);
}

TEST(IcebergDrift, StaysAgroundUntilTheCurrentLeadsToDeeperWater) {
  // East of 52 W the bed is at 20 m; the berg draws 50 m. The current turns after ten hours.
  auto sea = sea_with(std::nullopt, 40, [](SampleIndex at) { return at.time <= 10 ? 0.5F : -0.5F; });
  const HorizontalGrid grid{geo::GeographicFrame{}, even_axis(-54.0, 0.1, 31), even_axis(68.0, 0.1, 21)};
  std::vector<float> depths;
  for (std::size_t iy = 0; iy < 21; ++iy) {
    for (std::size_t ix = 0; ix < 31; ++ix)
      depths.push_back(grid.place(ix, iy).lon_deg > -52.35 ? 20.0F : 300.0F);
  }
  sea.bathymetry = std::make_shared<const Bathymetry>(grid, depths);
  Iceberg berg = sighted_berg();
  berg.draft = core::Metres{50.0};

  const auto fixes = forecast_drift(berg, sea, after_hours(20.0));

  EXPECT_EQ(fixes[9].place, fixes[10].place);
  EXPECT_LT(fixes[10].place.lon_deg, -52.3);
  EXPECT_LT(fixes[20].place.lon_deg, fixes[10].place.lon_deg - 0.2);
}

TEST(IcebergDrift, KeepsTheObservedDriftWhereNoCurrentIsKnown) {
  Iceberg berg = sighted_berg();
  berg.earlier = {{geo::geodesic_destination(berg.place, geo::Bearing::degrees(270.0), core::Metres{8640.0}),
                   after_hours(-12.0)}};

  const auto fixes = forecast_drift(berg, {}, after_hours(6.0));

  const auto line = geo::geodesic_between(fixes.front().place, fixes.back().place);
  EXPECT_NEAR(line.length.value, 4320.0, 1.0);
  EXPECT_NEAR(line.course_at_start.degrees(), 90.0, 0.3);
}

TEST(IcebergDrift, TakesNoDriftFromSightingsThatDoNotTellIt) {
  const auto seen_before = [](double hours, double distance_m) {
    Iceberg berg = sighted_berg();
    berg.earlier = {
        {geo::geodesic_destination(berg.place, geo::Bearing::degrees(0.0), core::Metres{distance_m}),
         after_hours(-hours)}};
    const auto fixes = forecast_drift(berg, {}, after_hours(6.0));
    return way(fixes.front(), fixes.back()).value;
  };

  EXPECT_EQ(seen_before(2.0, 2000.0), 0.0);        // too soon after
  EXPECT_EQ(seen_before(100.0, 20'000.0), 0.0);    // too long ago
  EXPECT_EQ(seen_before(12.0, 100'000.0), 0.0);    // 2.3 m/s: another berg
  EXPECT_GT(seen_before(12.0, 20'000.0), 5000.0);  // the drift is told
}

/// A step over the beginning of the currents would count them for all of it or for none.
TEST(IcebergDrift, MovesWithTheCurrentFromItsBeginningOn) {
  const auto sea = sea_with(std::nullopt, 25, [](SampleIndex) { return 0.2F; });
  Iceberg berg = sighted_berg();
  for (const double minutes_before : {50.0, 10.0}) {
    berg.observed = after_hours(-minutes_before / 60.0);

    const auto fixes = forecast_drift(berg, sea, after_hours(6.0));

    EXPECT_EQ(fixes[1].time, start);
    EXPECT_EQ(fixes[1].place, berg.place);
    EXPECT_NEAR(way(fixes.front(), fixes[7]).value, std::hypot(0.2, 0.1) * 6.0 * hour_s, 5.0);
  }
}

TEST(IcebergDrift, NeedsToKnowTheWaterSinceTheSightingThatTellsOfADrift) {
  Iceberg berg = sighted_berg();
  EXPECT_EQ(forecast_needs_from(berg), start);
  berg.earlier = {{berg.place, after_hours(-12.0)}, {berg.place, after_hours(-2.0)}};
  EXPECT_EQ(forecast_needs_from(berg), after_hours(-12.0));
  berg.earlier = {{berg.place, after_hours(-100.0)}};
  EXPECT_EQ(forecast_needs_from(berg), start);
}

TEST(IcebergDrift, FadesFromTheObservedDriftToTheCurrentWithinDays) {
  // The berg was seen to move 0.1 m/s faster to the east than the water. The current is known all the time.
  const auto sea = sea_with(std::nullopt, 150, [](SampleIndex) { return 0.0F; });
  Iceberg berg = sighted_berg();
  berg.observed = after_hours(24.0);
  berg.earlier = {
      {geo::geodesic_destination(berg.place, geo::Bearing::degrees(270.0), core::Metres{8640.0}), start}};

  const auto fixes = forecast_drift(berg, sea, after_hours(24.0 + 96.0));

  EXPECT_NEAR(way(fixes[0], fixes[1]).value, 360.0, 10.0);
  EXPECT_NEAR(way(fixes[24], fixes[25]).value, 360.0 / std::numbers::e, 5.0);
  EXPECT_LT(way(fixes[95], fixes[96]).value, 8.0);
}

TEST(IcebergDrift, StandsWhereNothingIsKnownAndBeyondTheEndOfTheCurrents) {
  const auto sea = sea_with(std::nullopt, 5, [](SampleIndex) { return 0.2F; });

  const auto fixes = forecast_drift(sighted_berg(), sea, after_hours(10.0));

  EXPECT_GT(way(fixes[0], fixes[3]).value, 2000.0);
  EXPECT_EQ(fixes[5].place, fixes[10].place);
  EXPECT_EQ(way(forecast_drift(sighted_berg(), {}, after_hours(10.0)).back(), fixes.front()).value, 0.0);
}

TEST(IcebergDrift, AddsTheWindToTheCurrent) {
  const auto eastwards = [](float speed) { return [speed](SampleIndex) { return speed; }; };
  auto sea = sea_with(std::nullopt, 25, eastwards(0.2F));
  const auto without = forecast_drift(sighted_berg(), sea, after_hours(10.0));
  sea.wind = std::make_shared<const CurrentGrid>(sample_currents(std::nullopt, 25, eastwards(10.0F)));

  const auto fixes = forecast_drift(sighted_berg(), sea, after_hours(10.0));

  const auto added = moved_by_wind({{10.0}, {-5.0}}, core::Metres{100.0}, 69.0);
  EXPECT_NEAR(way(without.back(), fixes.back()).value, geo::strength(added).value * 10.0 * hour_s, 30.0);
  EXPECT_GT(geo::strength(added).value, 0.15);
}

TEST(IcebergDrift, GoesBeforeTheWindAloneWhereNothingElseIsKnown) {
  Environment sea;
  sea.wind = std::make_shared<const CurrentGrid>(
      sample_currents(std::nullopt, 25, [](SampleIndex) { return 8.0F; }));

  const auto fixes = forecast_drift(sighted_berg(), sea, after_hours(30.0));

  EXPECT_GT(way(fixes[0], fixes[10]).value, 5000.0);
  EXPECT_EQ(fixes[25].place, fixes[30].place) << "the wind is not known any longer";
}

TEST(IcebergDrift, DoesNotCountTheWindTwiceInWhatItWasSeenToDo) {
  // Seen to move as the wind alone moves it: whether that wind is stored or not, it goes on as the wind does.
  const auto still = [](SampleIndex) { return 0.0F; };
  const auto blowing = [](SampleIndex) { return 10.0F; };
  Iceberg berg = sighted_berg();
  berg.observed = after_hours(24.0);
  const auto by_wind = moved_by_wind({{10.0}, {-5.0}}, core::Metres{100.0}, 69.0);
  const auto back = geo::Bearing::towards(-by_wind.east.value, -by_wind.north.value);
  berg.earlier = {{geo::geodesic_destination(berg.place, back,
                                             core::Metres{geo::strength(by_wind).value * 24.0 * hour_s}),
                   start}};
  auto sea = sea_with(std::nullopt, 60, still);
  const auto all = sample_currents(std::nullopt, 60, blowing);
  CurrentGrid::Samples late = all.samples();
  const auto skipped = static_cast<std::ptrdiff_t>(24 * late.grid.size());
  late.times_s = even_axis(first_time_s + 24.0 * hour_s, hour_s, 36);
  late.u.erase(late.u.begin(), late.u.begin() + skipped);
  late.v.erase(late.v.begin(), late.v.begin() + skipped);

  for (const CurrentGrid& wind : {all, CurrentGrid{late}}) {
    sea.wind = std::make_shared<const CurrentGrid>(wind);
    const auto fixes = forecast_drift(berg, sea, after_hours(34.0));
    EXPECT_NEAR(way(fixes.front(), fixes.back()).value, geo::strength(by_wind).value * 10.0 * hour_s, 60.0);
  }
}

TEST(IcebergDrift, OfTheFutureIsTheSightingAlone) {
  Iceberg berg = sighted_berg();
  berg.observed = after_hours(3.0);

  EXPECT_EQ(forecast_drift(berg, {}, start).size(), 1U);
}

TEST(IcebergError, GrowsWithTheAgeOfTheSighting) {
  Iceberg berg = sighted_berg();
  EXPECT_EQ(expected_error(berg, start).value, 0.0);
  berg.position_uncertainty = core::Metres{500.0};
  EXPECT_NEAR(expected_error(berg, after_hours(24.0)).value, 500.0 + 18'000.0, 1e-6);
  EXPECT_NEAR(expected_error(berg, after_hours(-2.0)).value, 500.0 + 1500.0, 1e-6);
}

}  // namespace
}  // namespace floeplan::ocean::iceberg_drift_test
