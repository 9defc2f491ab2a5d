#include "engine/planning/find_isochrones.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "engine/geo/geodesic.hpp"
#include "engine/messages/sentence.hpp"
#include "engine/planning/plan_route.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::reach_test {
namespace {

using Direction = IsochroneRequest::Direction;

constexpr double glider_m_s = 0.35;
constexpr core::Seconds hour{3600.0};

IsochroneRequest reach_request(Direction direction, std::vector<double> hours) {
  IsochroneRequest request;
  request.direction = direction;
  request.place = {-53.0, 69.0};
  request.time =
      core::from_unix_seconds(support::sea_start_s) + (direction == Direction::from ? 0.0 : 30.0) * hour;
  for (const double span : hours) request.spans.push_back(span * hour);
  request.vehicle = *vehicle::find_profile("slocum-g3-200");
  request.spacing = core::Metres{800.0};
  return request;
}

Isochrones reach(const ocean::Environment& environment, const IsochroneRequest& request) {
  return find_isochrones(environment, request, {}, {}).value();
}

bool holds(const Isochrone& area, geo::LonLat place) {
  return std::ranges::any_of(area.polygons,
                             [&](const geo::Polygon& polygon) { return geo::contains(polygon, place); });
}

geo::VelocityEn tide(geo::LonLat place, double hours) {
  const double phase = 2.0 * std::numbers::pi * hours / 12.42;
  return {{0.15 * std::cos(phase)}, {0.2 * std::sin(phase + place.lon_deg)}};
}

geo::LonLat somewhere(std::mt19937_64& rng, double radius_m) {
  return geo::geodesic_destination({-53.0, 69.0}, geo::Bearing::degrees(support::uniform(rng, 0.0, 360.0)),
                                   core::Metres{radius_m * std::sqrt(support::uniform(rng, 0.0, 1.0))});
}

TEST(Isochrones, IsACircleInStillWaterBothWays) {
  for (const Direction direction : {Direction::from, Direction::to}) {
    const Isochrones found = reach({}, reach_request(direction, {6.0, 12.0, 24.0}));

    ASSERT_EQ(found.areas.size(), 3U);
    for (const Isochrone& area : found.areas) {
      const double radius_m = glider_m_s * area.span.count();
      ASSERT_EQ(area.polygons.size(), 1U);
      EXPECT_TRUE(area.polygons.front().holes.empty());
      EXPECT_NEAR(area.area_m2, std::numbers::pi * radius_m * radius_m, 0.04 * area.area_m2);
      for (const geo::LonLat place : area.polygons.front().outer) {
        const double distance_m = geo::geodesic_between({-53.0, 69.0}, place).length.value;
        EXPECT_LE(distance_m, 1.001 * radius_m + 40.0);
        EXPECT_GE(distance_m, radius_m / 1.015 - 40.0);
      }
    }
  }
}

/// An eddy of 30 km east of the place. Its speed is `m_s`, which may be more than the vehicle's.
ocean::Environment eddy(double m_s) {
  ocean::Environment sea;
  sea.currents = support::currents_from(
      [&](geo::LonLat place, double) {
        const double east_km = 40.0 * (place.lon_deg + 52.7);
        const double north_km = 111.2 * (place.lat_deg - 69.0);
        const double away = std::hypot(east_km, north_km) / 15.0;
        const double spin = m_s * std::exp(0.5 - 0.5 * away * away) / 15.0;
        return geo::VelocityEn{{-spin * north_km}, {spin * east_km}};
      },
      0);
  sea.steady_currents = true;
  return sea;
}

TEST(Isochrones, IsSearchedInMoreDirectionsInStrongCurrentsAndSaysWhatItMayLack) {
  for (const Direction direction : {Direction::from, Direction::to}) {
    const ocean::Environment sea = eddy(0.8);
    IsochroneRequest request = reach_request(direction, {24.0});
    const Isochrones found = reach(sea, request);
    request.sectors = 5;
    const Isochrones in_more_directions = reach(sea, request);
    request.sectors = 3;
    const Isochrones in_fewer = reach(sea, request);

    EXPECT_EQ(found.areas.front().area_m2, in_more_directions.areas.front().area_m2);
    EXPECT_GT(found.areas.front().area_m2, in_fewer.areas.front().area_m2);
    for (const Isochrones& any : {found, in_fewer})
      EXPECT_THAT(messages::sentences(any.messages),
                  testing::Contains(testing::HasSubstr("per cent too small")));
    EXPECT_EQ(std::ranges::any_of(messages::sentences(found.messages),
                                  [](const std::string& text) {
                                    return text.find("a closed route reopens") != std::string::npos;
                                  }),
              direction == Direction::to);
  }
}

TEST(Isochrones, IsSearchedInThreeSectorsWhereCurrentsAreWeaker) {
  const ocean::Environment sea = eddy(0.2);
  IsochroneRequest request = reach_request(Direction::from, {24.0});
  const Isochrones found = reach(sea, request);
  request.sectors = 3;

  EXPECT_EQ(found.areas.front().area_m2, reach(sea, request).areas.front().area_m2);
  EXPECT_TRUE(found.messages.empty());
}

TEST(Isochrones, IsACircleAtTheSpeedOfAThrusterThatTheVehicleHas) {
  for (const Direction direction : {Direction::from, Direction::to}) {
    IsochroneRequest request = reach_request(direction, {12.0});
    request.vehicle = *vehicle::find_profile("slocum-g3-200-thruster");
    request.spacing.reset();

    const Isochrones found = reach({}, request);

    const double radius_m = request.vehicle.thruster->speed.value * 12.0 * 3600.0;
    EXPECT_NEAR(found.areas.front().area_m2, std::numbers::pi * radius_m * radius_m,
                0.04 * found.areas.front().area_m2);
    EXPECT_TRUE(found.messages.empty()) << messages::sentences(found.messages).front();
  }
}

TEST(Isochrones, StatesWhenTheVehicleIsThereOrHasToBe) {
  const IsochroneRequest from = reach_request(Direction::from, {6.0});
  const IsochroneRequest to = reach_request(Direction::to, {6.0});

  EXPECT_EQ(reach({}, from).areas.front().time, from.time + 6.0 * hour);
  EXPECT_EQ(reach({}, to).areas.front().time, to.time - 6.0 * hour);
}

TEST(Isochrones, DriftsWithAUniformCurrent) {
  const auto eastward = [](geo::LonLat, double) { return geo::VelocityEn{{0.2}, {0.0}}; };
  const ocean::Environment environment{.currents = support::currents_from(eastward, 48)};

  const Isochrone area = reach(environment, reach_request(Direction::from, {12.0})).areas.front();

  const geo::LonLat drifted =
      geo::geodesic_destination({-53.0, 69.0}, geo::Bearing::degrees(90.0), core::Metres{0.2 * 43200.0});
  for (const double course_deg : {0.0, 45.0, 90.0, 180.0, 270.0}) {
    const auto from_centre = [&](double share) {
      return geo::geodesic_destination(drifted, geo::Bearing::degrees(course_deg),
                                       core::Metres{share * glider_m_s * 43200.0});
    };
    EXPECT_TRUE(holds(area, from_centre(0.93))) << course_deg;
    EXPECT_FALSE(holds(area, from_centre(1.02))) << course_deg;
  }
}

TEST(Isochrones, OfALongerSpanCoversThatOfAShorterOne) {
  support::for_each_seed(4, [](std::mt19937_64& rng) {
    const double phase = support::uniform(rng, 0.0, 6.28);
    const auto currents = support::currents_from(
        [&](geo::LonLat p, double h) {
          return geo::VelocityEn{{0.25 * std::cos(h / 2.0 + phase)},
                                 {0.3 * std::sin(h / 3.0 + 9.0 * p.lat_deg)}};
        },
        48);
    const Direction direction = support::uniform_int(rng, 0, 1) == 1 ? Direction::from : Direction::to;

    const Isochrones found = reach({.currents = currents}, reach_request(direction, {4.0, 8.0, 10.0, 16.0}));

    for (int i = 0; i < 300; ++i) {
      const geo::LonLat place = somewhere(rng, 25'000.0);
      for (std::size_t a = 1; a < found.areas.size(); ++a) {
        EXPECT_LE(holds(found.areas[a - 1], place), holds(found.areas[a], place));
      }
    }
  });
}

TEST(Isochrones, HoldsPlacesThatAPlanReachesInTimeAndNoOthers) {
  const ocean::Environment environment{.currents = support::currents_from(tide, 96)};
  const IsochroneRequest request = reach_request(Direction::from, {16.0});
  const Isochrone area = reach(environment, request).areas.front();
  std::mt19937_64 rng{7};
  for (int i = 0; i < 25; ++i) {
    PlanRequest voyage = voyage_of(request);
    voyage.to = somewhere(rng, 24'000.0);
    voyage.spacing_along = core::Metres{500.0};

    const auto plan = plan_route(environment, voyage, {}, {});

    ASSERT_TRUE(plan.has_value());
    const double share = plan->travel_time() / area.span;
    if (std::abs(share - 1.0) < 0.04) continue;
    EXPECT_EQ(holds(area, voyage.to), share < 1.0) << share;
  }
}

TEST(Isochrones, BackwardsHoldsPlacesFromWhichAPlanArrivesInTimeAndNoOthers) {
  const ocean::Environment environment{.currents = support::currents_from(tide, 96)};
  const IsochroneRequest request = reach_request(Direction::to, {16.0});
  const Isochrone area = reach(environment, request).areas.front();
  std::mt19937_64 rng{8};
  for (int i = 0; i < 25; ++i) {
    PlanRequest voyage = voyage_of(request);
    voyage.from = somewhere(rng, 24'000.0);
    voyage.depart = area.time;
    voyage.spacing_along = core::Metres{500.0};

    const auto plan = plan_route(environment, voyage, {}, {});

    ASSERT_TRUE(plan.has_value());
    const double share = plan->travel_time() / area.span;
    if (std::abs(share - 1.0) < 0.04) continue;
    EXPECT_EQ(holds(area, voyage.from), share < 1.0) << share;
  }
}

TEST(Isochrones, LeavesOutAnIslandAndWhatLiesInItsLee) {
  ocean::Environment environment;
  environment.land = {
      {.outer = {{-52.9, 68.95}, {-52.8, 68.95}, {-52.8, 69.05}, {-52.9, 69.05}}, .holes = {}}};

  const Isochrone area = reach(environment, reach_request(Direction::from, {9.0})).areas.front();

  EXPECT_TRUE(holds(area, {-52.95, 69.0}));
  EXPECT_FALSE(holds(area, {-52.85, 69.0})) << "on the island";
  EXPECT_FALSE(holds(area, {-52.77, 69.0})) << "within 9 h only through the island";
  for (const geo::Polygon& polygon : area.polygons) {
    for (const geo::LonLat place : polygon.outer)
      EXPECT_FALSE(geo::contains(environment.land.front(), place));
  }
}

TEST(Isochrones, CrossesTheAntimeridianInTwoParts) {
  IsochroneRequest request = reach_request(Direction::from, {12.0});
  request.place = {179.95, 70.0};

  const Isochrone area = reach({}, request).areas.front();

  EXPECT_EQ(area.polygons.size(), 2U);
  EXPECT_TRUE(holds(area, {-179.9, 70.0}));
  EXPECT_TRUE(holds(area, {179.9, 70.0}));
}

TEST(Isochrones, SaysThatThePlaceIsOnLand) {
  const ocean::Environment environment{.bathymetry =
                                           support::bathymetry_from([](geo::LonLat) { return -5.0; })};

  const auto from = find_isochrones(environment, reach_request(Direction::from, {6.0}), {}, {});
  const auto to = find_isochrones(environment, reach_request(Direction::to, {6.0}), {}, {});

  EXPECT_EQ(from.error().reason, Reason::start_on_land);
  EXPECT_EQ(to.error().reason, Reason::goal_on_land);
}

TEST(Isochrones, RefusesAGridThatWouldNotFitAndAnImpossibleRequest) {
  IsochroneRequest request = reach_request(Direction::from, {720.0});
  request.spacing = core::Metres{100.0};
  EXPECT_EQ(find_isochrones({}, request, {}, {}).error().reason, Reason::too_large);

  request.spans.clear();
  EXPECT_THROW((void)find_isochrones({}, request, {}, {}), std::invalid_argument);
}

TEST(Isochrones, WarnsWhereTheBatteryDoesNotLast) {
  IsochroneRequest request = reach_request(Direction::from, {6.0, 24.0});
  EXPECT_TRUE(reach({}, request).messages.empty());
  request.vehicle.energy.battery = {1e5};

  const Isochrones found = reach({}, request);

  EXPECT_EQ(found.areas.size(), 2U);
  EXPECT_THAT(messages::sentences(found.messages),
              testing::Contains(testing::HasSubstr("0.09 MJ above its reserve")));
}

TEST(Isochrones, StopsWhenAsked) {
  std::stop_source source;
  source.request_stop();
  const auto found = find_isochrones({}, reach_request(Direction::from, {6.0}), source.get_token(), {});
  EXPECT_EQ(found.error().reason, Reason::cancelled);
}

}  // namespace
}  // namespace floeplan::planning::reach_test
