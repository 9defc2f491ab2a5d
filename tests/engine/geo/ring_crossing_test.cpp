#include "engine/geo/ring_crossing.hpp"

#include <gtest/gtest.h>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <cmath>
#include <numbers>

#include "tests/support/property.hpp"

namespace floeplan::geo::ring_crossing_test {
namespace {

/// An hourglass: the corners of a box, two of them exchanged.
Ring hourglass(double west_deg) {
  return {{west_deg, 68.0}, {west_deg + 4.0, 70.0}, {west_deg + 4.0, 68.0}, {west_deg, 70.0}};
}

TEST(RingCrossing, IsFoundWhereCornersAreOutOfOrder) {
  const RingCrossing found = find_crossing(hourglass(-54.0));

  ASSERT_TRUE(found.place);
  EXPECT_NEAR(found.place->lon_deg, -52.0, 1e-9);
  EXPECT_NEAR(found.place->lat_deg, 69.0, 1e-9);
}

TEST(RingCrossing, IsFoundAcrossTheAntimeridian) {
  Ring ring = hourglass(177.5);
  for (LonLat& place : ring) place.lon_deg = wrap_longitude(place.lon_deg);

  const RingCrossing found = find_crossing(ring);

  ASSERT_TRUE(found.place);
  EXPECT_NEAR(found.place->lon_deg, 179.5, 1e-9);
}

/// A hole that is reached by a cut, which is passed along twice; a corner that lies on another edge.
TEST(RingCrossing, IsNoneWhereEdgesTouch) {
  const Ring keyhole{{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}, {2.0, 4.0}, {2.0, 3.0}, {1.0, 2.0},
                     {2.0, 1.0}, {3.0, 2.0}, {2.0, 3.0}, {2.0, 4.0}, {0.0, 4.0}};
  const Ring touching{{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}, {2.0, 0.0}, {0.0, 4.0}};
  const Ring cut_to_the_pole{{-180.0, -60.0}, {-60.0, -70.0}, {60.0, -70.0},
                             {180.0, -60.0},  {180.0, -90.0}, {-180.0, -90.0}};

  for (const Ring& ring : {keyhole, touching, cut_to_the_pole}) {
    const RingCrossing found = find_crossing(ring);
    EXPECT_FALSE(found.place);
    EXPECT_TRUE(found.is_looked_through);
  }
}

/// Boost.Geometry decides independently for random outlines, whose edges hardly ever touch without crossing.
TEST(RingCrossing, IsFoundExactlyWhereAnotherLibrarySeesOne) {
  namespace bg = boost::geometry;
  int crossed = 0;
  support::for_each_seed(300, [&](std::mt19937_64& rng) {
    Ring ring;
    const int corners = support::uniform_int(rng, 4, 12);
    const double unrest = support::uniform(rng, 0.0, 2.0);
    for (int i = 0; i < corners; ++i) {
      const double angle = 2.0 * std::numbers::pi * (i + unrest * support::uniform(rng, -1.0, 1.0)) / corners;
      const double radius_deg = support::uniform(rng, 1.0, 3.0);
      ring.push_back({10.0 + radius_deg * std::cos(angle), 50.0 + radius_deg * std::sin(angle)});
    }
    bg::model::linestring<bg::model::d2::point_xy<double>> line;
    for (const LonLat place : ring) line.emplace_back(place.lon_deg, place.lat_deg);
    line.emplace_back(ring.front().lon_deg, ring.front().lat_deg);

    const bool is_crossed = find_crossing(ring).place.has_value();

    EXPECT_EQ(is_crossed, !bg::is_simple(line));
    crossed += is_crossed ? 1 : 0;
  });
  EXPECT_GT(crossed, 30);
  EXPECT_LT(crossed, 270);
}

TEST(RingCrossing, IsNotSoughtWithoutEndAmongEdgesThatAllLieBesideEachOther) {
  Ring comb;
  for (int i = 0; i < 100'000; ++i) comb.push_back({i % 2 == 0 ? 0.0 : 90.0, 1e-4 * i});
  comb.push_back({-1.0, 20.0});

  EXPECT_FALSE(find_crossing(comb).is_looked_through);
}

}  // namespace
}  // namespace floeplan::geo::ring_crossing_test
