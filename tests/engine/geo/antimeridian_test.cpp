#include "engine/geo/antimeridian.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>

#include "engine/geo/local_projection.hpp"
#include "tests/support/property.hpp"

namespace floeplan::geo::antimeridian_test {
namespace {

namespace bg = boost::geometry;
using Point = bg::model::d2::point_xy<double>;
using Drawn = bg::model::multi_polygon<bg::model::polygon<Point, false, true>>;

Drawn drawn(const std::vector<Polygon>& polygons) {
  const auto ring = [](const Ring& places) {
    Drawn::value_type::ring_type result;
    for (const LonLat place : places) result.emplace_back(place.lon_deg, place.lat_deg);
    result.push_back(result.front());
    return result;
  };
  Drawn result;
  for (const Polygon& polygon : polygons) {
    Drawn::value_type one;
    one.outer() = ring(polygon.outer);
    for (const Ring& hole : polygon.holes) one.inners().push_back(ring(hole));
    result.push_back(one);
  }
  return result;
}

/// Counter-clockwise round a place, seen from above, with a radius that swings.
Ring round(LonLat centre, double radius_m, double swing, int points) {
  const LocalProjection projection{centre};
  Ring ring;
  for (int i = 0; i < points; ++i) {
    const double angle = 2.0 * 3.14159265358979 * i / points;
    const double r = radius_m * (1.0 + swing * std::sin(5.0 * angle));
    ring.push_back(projection.to_lon_lat({r * std::cos(angle), r * std::sin(angle)}));
  }
  return ring;
}

void expect_valid(const std::vector<Polygon>& pieces) {
  std::string reason;
  EXPECT_TRUE(bg::is_valid(drawn(pieces), reason)) << reason;
  for (const Polygon& piece : pieces) {
    for (const LonLat place : piece.outer) {
      EXPECT_GE(place.lon_deg, -180.0);
      EXPECT_LE(place.lon_deg, 180.0);
    }
  }
}

TEST(SplitAtAntimeridian, LeavesAPolygonAsItIsThatDoesNotCrossIt) {
  const Polygon polygon{.outer = round({-53.0, 69.0}, 5e4, 0.2, 60),
                        .holes = {{{-53.1, 69.0}, {-53.0, 69.05}, {-52.9, 69.0}}}};

  const auto pieces = split_at_antimeridian(polygon);

  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces.front().outer.size(), 60U);
  expect_valid(pieces);
}

TEST(SplitAtAntimeridian, CutsAPolygonAcrossItIntoOnesToItsWestAndEast) {
  const Polygon polygon{.outer = round({179.9, 70.0}, 5e4, 0.0, 90), .holes = {}};

  const auto pieces = split_at_antimeridian(polygon);

  ASSERT_EQ(pieces.size(), 2U);
  expect_valid(pieces);
  EXPECT_TRUE(bg::within(Point{179.8, 70.0}, drawn(pieces)));
  EXPECT_TRUE(bg::within(Point{-179.8, 70.0}, drawn(pieces)));
  EXPECT_FALSE(bg::within(Point{0.0, 70.0}, drawn(pieces)));
}

TEST(SplitAtAntimeridian, KeepsHolesOutOfThePieces) {
  Ring hole = round({-179.9, 70.0}, 2e4, 0.0, 30);
  std::ranges::reverse(hole);
  const Polygon polygon{.outer = round({179.9, 70.0}, 5e4, 0.0, 90), .holes = {hole}};

  const auto pieces = split_at_antimeridian(polygon);

  expect_valid(pieces);
  EXPECT_FALSE(bg::within(Point{-179.8, 70.0}, drawn(pieces)));
  EXPECT_FALSE(bg::within(Point{179.95, 70.0}, drawn(pieces)));
  EXPECT_TRUE(bg::within(Point{179.2, 70.0}, drawn(pieces)));
}

TEST(SplitAtAntimeridian, RunsAlongThePoleThatAPolygonHolds) {
  for (const double side : {1.0, -1.0}) {
    const Polygon polygon{.outer = round({30.0, side * 89.5}, 2e5, 0.1, 120), .holes = {}};

    const auto pieces = split_at_antimeridian(polygon);

    expect_valid(pieces);
    for (const double lon_deg : {-170.0, -60.0, 0.0, 90.0, 179.0}) {
      EXPECT_TRUE(bg::within(Point{lon_deg, side * 89.9}, drawn(pieces))) << lon_deg;
      EXPECT_FALSE(bg::within(Point{lon_deg, side * 80.0}, drawn(pieces))) << lon_deg;
    }
  }
}

TEST(SplitAtAntimeridian, LeavesOutAPoleThatAHoleHolds) {
  Ring hole = round({0.0, 89.9}, 5e4, 0.0, 60);
  std::ranges::reverse(hole);
  const Polygon polygon{.outer = round({30.0, 89.5}, 4e5, 0.0, 120), .holes = {hole}};

  const auto pieces = split_at_antimeridian(polygon);

  expect_valid(pieces);
  EXPECT_FALSE(bg::within(Point{100.0, 89.95}, drawn(pieces)));
  EXPECT_TRUE(bg::within(Point{100.0, 88.0}, drawn(pieces)));
}

TEST(SplitAtAntimeridian, LeavesAPolygonThatEndsOnItInOnePlace) {
  const Polygon polygon{.outer = {{170.0, 60.0}, {180.0, 60.0}, {180.0, 65.0}, {170.0, 65.0}}, .holes = {}};

  const auto pieces = split_at_antimeridian(polygon);

  ASSERT_EQ(pieces.size(), 1U);
  for (const LonLat place : pieces.front().outer) EXPECT_GE(place.lon_deg, 170.0);
}

TEST(SplitAtAntimeridian, TakesARingRoundThePoleThatBeginsOnItButForRounding) {
  for (const double begin_deg : {180.0 - 1e-12, 180.0, -180.0, -180.0 + 1e-12}) {
    Ring ring;
    for (int i = 0; i < 12; ++i) ring.push_back({wrap_longitude(begin_deg + 30.0 * i), 80.0});

    const auto pieces = split_at_antimeridian({ring, {}});

    expect_valid(pieces);
    EXPECT_TRUE(bg::within(Point{10.0, 85.0}, drawn(pieces))) << begin_deg;
    EXPECT_FALSE(bg::within(Point{10.0, 70.0}, drawn(pieces))) << begin_deg;
  }
}

TEST(SplitAtAntimeridian, CoversTheSamePlaces) {
  support::for_each_seed(60, [](std::mt19937_64& rng) {
    const LonLat centre{support::uniform(rng, 170.0, 190.0), support::uniform(rng, -75.0, 75.0)};
    const LocalProjection projection{centre};
    constexpr double radius_m = 3e5;
    const double swing = support::uniform(rng, 0.0, 0.6);
    const Polygon polygon{.outer = round(centre, radius_m, swing, 400), .holes = {}};

    const auto pieces = split_at_antimeridian(polygon);

    expect_valid(pieces);
    for (int i = 0; i < 50; ++i) {
      const PlanePoint point{support::uniform(rng, -4e5, 4e5), support::uniform(rng, -4e5, 4e5)};
      const double rim_m = radius_m * (1.0 + swing * std::sin(5.0 * std::atan2(point.y_m, point.x_m)));
      const double from_centre_m = std::hypot(point.x_m, point.y_m);
      if (std::abs(from_centre_m - rim_m) < 0.05 * radius_m) continue;
      const LonLat place = projection.to_lon_lat(point);
      EXPECT_EQ(bg::within(Point{wrap_longitude(place.lon_deg), place.lat_deg}, drawn(pieces)),
                from_centre_m < rim_m);
    }
  });
}

/// Law: an area round a pole is one piece that holds the pole and its middle, also where corners lie on the
/// antimeridian but for rounding.
TEST(SplitAtAntimeridian, LeavesAnAreaRoundAPoleWhole) {
  for (const double lat_deg : {90.0, 89.99, 89.95, -89.95, -89.99, -90.0}) {
    for (const double lon_deg : {0.0, 180.0, -90.0, 37.0}) {
      for (const int corners : {16, 64, 97, 100}) {
        for (const double radius_m : {7560.0, 30'000.0}) {
          const auto pieces = split_at_antimeridian({round({lon_deg, lat_deg}, radius_m, 0.0, corners), {}});
          ASSERT_EQ(pieces.size(), 1U) << lon_deg << ' ' << lat_deg << ' ' << corners << ' ' << radius_m;
          expect_valid(pieces);
          const double towards_pole_deg = lat_deg > 0.0 ? 89.999 : -89.999;
          for (const double there_deg : {-179.0, -60.0, 1.0, 120.0, 179.0})
            EXPECT_TRUE(contains(pieces.front(), {there_deg, towards_pole_deg})) << there_deg;
          EXPECT_FALSE(contains(pieces.front(), {1.0, lat_deg > 0.0 ? 89.0 : -89.0}));
        }
      }
    }
  }
}

}  // namespace
}  // namespace floeplan::geo::antimeridian_test
