#include "engine/geo/polygon_interior.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/property.hpp"

namespace floeplan::geo::polygon_interior_test {
namespace {

using support::for_each_seed;
using support::uniform;
using support::uniform_int;

Ring square(double west, double south, double side) {
  return {{wrap_longitude(west), south},
          {wrap_longitude(west + side), south},
          {wrap_longitude(west + side), south + side},
          {wrap_longitude(west), south + side}};
}

TEST(PolygonInterior, CornersAndEdgesAreCoveredOnEverySide) {
  const Polygon polygon{square(-8.0, 52.0, 1.0), {square(-7.7, 52.3, 0.4)}};
  for (const LonLat place : {LonLat{-8.0, 52.0}, LonLat{-7.0, 53.0}, LonLat{-8.0, 52.5}, LonLat{-7.0, 52.5},
                             LonLat{-7.5, 52.0}, LonLat{-7.5, 53.0}, LonLat{-7.7, 52.4}, LonLat{-7.3, 52.5}})
    EXPECT_TRUE(covers(polygon, place, 1e-9)) << place.lon_deg << ' ' << place.lat_deg;
  EXPECT_FALSE(covers(polygon, {-7.5, 52.5}, 1e-9)) << "in the hole";
  EXPECT_FALSE(covers(polygon, {-8.001, 52.5}, 1e-9));
  EXPECT_TRUE(covers(polygon, {-8.001, 52.5}, 0.0011));
}

TEST(PolygonInterior, TheMiddleIsInTheRoomiestPart) {
  const auto middle = interior_point({square(179.5, 60.0, 1.0), {}});
  ASSERT_TRUE(middle);
  EXPECT_NEAR(std::abs(middle->lon_deg), 180.0, 1e-9);
  EXPECT_NEAR(middle->lat_deg, 60.5, 1e-9);
  EXPECT_FALSE(interior_point({{{1.0, 1.0}, {2.0, 2.0}, {3.0, 3.0}}, {}})) << "encloses nothing";
  EXPECT_FALSE(interior_point({{{1.0, 1.0}, {2.0, 1.0}, {3.0, 1.0}}, {}}));
}

/// Stars with a hole round their centre, anywhere on the globe but at the poles.
TEST(PolygonInterior, TheMiddleIsAlwaysInside) {
  for_each_seed(500, [](std::mt19937_64& rng) {
    const LonLat centre{uniform(rng, -180.0, 180.0), uniform(rng, -60.0, 60.0)};
    const double size_deg = std::pow(10.0, uniform(rng, -3.0, 1.3));
    const auto star = [&](double least, double most) {
      Ring ring;
      const int corners = uniform_int(rng, 3, 30);
      for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * (i + uniform(rng, 0.0, 0.9)) / corners;
        const double reach = size_deg * uniform(rng, least, most);
        ring.push_back({wrap_longitude(centre.lon_deg + reach * std::cos(angle)),
                        centre.lat_deg + reach * std::sin(angle)});
      }
      return ring;
    };
    const Polygon polygon{star(0.5, 1.0), {star(0.01, 0.1)}};

    const auto middle = interior_point(polygon);

    ASSERT_TRUE(middle);
    EXPECT_TRUE(contains(polygon, *middle));
    EXPECT_TRUE(covers(polygon, *middle, 0.0));
  });
}

}  // namespace
}  // namespace floeplan::geo::polygon_interior_test
