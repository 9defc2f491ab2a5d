#include "engine/planning/energy/dive_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::energy::dive_line_test {
namespace {

const geo::LocalProjection projection{{-53.0, 69.0}};
const plane::PlaneBox area{{-30'000.0, -30'000.0}, {30'000.0, 30'000.0}};
constexpr core::Metres look{4000.0};  // a cell of the data
constexpr core::Metres nothing_above{0.0};

vehicle::DiveLimits limits() { return {.climb_to = {5.0}, .dive_to = {200.0}, .altimeter_margin = {10.0}}; }

obstacles::PlaneBed bed_of(const std::shared_ptr<const ocean::Bathymetry>& bathymetry) {
  return {bathymetry, projection, area, {}};
}

/// The number of dive turns per metre of depth, averaged over many places between two shares of a line.
double stepped_turns_m(const obstacles::PlaneBed& bed, geo::PlanePoint a, geo::PlanePoint b, double from,
                       double until, core::Metres upper_turn) {
  constexpr int steps = 20'000;
  double turns_m = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double share = from + (i + 0.5) / steps * (until - from);
    const geo::PlanePoint here{a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m)};
    const vehicle::DiveBand band =
        vehicle::band_below(upper_turn, vehicle::flown_band(limits(), bed.depth(here)));
    turns_m += 1.0 / (steps * band.thickness().value);
  }
  return turns_m;
}

TEST(DiveLine, IsAsDeepAsAskedWhereNothingIsKnown) {
  const DiveLine line{limits(), nullptr, look, {0.0, 0.0}, {9000.0, 0.0}};

  EXPECT_TRUE(line.is_even());
  EXPECT_EQ(line.mean_band(0.2, 0.7, nothing_above), vehicle::flown_band(limits(), std::nullopt));
  EXPECT_EQ(line.mean_band(0.2, 0.7, core::Metres{40.0}), (vehicle::DiveBand{{40.0}, {200.0}}));
}

TEST(DiveLine, IsEvenOverAPlainAndAtOnePlace) {
  const obstacles::PlaneBed plain = bed_of(support::bathymetry_from([](geo::LonLat) { return 90.0; }));
  const obstacles::PlaneBed slope =
      bed_of(support::bathymetry_from([](geo::LonLat p) { return 100.0 + 40.0 * (p.lon_deg + 53.0); }));

  const DiveLine over_plain{limits(), &plain, look, {0.0, 0.0}, {9000.0, 5000.0}};
  const DiveLine at_one_place{limits(), &slope, look, {0.0, 0.0}, {0.0, 0.0}};

  EXPECT_TRUE(over_plain.is_even());
  EXPECT_NEAR(over_plain.mean_band(0.0, 1.0, nothing_above).bottom.value, 80.0, 1e-5);
  EXPECT_TRUE(at_one_place.is_even());
  EXPECT_NEAR(at_one_place.mean_band(0.0, 0.0, nothing_above).bottom.value, 90.0, 0.1);
}

TEST(DiveLine, TurnsAsOftenOnTheAverageAsAStepByStepLookSays) {
  support::for_each_seed(40, [](std::mt19937_64& rng) {
    const double seed = support::uniform(rng, 0.0, 100.0);
    const obstacles::PlaneBed bed = bed_of(support::bathymetry_from(
        [=](geo::LonLat p) { return 140.0 + 110.0 * std::sin(seed + 15.0 * p.lon_deg + 25.0 * p.lat_deg); }));
    const auto metres = [&] { return support::uniform(rng, -20'000.0, 20'000.0); };
    const geo::PlanePoint a{metres(), metres()};
    const geo::PlanePoint b{metres(), metres()};
    const double one = support::uniform(rng, 0.0, 1.0);
    const double other = support::uniform(rng, 0.0, 1.0);
    const auto [from, until] = std::minmax(one, other);
    const DiveLine line{limits(), &bed, look, a, b};

    for (const core::Metres upper_turn : {nothing_above, core::Metres{15.0}}) {
      const double turns_m = 1.0 / line.mean_band(from, until, upper_turn).thickness().value;
      EXPECT_NEAR(turns_m, stepped_turns_m(bed, a, b, from, until, upper_turn), 0.005 * turns_m);
    }
  });
}

TEST(DiveLine, MissesNoRidgeOfOneNode) {
  const obstacles::PlaneBed bed = bed_of(support::bathymetry_from(
      [](geo::LonLat p) { return std::abs(p.lat_deg - 69.0) < 0.01 ? 30.0 : 400.0; }));
  const geo::PlanePoint a{0.0, -20'000.0};
  const geo::PlanePoint b{0.0, 20'000.0};

  const DiveLine line{limits(), &bed, look, a, b};

  const double turns_m = 1.0 / line.mean_band(0.0, 1.0, nothing_above).thickness().value;
  EXPECT_NEAR(turns_m, stepped_turns_m(bed, a, b, 0.0, 1.0, nothing_above), 0.005 * turns_m);
  EXPECT_GT(turns_m, 1.2 / 195.0);
}

TEST(DiveLine, StandsAtAPlaceOfALine) {
  const obstacles::PlaneBed slope =
      bed_of(support::bathymetry_from([](geo::LonLat p) { return 100.0 + 40.0 * (p.lon_deg + 53.0); }));
  const DiveLine line{limits(), &slope, look, {-9000.0, 0.0}, {9000.0, 0.0}};

  EXPECT_NEAR(line.mean_band(0.5, 0.5, nothing_above).bottom.value, 90.0, 0.1);
  EXPECT_LT(line.mean_band(0.0, 0.0, nothing_above).bottom.value,
            line.mean_band(1.0, 1.0, nothing_above).bottom.value);
}

}  // namespace
}  // namespace floeplan::planning::energy::dive_line_test
