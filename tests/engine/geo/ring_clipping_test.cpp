#include "engine/geo/ring_clipping.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/geo/ring_turns.hpp"
#include "tests/support/property.hpp"

namespace floeplan::geo::ring_clipping_test {
namespace {

/// Even-odd rule on longitudes that run on without a jump.
bool inside(const Ring& ring, LonLat place) {
  bool is_inside = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const LonLat& a = ring[j];
    const LonLat& b = ring[i];
    if ((a.lon_deg > place.lon_deg) == (b.lon_deg > place.lon_deg)) continue;
    const double share = (place.lon_deg - a.lon_deg) / (b.lon_deg - a.lon_deg);
    if (std::lerp(a.lat_deg, b.lat_deg, share) > place.lat_deg) is_inside = !is_inside;
  }
  return is_inside;
}

bool inside_any(const std::vector<Ring>& rings, LonLat place) {
  bool is_inside = false;
  for (const Ring& ring : rings)
    if (inside(ring, place)) is_inside = !is_inside;
  return is_inside;
}

TEST(RingClipping, LeavesInsideAndOutsideInTheWindowAsTheyAre) {
  int held = 0;
  support::for_each_seed(300, [&](std::mt19937_64& rng) {
    const double middle_deg = support::uniform(rng, -180.0, 180.0);
    Ring ring;
    const int corners = support::uniform_int(rng, 3, 20);
    for (int i = 0; i < corners; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / corners;
      ring.push_back({wrap_longitude(middle_deg + support::uniform(rng, 5.0, 80.0) * std::cos(angle)),
                      support::uniform(rng, 5.0, 90.0) * std::sin(angle)});
    }
    const GlobeWindow window{.middle_lon_deg = support::uniform(rng, -180.0, 180.0),
                             .half_width_deg = support::uniform(rng, 1.0, 150.0),
                             .south_deg = support::uniform(rng, -80.0, 0.0),
                             .north_deg = support::uniform(rng, 1.0, 80.0)};
    const std::vector<Ring> parts = clipped(ring, window);

    for (int i = 0; i < 40; ++i) {
      const double offset_deg = support::uniform(rng, -window.half_width_deg, window.half_width_deg);
      const LonLat place{window.middle_lon_deg + offset_deg,
                         support::uniform(rng, window.south_deg, window.north_deg)};
      const bool expected =
          contains({.outer = ring, .holes = {}}, {wrap_longitude(place.lon_deg), place.lat_deg});
      ASSERT_EQ(inside_any(parts, place), expected) << place.lon_deg << ' ' << place.lat_deg;
      held += expected ? 1 : 0;
    }
    for (const Ring& part : parts) {
      for (const LonLat place : part) {
        EXPECT_LE(std::abs(place.lon_deg - window.middle_lon_deg), window.half_width_deg + 1e-9);
        EXPECT_GE(place.lat_deg, window.south_deg - 1e-9);
        EXPECT_LE(place.lat_deg, window.north_deg + 1e-9);
      }
    }
  });
  EXPECT_GT(held, 500);
}

/// Everything south of 60 S: along the parallel, and back along the pole.
Ring southern_cap() {
  Ring ring;
  for (int lon_deg = -180; lon_deg <= 180; lon_deg += 60) ring.push_back({wrap_longitude(lon_deg), -60.0});
  for (int lon_deg = 180; lon_deg >= -180; lon_deg -= 60) ring.push_back({wrap_longitude(lon_deg), -90.0});
  return ring;
}

TEST(RingClipping, LeavesNothingOfTheOtherEndOfTheEarth) {
  EXPECT_TRUE(clipped(southern_cap(), {.middle_lon_deg = -53.0, .south_deg = -45.0}).empty());
}

TEST(RingClipping, KeepsWhatLeadsAllTheWayRound) {
  const std::vector<Ring> round = clipped(southern_cap(), {.middle_lon_deg = 100.0, .north_deg = 45.0});
  const std::vector<Ring> part = clipped(southern_cap(), {.middle_lon_deg = 170.0, .half_width_deg = 30.0});

  ASSERT_EQ(round.size(), 1U);
  EXPECT_EQ(round.front(), counted_on(southern_cap(), 100.0));
  EXPECT_TRUE(inside_any(part, {195.0, -70.0}));
  EXPECT_TRUE(inside_any(part, {145.0, -70.0}));
  EXPECT_FALSE(inside_any(part, {195.0, -50.0}));
}

}  // namespace
}  // namespace floeplan::geo::ring_clipping_test
