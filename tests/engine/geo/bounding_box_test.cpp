#include "engine/geo/bounding_box.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "engine/geo/geodesic.hpp"
#include "tests/support/property.hpp"

namespace floeplan::geo::bounding_box_test {
namespace {

TEST(BoundingBox, HoldsItsEdges) {
  const BoundingBox box{-54.0, 68.0, -50.0, 70.0};

  EXPECT_TRUE(contains(box, {-54.0, 68.0}));
  EXPECT_TRUE(contains(box, {-50.0, 70.0}));
  EXPECT_TRUE(contains(box, {308.0, 69.0}));
  EXPECT_FALSE(contains(box, {-49.99, 69.0}));
  EXPECT_FALSE(contains(box, {-52.0, 70.01}));
}

TEST(BoundingBox, RunsAcrossTheAntimeridianWhenItsWestExceedsItsEast) {
  const BoundingBox box{170.0, -10.0, -170.0, 10.0};

  EXPECT_EQ(width_deg(box), 20.0);
  EXPECT_TRUE(contains(box, {180.0, 0.0}));
  EXPECT_TRUE(contains(box, {-175.0, 0.0}));
  EXPECT_FALSE(contains(box, {0.0, 0.0}));
}

TEST(BoundingBox, HasANearestPlaceAlsoAcrossTheAntimeridian) {
  const BoundingBox box{170.0, 60.0, -170.0, 70.0};

  EXPECT_EQ(nearest_place(box, {180.0, 65.0}), (LonLat{180.0, 65.0}));
  EXPECT_EQ(nearest_place(box, {-160.0, 75.0}), (LonLat{-170.0, 70.0}));
  EXPECT_EQ(nearest_place(box, {150.0, 50.0}), (LonLat{170.0, 60.0}));
}

TEST(BoundingBox, IsWrittenWithItsHemispheres) {
  EXPECT_EQ(bounds_text({-54.5, -1.0, 3.25, 69.6}), "54.5° W to 3.25° E, 1° S to 69.6° N");
  EXPECT_EQ(bounds_text({-54.5, 73.0, 3.25, 73.001}), "54.5° W to 3.25° E, 73° N");
}

TEST(BoundingBox, OfTheWholeCircleHoldsEveryLongitude) {
  const BoundingBox box{-180.0, 60.0, 180.0, 90.0};

  EXPECT_EQ(width_deg(box), 360.0);
  EXPECT_TRUE(contains(box, {180.0, 75.0}));
  EXPECT_TRUE(contains(box, {-0.1, 75.0}));
}

TEST(BoundingBox, IntersectsWhatItTouchesAlsoAcrossTheAntimeridian) {
  const BoundingBox across{170.0, 0.0, -170.0, 10.0};

  EXPECT_TRUE(intersects(across, {-175.0, 5.0, -160.0, 20.0}));
  EXPECT_TRUE(intersects(across, {-170.0, 10.0, -160.0, 20.0}));
  EXPECT_TRUE(intersects({-180.0, -90.0, 180.0, 90.0}, across));
  EXPECT_FALSE(intersects(across, {-169.0, 0.0, 169.0, 10.0}));
  EXPECT_FALSE(intersects(across, {175.0, 11.0, 178.0, 20.0}));
}

TEST(BoundingBox, OfPlacesTakesTheShortWayRound) {
  const std::vector<LonLat> places{{179.0, 5.0}, {-178.0, -3.0}, {181.0, 1.0}};

  EXPECT_EQ(bounding_box(places), (BoundingBox{179.0, -3.0, -178.0, 5.0}));
}

TEST(BoundingBox, NeedsAPlace) {
  EXPECT_THROW((void)bounding_box(std::vector<LonLat>{}), std::invalid_argument);
}

TEST(BoundingBox, GrownOverAPoleIsACap) {
  const BoundingBox cap = grown({10.0, 88.0, 20.0, 89.9}, core::Metres{50'000.0});

  EXPECT_EQ(width_deg(cap), 360.0);
  EXPECT_EQ(cap.north_deg, 90.0);
}

TEST(BoundingBox, OfPlacesHoldsThemAll) {
  support::for_each_seed(500, [](std::mt19937_64& rng) {
    std::vector<LonLat> places(static_cast<std::size_t>(support::uniform_int(rng, 1, 6)));
    std::generate(places.begin(), places.end(), [&] {
      return LonLat{support::uniform(rng, -180.0, 360.0), support::uniform(rng, -90.0, 90.0)};
    });

    const BoundingBox box = bounding_box(places);

    for (const LonLat place : places) EXPECT_TRUE(contains(box, place));
  });
}

TEST(BoundingBox, GrownHoldsEverythingWithinTheMargin) {
  support::for_each_seed(500, [](std::mt19937_64& rng) {
    const LonLat centre{support::uniform(rng, -180.0, 180.0), support::uniform(rng, -89.5, 89.5)};
    const core::Metres margin{support::uniform(rng, 10.0, 300'000.0)};
    const std::vector<LonLat> places{centre};

    const BoundingBox box = grown(bounding_box(places), margin);

    const Bearing course = Bearing::degrees(support::uniform(rng, 0.0, 360.0));
    const LonLat inside = geodesic_destination(centre, course, core::Metres{0.999 * margin.value});
    EXPECT_TRUE(contains(box, inside)) << centre.lon_deg << " " << centre.lat_deg << " " << margin.value;
  });
}

BoundingBox random_box(std::mt19937_64& rng) {
  const double south = support::uniform(rng, -90.0, 80.0);
  return {support::uniform(rng, -180.0, 180.0), south, support::uniform(rng, -180.0, 180.0),
          support::uniform(rng, south, 90.0)};
}

LonLat random_place_in(std::mt19937_64& rng, const BoundingBox& box) {
  return {wrap_longitude(box.west_deg + support::uniform(rng, 0.0, 1.0) * width_deg(box)),
          support::uniform(rng, box.south_deg, box.north_deg)};
}

TEST(BoundingBox, UnitedHoldsBoth) {
  support::for_each_seed(500, [](std::mt19937_64& rng) {
    const BoundingBox a = random_box(rng);
    const BoundingBox b = random_box(rng);

    const BoundingBox both = united(a, b);

    for (const BoundingBox& one : {a, b}) EXPECT_TRUE(contains(both, random_place_in(rng, one)));
    EXPECT_EQ(both.south_deg, std::min(a.south_deg, b.south_deg));
    EXPECT_EQ(both.north_deg, std::max(a.north_deg, b.north_deg));
    EXPECT_EQ(united(both, a), both) << "it grows no more by what it holds";
  });
}

TEST(BoundingBox, UnitedAcrossTheAntimeridian) {
  EXPECT_EQ(united({170.0, 60.0, 175.0, 62.0}, {-178.0, 61.0, -170.0, 65.0}),
            (BoundingBox{170.0, 60.0, -170.0, 65.0}));
  EXPECT_EQ(united({-180.0, 80.0, 180.0, 90.0}, {10.0, 70.0, 20.0, 85.0}),
            (BoundingBox{-180.0, 70.0, 180.0, 90.0}));
}

TEST(BoundingBox, OnALatticeHoldsTheBoxAndIsLittleWider) {
  support::for_each_seed(500, [](std::mt19937_64& rng) {
    constexpr double step_deg = 0.25;
    const BoundingBox box = random_box(rng);

    const BoundingBox lattice = on_lattice(box, step_deg);

    EXPECT_TRUE(contains(lattice, random_place_in(rng, box)));
    EXPECT_LE(width_deg(lattice), width_deg(box) + 2.0 * step_deg);
    EXPECT_GT(lattice.south_deg, box.south_deg - step_deg);
    EXPECT_LT(lattice.north_deg, box.north_deg + step_deg);
    for (const double edge : {lattice.west_deg, lattice.south_deg, lattice.east_deg, lattice.north_deg})
      EXPECT_EQ(std::remainder(edge, step_deg), 0.0);
    EXPECT_EQ(on_lattice(lattice, step_deg), lattice);
  });
}

}  // namespace
}  // namespace floeplan::geo::bounding_box_test
