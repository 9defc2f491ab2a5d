#include "engine/planning/obstacles/safety_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/planning/obstacles/bed_cells.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::obstacles::safety_map_test {
namespace {

using motion::EdgeClosed;

const geo::LocalProjection projection{{-53.0, 69.0}};
const plane::PlaneBox area{{-40'000.0, -40'000.0}, {40'000.0, 40'000.0}};
constexpr core::Metres least_depth{20.0};
constexpr core::Metres cell{400.0};

TEST(SafetyMap, IsOpenEverywhereWithoutData) {
  const ocean::Environment nothing;
  const SafetyMap map{nothing, least_depth, {}, projection, area, cell};

  EXPECT_FALSE(map.closed_between({-39'000.0, -39'000.0}, {39'000.0, 39'000.0}).has_value());
}

TEST(SafetyMap, ClosesEveryLineThatPassesWaterTooShallow) {
  const ocean::Environment environment{
      .bathymetry = support::bathymetry_from([](geo::LonLat p) {
        return 120.0 * (1.0 + std::sin(9.0 * p.lon_deg) * std::sin(20.0 * p.lat_deg)) - 10.0;
      })};
  const SafetyMap map{environment, least_depth, {}, projection, area, cell};

  support::for_each_seed(300, [&](std::mt19937_64& rng) {
    std::uniform_real_distribution<double> coordinate{-38'000.0, 38'000.0};
    std::uniform_real_distribution<double> reach{-4000.0, 4000.0};
    const geo::PlanePoint a{coordinate(rng), coordinate(rng)};
    const geo::PlanePoint b{std::clamp(a.x_m + reach(rng), -39'000.0, 39'000.0),
                            std::clamp(a.y_m + reach(rng), -39'000.0, 39'000.0)};
    EXPECT_EQ(map.closed_between(a, b).has_value(), map.closed_between(b, a).has_value());
    if (map.closed_between(a, b)) return;

    constexpr double slack_m = 0.1;  // the table of the plane is true to a metre on the ground
    for (int i = 0; i <= 200; ++i) {
      const double share = i / 200.0;
      const geo::PlanePoint point{a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m)};
      const auto depth = environment.bathymetry->depth(projection.to_lon_lat(point));
      ASSERT_TRUE(depth.has_value());
      EXPECT_GE(depth->value, least_depth.value - slack_m);
    }
  });
}

TEST(SafetyMap, ClosesEveryLineOverABedWhoseShoalsAreRidgesOfOneRow) {
  std::mt19937_64 depths{7};
  const ocean::Environment environment{.bathymetry = support::bathymetry_from([&](geo::LonLat) {
                                         return support::uniform(depths, 0.0, 1.0) < 0.15 ? 3.0 : 150.0;
                                       })};
  const SafetyMap map{environment, least_depth, {}, projection, area, cell};
  int open = 0;

  support::for_each_seed(2000, [&](std::mt19937_64& rng) {
    const geo::PlanePoint a{support::uniform(rng, -38'000.0, 38'000.0),
                            support::uniform(rng, -38'000.0, 38'000.0)};
    const geo::PlanePoint b{a.x_m + support::uniform(rng, -1000.0, 1000.0),
                            a.y_m + support::uniform(rng, -1000.0, 1000.0)};
    if (map.closed_between(a, b)) return;
    ++open;
    for (int i = 0; i <= 200; ++i) {
      const double share = i / 200.0;
      const geo::PlanePoint point{std::lerp(a.x_m, b.x_m, share), std::lerp(a.y_m, b.y_m, share)};
      ASSERT_GE(environment.bathymetry->depth(projection.to_lon_lat(point)).value().value,
                least_depth.value - 0.1);
    }
  });

  EXPECT_GT(open, 200);
}

TEST(SafetyMap, ClosesAnIslandSmallerThanACell) {
  ocean::Environment environment;
  environment.land = {{.outer = {{-53.001, 69.0}, {-52.999, 69.0}, {-53.0, 69.0005}}, .holes = {}}};
  const SafetyMap map{environment, least_depth, {}, projection, area, core::Metres{1000.0}};

  EXPECT_EQ(map.closed_between({-5000.0, 10.0}, {5000.0, 10.0}), EdgeClosed::on_land);
  EXPECT_FALSE(map.closed_between({-5000.0, 3000.0}, {5000.0, 3000.0}).has_value());
}

/// Law: a coast that lies mostly beyond the map closes exactly the places of the map that it covers.
TEST(SafetyMap, KnowsTheCoastOfAContinentWhereItLooks) {
  support::for_each_seed(40, [](std::mt19937_64& rng) {
    const double half_turn = std::numbers::pi;
    const geo::LonLat middle{support::uniform(rng, -56.0, -50.0), support::uniform(rng, 67.0, 71.0)};
    ocean::Environment environment;
    environment.land.emplace_back();
    for (int i = 0; i < 3000; ++i) {
      const double angle = 2.0 * half_turn * i / 3000.0;
      const double reach_deg = support::uniform(rng, 2.0, 2.05);
      environment.land.front().outer.push_back(
          {middle.lon_deg + 2.5 * reach_deg * std::cos(angle), middle.lat_deg + reach_deg * std::sin(angle)});
    }
    const SafetyMap map{environment, least_depth, {}, projection, area, cell};
    for (int i = 0; i < 300; ++i) {
      const geo::PlanePoint a{support::uniform(rng, -39e3, 39e3), support::uniform(rng, -39e3, 39e3)};
      const geo::PlanePoint b{support::uniform(rng, -39e3, 39e3), support::uniform(rng, -39e3, 39e3)};
      const geo::LonLat place = projection.to_lon_lat(a);
      const bool on_land = geo::contains(environment.land.front(), place);
      ASSERT_EQ(map.closed_at(place).has_value(), on_land);
      if (map.closed_between(a, b)) continue;
      for (double share = 0.0; share <= 1.0; share += 0.02) {
        const geo::PlanePoint point{a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m)};
        ASSERT_FALSE(geo::contains(environment.land.front(), projection.to_lon_lat(point)));
      }
    }
    const geo::LonLat far_away{middle.lon_deg + 2.0, middle.lat_deg};
    EXPECT_EQ(map.closed_at(far_away), EdgeClosed::on_land) << "also beyond the map";
  });
}

/// Law: the least depths of a sea bed that is there anyway make the same map.
TEST(SafetyMap, IsTheSameWithASeaBedOnItsRaster) {
  support::for_each_seed(20, [](std::mt19937_64& rng) {
    const double slope_m = support::uniform(rng, 50.0, 4000.0);
    const double unknown_deg = support::uniform(rng, -54.0, -52.0);
    const ocean::Environment environment{
        .bathymetry = support::bathymetry_from([&](geo::LonLat place) {
          const double hills_m = slope_m * std::sin(40.0 * place.lon_deg) * std::sin(90.0 * place.lat_deg);
          return std::abs(place.lon_deg - unknown_deg) < 0.05 ? std::nan("") : least_depth.value + hills_m;
        })};
    vehicle::GliderProfile vehicle = support::eastward_request().vehicle;
    vehicle.minimum_working_depth = least_depth;
    vehicle.dive_depth = core::Metres{support::uniform(rng, 0.2, 20.0) * least_depth.value};
    ASSERT_GE(vehicle.least_water(), least_depth);
    const auto bed = lay_out_bed(environment.bathymetry, vehicle, projection, area, cell, {});
    const SafetyMap alone{environment, vehicle.least_water(), {}, projection, area, cell};
    const SafetyMap map{environment, vehicle.least_water(), {}, projection, area, cell, bed.get()};

    for (int i = 0; i < 2000; ++i) {
      const geo::PlanePoint a{support::uniform(rng, -39e3, 39e3), support::uniform(rng, -39e3, 39e3)};
      const geo::PlanePoint b{a.x_m + support::uniform(rng, -2e3, 2e3),
                              a.y_m + support::uniform(rng, -2e3, 2e3)};
      ASSERT_EQ(map.closed_between(a, a), alone.closed_between(a, a));
      ASSERT_EQ(map.closed_between(a, b), alone.closed_between(a, b));
    }
  });
}

TEST(SafetyMap, LeavesALakeInAnIslandOpen) {
  ocean::Environment environment;
  environment.land = {{.outer = {{-53.4, 68.85}, {-52.6, 68.85}, {-52.6, 69.15}, {-53.4, 69.15}},
                       .holes = {{{-53.2, 68.95}, {-52.8, 68.95}, {-52.8, 69.05}, {-53.2, 69.05}}}}};
  const SafetyMap map{environment, least_depth, {}, projection, area, cell};

  EXPECT_FALSE(map.closed_between({-2000.0, 0.0}, {2000.0, 0.0}).has_value());
  EXPECT_EQ(map.closed_between({0.0, 0.0}, {0.0, 12'000.0}), EdgeClosed::on_land);
  EXPECT_EQ(map.closed_at({-53.3, 69.0}), EdgeClosed::on_land);
  EXPECT_FALSE(map.closed_at({-53.0, 69.0}).has_value());
}

TEST(SafetyMap, IsClosedBeyondTheBathymetry) {
  const ocean::Environment environment{.bathymetry =
                                           support::bathymetry_from([](geo::LonLat) { return 300.0; })};
  const geo::LocalProjection at_edge{{-50.2, 69.0}};
  const SafetyMap map{environment, least_depth, {}, at_edge, area, cell};

  EXPECT_FALSE(map.closed_between({-5000.0, 0.0}, {0.0, 0.0}).has_value());
  EXPECT_EQ(map.closed_between({0.0, 0.0}, {20'000.0, 0.0}), EdgeClosed::outside_data);
}

TEST(SafetyMap, OpensTheCellOfAPlaceThatIsOpenItself) {
  ocean::Environment environment;
  environment.land = {{.outer = {{-53.01, 69.002}, {-52.99, 69.002}, {-53.0, 69.02}}, .holes = {}}};
  SafetyMap map{environment, least_depth, {}, projection, area, core::Metres{1000.0}};
  const geo::PlanePoint start{100.0, 50.0};
  ASSERT_TRUE(map.closed_between(start, start).has_value());
  ASSERT_FALSE(map.closed_at(projection.to_lon_lat(start)).has_value());

  map.open_around(start);

  EXPECT_FALSE(map.closed_between(start, start).has_value());
  EXPECT_FALSE(map.closed_between(start, {100.0, -3000.0}).has_value());
}

/// An island of 200 m in the middle of a cell of 1000 m, and lines past it and over it.
TEST(SafetyMap, JudgesAGivenRouteByWhereItRuns) {
  ocean::Environment environment;
  environment.land = {
      {.outer = {{-53.0025, 68.999}, {-52.9975, 68.999}, {-52.9975, 69.001}, {-53.0025, 69.001}},
       .holes = {}}};
  const geo::PlanePoint west{-5000.0, 300.0};
  const geo::PlanePoint east{5000.0, 300.0};
  SafetyMap passed{environment, least_depth, {}, projection, area, core::Metres{1000.0}};
  ASSERT_TRUE(passed.closed_between(west, east).has_value());

  passed.open_along({{west, east}}, projection);
  EXPECT_FALSE(passed.closed_between(west, east).has_value());

  SafetyMap crossed{environment, least_depth, {}, projection, area, core::Metres{1000.0}};
  crossed.open_along({{west, east}, {{5000.0, 0.0}, {-5000.0, 0.0}}}, projection);
  EXPECT_EQ(crossed.closed_between({5000.0, 0.0}, {-5000.0, 0.0}), EdgeClosed::on_land)
      << "the leg beside the island must not open the way over it";
}

/// What is open along a route after open_along is open in the data, whichever cells are shared.
TEST(SafetyMap, NeverOpensARouteThatTheDataClose) {
  const ocean::Environment environment{
      .bathymetry = support::bathymetry_from([](geo::LonLat p) {
        return 60.0 * (1.0 + std::sin(9.0 * p.lon_deg) * std::sin(20.0 * p.lat_deg)) - 10.0;
      })};
  support::for_each_seed(60, [&](std::mt19937_64& rng) {
    SafetyMap map{environment, least_depth, {}, projection, area, core::Metres{2000.0}};
    std::vector<geo::PlanePoint> route;
    for (int i = 0; i < 6; ++i)
      route.push_back(
          {support::uniform(rng, -30'000.0, 30'000.0), support::uniform(rng, -30'000.0, 30'000.0)});

    map.open_along({route}, projection);

    for (std::size_t i = 1; i < route.size(); ++i) {
      if (map.closed_between(route[i - 1], route[i])) continue;
      for (int k = 0; k <= 400; ++k) {
        const double share = k / 400.0;
        const geo::LonLat place =
            projection.to_lon_lat({route[i - 1].x_m + share * (route[i].x_m - route[i - 1].x_m),
                                   route[i - 1].y_m + share * (route[i].y_m - route[i - 1].y_m)});
        ASSERT_GE(environment.bathymetry->depth(place)->value, least_depth.value - 1.0);
      }
    }
  });
}

}  // namespace
}  // namespace floeplan::planning::obstacles::safety_map_test
