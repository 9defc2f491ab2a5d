#include "engine/planning/ice/under_ice.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/planning/cost/sea.hpp"
#include "engine/planning/obstacles/bed_cells.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::ice::under_ice_test {
namespace {

const geo::LocalProjection projection{{-53.0, 69.0}};
constexpr plane::PlaneBox area{{-40'000.0, -40'000.0}, {40'000.0, 40'000.0}};
constexpr core::Seconds at_once{0.0};

/// The glider of 200 m needs 20 m of water, 10 m of them above the sea bed.
PlanRequest request_in_ice() {
  PlanRequest request = support::eastward_request();
  request.under_ice.margin_below_ice = core::Metres{10.0};
  return request;
}

/// Ice one metre thick, hence keels of 8 m, east of the middle.
std::shared_ptr<const ocean::IceField> ice_in_the_east(double thickness_m = 1.0) {
  return support::ice_from([](geo::LonLat p, double) { return p.lon_deg > -53.0 ? 0.9 : 0.0; }, {0.0},
                           thickness_m);
}

UnderIce under_ice(const ocean::Environment& environment, const PlanRequest& request) {
  constexpr core::Metres cell{500.0};
  auto bed = environment.bathymetry
                 ? obstacles::lay_out_bed(environment.bathymetry, request.vehicle, projection, area, cell, {})
                 : nullptr;
  return {environment, request, projection, area, cell, std::move(bed)};
}

TEST(UnderIce, KeepsTheUpperTurnTheMarginBelowTheKeels) {
  const ocean::Environment environment{.ice = ice_in_the_east()};
  const PlanRequest request = request_in_ice();
  const UnderIce ice = under_ice(environment, request);

  EXPECT_EQ(ice.least_upper_turn({-20'000.0, 0.0}, at_once).value, 0.0);
  EXPECT_NEAR(ice.least_upper_turn({20'000.0, 0.0}, at_once).value, 18.0, 1e-5);
}

TEST(UnderIce, PassesWhereAsMuchWaterIsLeftAsTheVehicleNeedsBelowTheSurface) {
  const PlanRequest request = request_in_ice();
  const auto may_pass = [&](double depth_m, double dive_depth_m) {
    const ocean::Environment environment{
        .bathymetry = support::bathymetry_from([=](geo::LonLat) { return depth_m; }),
        .ice = ice_in_the_east()};
    PlanRequest dive = request;
    dive.vehicle.dive_depth = core::Metres{dive_depth_m};
    return under_ice(environment, dive).may_transit({20'000.0, 0.0}, at_once);
  };

  EXPECT_TRUE(may_pass(39.0, 200.0));  // 8 m of keel, 10 m of margin, 20 m of water
  EXPECT_FALSE(may_pass(37.0, 200.0));
  EXPECT_TRUE(may_pass(500.0, 29.0));  // 18 m to the upper turn, 10 m of dive
  EXPECT_FALSE(may_pass(500.0, 27.0));
}

TEST(UnderIce, SeesASillBetweenTwoLooks) {
  // One row of the bathymetry has 25 m of water where 38 m are needed. Half a sample beside it the water is 47 m deep.
  const auto sea_over = [](double sill_m) {
    return ocean::Environment{.bathymetry = support::bathymetry_from([=](geo::LonLat p) {
                                return std::abs(p.lat_deg - 69.0) < 1e-6 ? sill_m : 200.0;
                              }),
                              .ice = support::ice_from([](geo::LonLat, double) { return 0.9; }, {0.0}, 1.0)};
  };
  const PlanRequest request = request_in_ice();
  const auto may_pass = [&](double sill_m) {
    const ocean::Environment environment = sea_over(sill_m);
    const cost::Sea sea{environment, request, projection, area, core::Metres{4000.0}};
    const geo::PlanePoint south{20'000.0, -9000.0};
    const geo::PlanePoint north{20'000.0, 9000.0};
    const bool may = sea.leg_time(south, north, at_once).has_value();
    EXPECT_EQ(sea.leg(south, north, at_once, at_once, sea.drives().front()).has_value(), may);
    return may;
  };

  EXPECT_FALSE(may_pass(25.0));
  EXPECT_TRUE(may_pass(40.0));
}

TEST(UnderIce, LeavesRoomForADiveOverEveryBedWhateverTheMargins) {
  constexpr double never_closed_m = 0.1;  // by the table of the plane
  int open = 0;
  int closed = 0;
  support::for_each_seed(60, [&](std::mt19937_64& rng) {
    const double mean_m = support::uniform(rng, 20.0, 120.0);
    const double slope_m = support::uniform(rng, 0.0, 40.0);  // for a degree
    const ocean::Environment environment{.bathymetry = support::bathymetry_from([=](geo::LonLat p) {
                                           return std::max(1.0, mean_m + slope_m * (p.lon_deg + 53.0));
                                         }),
                                         .ice = ice_in_the_east(support::uniform(rng, 0.1, 5.0))};
    PlanRequest request = request_in_ice();
    request.under_ice.margin_below_ice = core::Metres{support::uniform(rng, 0.0, 20.0)};
    vehicle::GliderProfile& vehicle = request.vehicle;
    vehicle.minimum_working_depth = core::Metres{support::uniform(rng, 0.0, 40.0)};
    vehicle.altimeter_margin = core::Metres{support::uniform(rng, 0.0, 60.0)};
    vehicle.dive_depth = core::Metres{support::uniform(rng, 30.0, 200.0)};
    const cost::Sea sea{environment, request, projection, area, core::Metres{500.0}};
    const geo::PlanePoint a{support::uniform(rng, 6000.0, 20'000.0), support::uniform(rng, -9e3, 9e3)};
    const geo::PlanePoint b{support::uniform(rng, 6000.0, 20'000.0), support::uniform(rng, -9e3, 9e3)};

    double room_m = INFINITY;
    for (int i = 0; i <= 200; ++i) {
      const geo::PlanePoint point{a.x_m + i / 200.0 * (b.x_m - a.x_m), a.y_m + i / 200.0 * (b.y_m - a.y_m)};
      const double turn_m = sea.domain().overhead().least_upper_turn(point, at_once).value;
      const double bed_m = environment.bathymetry->shoalest(projection.to_lon_lat(point))->value;
      const double bottom_m = std::min(vehicle.dive_depth.value, bed_m - vehicle.altimeter_margin.value);
      room_m = std::min(room_m, bottom_m - turn_m);
    }
    const bool is_open = sea.leg_time(a, b, at_once).has_value();
    ++(is_open ? open : closed);

    if (is_open) {
      EXPECT_GE(room_m, vehicle::lowest_tooth.value - never_closed_m);
    }
  });
  EXPECT_GT(open, 10);
  EXPECT_GT(closed, 10);
}

TEST(UnderIce, NeedsRoomForADiveEvenWhereTheWorkingDepthAsksForNone) {
  const ocean::Environment environment{
      .bathymetry = support::bathymetry_from([](geo::LonLat) { return 45.0; }), .ice = ice_in_the_east()};
  const auto may_pass = [&](double working_depth_m, double altimeter_margin_m) {
    PlanRequest request = request_in_ice();
    request.vehicle.minimum_working_depth = core::Metres{working_depth_m};
    request.vehicle.altimeter_margin = core::Metres{altimeter_margin_m};
    return under_ice(environment, request).may_transit({20'000.0, 0.0}, at_once);
  };

  EXPECT_TRUE(may_pass(0.0, 24.9));  // 18 m to the upper turn, 2 m of dive, 25 m to the bed
  EXPECT_FALSE(may_pass(0.0, 25.1));
  EXPECT_FALSE(may_pass(20.0, 30.0));
}

TEST(UnderIce, ClosesALegWithoutRoomBelowTheIceAndNoOther) {
  const ocean::Environment environment{
      .bathymetry = support::bathymetry_from([](geo::LonLat) { return 30.0; }), .ice = ice_in_the_east()};
  const PlanRequest request = request_in_ice();
  const cost::Sea sea{environment, request, projection, area, core::Metres{500.0}};

  EXPECT_TRUE(sea.leg_time({-30'000.0, 0.0}, {-15'000.0, 0.0}, at_once));
  EXPECT_EQ(sea.leg_time({-30'000.0, 0.0}, {20'000.0, 0.0}, at_once).error(), motion::EdgeClosed::under_ice);
}

TEST(UnderIce, UsesTheIceOfTheTimeOfPassage) {
  // Closed now, open in two days; the water is too shallow to pass below it.
  const ocean::Environment environment{
      .bathymetry = support::bathymetry_from([](geo::LonLat) { return 30.0; }),
      .ice = support::ice_from([](geo::LonLat, double hour) { return hour < 30.0 ? 0.9 : 0.0; },
                               {0.0, 24.0, 48.0}, 1.0)};
  const PlanRequest request = request_in_ice();
  const cost::Sea sea{environment, request, projection, area, core::Metres{500.0}};

  EXPECT_EQ(sea.leg_time({0.0, 0.0}, {5000.0, 0.0}, at_once).error(), motion::EdgeClosed::under_ice);
  EXPECT_TRUE(sea.leg_time({0.0, 0.0}, {5000.0, 0.0}, core::Seconds{3600.0 * 48.0}));
}

TEST(UnderIce, PassesButDoesNotCountOnSurfacingWhereNothingIsKnown) {
  const ocean::Environment environment{
      .bathymetry = support::bathymetry_from([](geo::LonLat) { return 30.0; }),
      .ice = support::ice_from([](geo::LonLat, double) { return std::nan(""); }, {0.0})};
  const PlanRequest request = request_in_ice();
  const cost::Sea sea{environment, request, projection, area, core::Metres{500.0}};

  EXPECT_TRUE(sea.leg_time({0.0, 0.0}, {5000.0, 0.0}, at_once));
  EXPECT_FALSE(sea.domain().overhead().may_surface({0.0, 0.0}, at_once));
}

TEST(UnderIce, KeepsBelowTheKeelsThatWereKnownLast) {
  const ocean::Environment environment{.ice = ice_in_the_east()};
  const UnderIce ice = under_ice(environment, request_in_ice());
  const core::Seconds long_after = ocean::longest_ice_hold + core::Seconds{3600.0};

  EXPECT_NEAR(ice.least_upper_turn({20'000.0, 0.0}, long_after).value, 18.0, 1e-5);
  EXPECT_FALSE(ice.may_surface({20'000.0, 0.0}, long_after));
  EXPECT_EQ(ice.least_upper_turn({-20'000.0, 0.0}, long_after).value, 0.0);
}

TEST(SeaLeg, CountsTheTimeSinceTheVehicleMightHaveSurfaced) {
  const ocean::Environment environment{.ice = ice_in_the_east()};
  const PlanRequest request = request_in_ice();
  const cost::Sea sea{environment, request, projection, area, core::Metres{500.0}};

  // The edge of the ice (one tenth) lies between the columns at 53.0 W and 52.9 W: a ninth of 0.1 degrees east of 53 W.
  const double edge_m = projection.to_plane({-53.0 + 0.1 / 9.0, 69.0}).x_m;
  const auto leg = sea.leg({-10'000.0, 0.0}, {10'000.0, 0.0}, at_once, core::Seconds{12'345.0});

  ASSERT_TRUE(leg);
  const double speed = request.vehicle.speed_through_water.value;
  EXPECT_NEAR(leg->time.count(), 20'000.0 / speed, 60.0);
  EXPECT_GE(leg->since_surfacing.count(), (10'000.0 - edge_m) / speed - 60.0);
  EXPECT_LE(leg->since_surfacing.count(), (10'000.0 - edge_m + 500.0) / speed + 60.0);
  const auto in_open_water = sea.leg({-10'000.0, 0.0}, {-5'000.0, 0.0}, at_once, core::Seconds{12'345.0});
  EXPECT_EQ(in_open_water->since_surfacing.count(), 0.0);
}

TEST(SeaLeg, IsClosedWhereTheVehicleWouldBeTooLongUnderIceAlsoBetweenItsEnds) {
  // A band of ice 20 km wide; both ends of the leg lie in open water.
  const ocean::Environment environment{
      .ice = support::ice_from(
          [](geo::LonLat p, double) { return p.lon_deg > -53.25 && p.lon_deg < -52.75 ? 0.9 : 0.0; }, {0.0},
          1.0)};
  const auto leg = [&](double bound_h, double since_s) {
    PlanRequest request = request_in_ice();
    request.under_ice.max_time_without_surfacing = core::Seconds{3600.0 * bound_h};
    const cost::Sea sea{environment, request, projection, area, core::Metres{500.0}};
    return sea.leg({-25'000.0, 0.0}, {25'000.0, 0.0}, at_once, core::Seconds{since_s});
  };

  EXPECT_TRUE(leg(20.0, 0.0));  // 22 km at 0.35 m/s last about 17 h
  EXPECT_EQ(leg(20.0, 0.0)->since_surfacing.count(), 0.0);
  EXPECT_EQ(leg(14.0, 0.0).error(), motion::EdgeClosed::no_surfacing);
  EXPECT_TRUE(leg(20.0, 10'000.0)) << "open water comes before the ice";
}

TEST(SeaLeg, NeverCountsLessThanTheTrueTimeUnderIce) {
  support::for_each_seed(30, [](std::mt19937_64& rng) {
    const double phase = support::uniform(rng, 0.0, 6.28);
    const auto concentration = [&](geo::LonLat p, double) {
      return 0.5 + 0.5 * std::sin(20.0 * p.lon_deg + phase);
    };
    const ocean::Environment environment{.ice = support::ice_from(concentration, {0.0}, 1.0)};
    const PlanRequest request = request_in_ice();
    const cost::Sea sea{environment, request, projection, area, core::Metres{1000.0}};
    const geo::PlanePoint from{-30'000.0, support::uniform(rng, -20'000.0, 20'000.0)};
    const geo::PlanePoint to{support::uniform(rng, 0.0, 30'000.0),
                             support::uniform(rng, -20'000.0, 20'000.0)};

    const auto leg = sea.leg(from, to, at_once, core::Seconds{0.0});

    double since_s = 0.0;
    double before_s = 0.0;
    for (const cost::Sea::Passage& fine :
         sea.passages(from, to, at_once, core::Metres{10.0}, sea.drives().front())) {
      since_s = sea.domain().overhead().may_surface(fine.point, fine.time)
                    ? 0.0
                    : since_s + fine.time.count() - before_s;
      before_s = fine.time.count();
    }
    ASSERT_TRUE(leg);
    EXPECT_NEAR(before_s, leg->time.count(), 1e-6);
    EXPECT_GE(leg->since_surfacing.count(), since_s - 10.0 / 0.35);
  });
}

}  // namespace
}  // namespace floeplan::planning::ice::under_ice_test
