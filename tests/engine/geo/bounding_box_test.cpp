#include "engine/geo/bounding_box.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "engine/geo/geodesic.hpp"
#include "tests/support/property.hpp"

namespace floeplan::geo {
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

}  // namespace
}  // namespace floeplan::geo
