#include "engine/geo/coarse_outline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/property.hpp"

namespace floeplan::geo::coarse_outline_test {
namespace {

/// Round a middle, with a rough coast; wider than high.
Ring rough_ring(std::mt19937_64& rng, LonLat middle, double radius_deg, int corners) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners;
    const double reach_deg = radius_deg * support::uniform(rng, 0.6, 1.0);
    ring.push_back({wrap_longitude(middle.lon_deg + 3.0 * reach_deg * std::cos(angle)),
                    std::clamp(middle.lat_deg + reach_deg * std::sin(angle), -90.0, 90.0)});
  }
  return ring;
}

Polygon rough_land(std::mt19937_64& rng) {
  const LonLat middle{support::uniform(rng, -180.0, 180.0), support::uniform(rng, -75.0, 75.0)};
  const double radius_deg = support::uniform(rng, 2.0, 40.0);
  return {.outer = rough_ring(rng, middle, radius_deg, support::uniform_int(rng, 3, 400)),
          .holes = {rough_ring(rng, middle, 0.5 * radius_deg, 50)}};
}

BoundingBox box_near(std::mt19937_64& rng, LonLat corner) {
  const double west_deg = wrap_longitude(corner.lon_deg + support::uniform(rng, -30.0, 10.0));
  const double south_deg = std::clamp(corner.lat_deg + support::uniform(rng, -8.0, 3.0), -90.0, 85.0);
  if (support::uniform_int(rng, 0, 9) == 0) return {-180.0, south_deg, 180.0, 90.0};
  return {west_deg, south_deg, wrap_longitude(west_deg + support::uniform(rng, 0.1, 40.0)),
          south_deg + support::uniform(rng, 0.1, 5.0)};
}

LonLat place_in(std::mt19937_64& rng, const BoundingBox& box) {
  return {wrap_longitude(box.west_deg + support::uniform(rng, 0.0, width_deg(box))),
          support::uniform(rng, box.south_deg, box.north_deg)};
}

TEST(CoarseOutline, IsTheSameInTheBox) {
  support::for_each_seed(2000, [](std::mt19937_64& rng) {
    const Polygon land = rough_land(rng);
    const BoundingBox box = box_near(rng, land.outer.front());

    const Polygon coarse = coarse_beyond(box, land);

    ASSERT_LE(coarse.outer.size(), land.outer.size());
    for (int i = 0; i < 40; ++i) {
      const LonLat place = place_in(rng, box);
      ASSERT_EQ(contains(coarse, place), contains(land, place)) << place.lon_deg << ' ' << place.lat_deg;
    }
  });
}

TEST(CoarseOutline, KeepsTheEdgesThatReachIntoTheBox) {
  support::for_each_seed(500, [](std::mt19937_64& rng) {
    const Polygon land = rough_land(rng);
    const BoundingBox box = box_near(rng, land.outer.front());
    const auto edges_within = [&](const Ring& ring) {
      std::vector<std::pair<LonLat, LonLat>> edges;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const LonLat a = ring[i];
        const LonLat b = ring[(i + 1) % ring.size()];
        const bool ends_in = contains(box, a) || contains(box, b);
        if (ends_in) edges.emplace_back(a, b);
      }
      return edges;
    };

    EXPECT_EQ(edges_within(coarse_beyond(box, land).outer), edges_within(land.outer));
  });
}

TEST(CoarseOutline, OfAContinentIsShortWhereLittleOfItIsLookedAt) {
  std::mt19937_64 rng{1};
  const Polygon continent{.outer = rough_ring(rng, {-40.0, 72.0}, 12.0, 100'000), .holes = {}};

  const Polygon coarse = coarse_beyond({-54.0, 68.0, -50.0, 70.0}, continent);

  EXPECT_LT(coarse.outer.size(), 12'000U);
  EXPECT_LE(coarse_beyond({100.0, -10.0, 110.0, 0.0}, continent).outer.size(), 2U);
}

TEST(CoarseOutline, OfWhatLiesInTheBoxIsItsOutline) {
  const Polygon island{.outer = {{178.0, 70.0}, {-177.0, 70.0}, {-177.0, 72.0}, {178.0, 72.0}}, .holes = {}};

  EXPECT_EQ(coarse_beyond({170.0, 60.0, -170.0, 80.0}, island).outer, island.outer);
  EXPECT_EQ(coarse_beyond({-180.0, -90.0, 180.0, 90.0}, island).outer, island.outer);
}

}  // namespace
}  // namespace floeplan::geo::coarse_outline_test
