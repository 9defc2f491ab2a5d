#include "engine/geo/polygon.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/property.hpp"

namespace floeplan::geo::polygon_test {
namespace {

Ring rectangle(double west_deg, double south_deg, double east_deg, double north_deg) {
  return {{west_deg, south_deg}, {east_deg, south_deg}, {east_deg, north_deg}, {west_deg, north_deg}};
}

TEST(Polygon, HoldsItsInsideWithoutItsHoles) {
  const Polygon island{.outer = rectangle(-54.0, 68.0, -50.0, 70.0),
                       .holes = {rectangle(-53.0, 68.5, -52.0, 69.0)}};

  EXPECT_TRUE(contains(island, {-51.0, 69.5}));
  EXPECT_FALSE(contains(island, {-52.5, 68.75}));
  EXPECT_FALSE(contains(island, {-49.0, 69.0}));
  EXPECT_FALSE(contains(island, {-51.0, 71.0}));
}

TEST(Polygon, CrossesTheAntimeridian) {
  const Polygon island{.outer = {{178.0, 70.0}, {-177.0, 70.0}, {-177.0, 72.0}, {178.0, 72.0}}, .holes = {}};

  EXPECT_TRUE(contains(island, {179.5, 71.0}));
  EXPECT_TRUE(contains(island, {-178.0, 71.0}));
  EXPECT_TRUE(contains(island, {182.0, 71.0}));
  EXPECT_FALSE(contains(island, {0.0, 71.0}));
  EXPECT_FALSE(contains(island, {177.0, 71.0}));
  EXPECT_EQ(bounding_box(island), (BoundingBox{178.0, 70.0, -177.0, 72.0}));
}

/// The corners of a band are far apart, but this is no gap in the band.
TEST(Polygon, ThatLeadsAllTheWayRoundHasABoxThatDoes) {
  Polygon band;
  for (int lon_deg = -180; lon_deg <= 180; lon_deg += 60) band.outer.push_back({1.0 * lon_deg, 60.0});
  for (int lon_deg = 180; lon_deg >= -180; lon_deg -= 60) band.outer.push_back({1.0 * lon_deg, 80.0});

  EXPECT_EQ(bounding_box(band), (BoundingBox{-180.0, 60.0, 180.0, 80.0}));
  EXPECT_TRUE(contains(band, {150.0, 70.0}));
}

TEST(Polygon, ThatIsWideHasABoxAcrossItsWidestEdge) {
  const Polygon wide{
      .outer = {{-100.0, 60.0}, {20.0, 60.0}, {100.0, 60.0}, {100.0, 80.0}, {20.0, 80.0}, {-100.0, 80.0}},
      .holes = {}};

  EXPECT_EQ(bounding_box(wide), (BoundingBox{-100.0, 60.0, 100.0, 80.0}));
}

/// Law: the answer for many places at once is the answer for each of them; also on its corners' meridians and
/// across the antimeridian.
TEST(Polygon, HoldsOfManyPlacesThoseThatItHoldsOneByOne) {
  support::for_each_seed(300, [](std::mt19937_64& rng) {
    const double middle_deg = support::uniform(rng, -180.0, 180.0);
    const auto near = [&](double reach_deg) {
      return LonLat{wrap_longitude(middle_deg + support::uniform(rng, -reach_deg, reach_deg)),
                    support::uniform(rng, 60.0, 80.0)};
    };
    Polygon land;
    for (int i = 0; i < 40; ++i) land.outer.push_back(near(60.0));
    land.holes.emplace_back();
    for (int i = 0; i < 10; ++i) land.holes.front().push_back(near(20.0));
    std::vector<LonLat> places{{.lon_deg = middle_deg + 180.0, .lat_deg = 70.0}};
    for (const LonLat corner : land.outer)
      places.push_back({corner.lon_deg, support::uniform(rng, 60.0, 80.0)});
    for (int i = 0; i < 200; ++i) places.push_back(near(70.0));

    const std::vector lands{land, Polygon{.outer = {near(60.0), near(60.0), near(60.0)}, .holes = {}}};

    const std::vector<bool> contained = contained_in_any(lands, places);

    for (std::size_t i = 0; i < places.size(); ++i)
      ASSERT_EQ(contained[i], contains(lands[0], places[i]) || contains(lands[1], places[i])) << i;
  });
  EXPECT_TRUE(contained_in_any({}, {}).empty());
}

TEST(Polygon, IsNotMisreadOnTheMeridianOfACorner) {
  for (int step = 0; step <= 1000; ++step) {
    const double lon_deg = -54.0 + step * 0.004;
    const Polygon island{
        .outer = {{lon_deg - 0.3, 69.1}, {lon_deg, 69.0}, {lon_deg + 0.7, 69.1}, {lon_deg, 69.2}},
        .holes = {}};

    ASSERT_TRUE(contains(island, {lon_deg, 69.1})) << lon_deg;
    ASSERT_FALSE(contains(island, {lon_deg, 68.9})) << lon_deg;
    ASSERT_FALSE(contains(island, {lon_deg, 69.3})) << lon_deg;
  }
}

TEST(Polygon, WithoutPlacesHoldsNothing) { EXPECT_FALSE(contains(Polygon{}, {0.0, 0.0})); }

TEST(Polygon, HoldsTheSamePlacesWhereverItsRingStartsAndWhicheverWayItRuns) {
  support::for_each_seed(300, [](std::mt19937_64& rng) {
    Ring ring(static_cast<std::size_t>(support::uniform_int(rng, 3, 9)));
    std::generate(ring.begin(), ring.end(), [&] {
      return LonLat{wrap_longitude(180.0 + support::uniform(rng, -5.0, 5.0)),
                    support::uniform(rng, 60.0, 70.0)};
    });
    Ring turned = ring;
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    std::reverse(turned.begin(), turned.end());
    const LonLat place{180.0 + support::uniform(rng, -6.0, 6.0), support::uniform(rng, 59.0, 71.0)};

    EXPECT_EQ(contains(Polygon{ring, {}}, place), contains(Polygon{turned, {}}, place));
  });
}

TEST(Polygon, ThatIsARectangleHoldsWhatItsBoxHolds) {
  support::for_each_seed(500, [](std::mt19937_64& rng) {
    const double west_deg = support::uniform(rng, -180.0, 180.0);
    const double east_deg = wrap_longitude(west_deg + support::uniform(rng, 1.0, 170.0));
    const BoundingBox box{west_deg, -20.0, east_deg, 30.0};
    const LonLat place{support::uniform(rng, -180.0, 180.0), support::uniform(rng, -40.0, 50.0)};

    const Polygon polygon{rectangle(west_deg, -20.0, east_deg, 30.0), {}};

    EXPECT_EQ(contains(polygon, place), contains(box, place));
  });
}

}  // namespace
}  // namespace floeplan::geo::polygon_test
