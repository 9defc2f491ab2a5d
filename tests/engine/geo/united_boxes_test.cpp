#include "engine/geo/united_boxes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "tests/support/property.hpp"

namespace floeplan::geo::united_boxes_test {
namespace {

using support::for_each_seed;
using support::uniform;
using support::uniform_int;

BoundingBox random_box(std::mt19937_64& rng) {
  const double west = uniform(rng, -180.0, 180.0);
  const double south = uniform(rng, -80.0, 70.0);
  return {west, south, wrap_longitude(west + uniform(rng, 0.0, 60.0)), south + uniform(rng, 0.0, 10.0)};
}

TEST(UnitedBoxes, RunAcrossTheAntimeridianWhereThatIsShorter) {
  EXPECT_EQ(united(std::vector<BoundingBox>{{170.0, 60.0, 175.0, 61.0}, {-175.0, 62.0, -170.0, 63.0}}),
            (BoundingBox{170.0, 60.0, -170.0, 63.0}));
  EXPECT_EQ(united(std::vector<BoundingBox>{{-10.0, 50.0, -5.0, 55.0}, {-20.0, 51.0, -8.0, 52.0}}),
            (BoundingBox{-20.0, 50.0, -5.0, 55.0}));
  EXPECT_EQ(united(std::vector<BoundingBox>{{-180.0, -90.0, 180.0, 90.0}, {3.0, 4.0, 5.0, 6.0}}),
            (BoundingBox{-180.0, -90.0, 180.0, 90.0}));
  EXPECT_THROW((void)united(std::vector<BoundingBox>{}), std::invalid_argument);
}

TEST(UnitedBoxes, HoldAllWhateverTheirOrderAndEndWhereOneOfThemDoes) {
  for_each_seed(500, [](std::mt19937_64& rng) {
    std::vector<BoundingBox> boxes;
    for (int i = uniform_int(rng, 1, 6); i > 0; --i) boxes.push_back(random_box(rng));

    const BoundingBox all = united(boxes);

    for (const BoundingBox& box : boxes) {
      EXPECT_TRUE(holds(all, box));
      EXPECT_EQ(holds(box, all), width_deg(all) <= width_deg(box) + 1e-9 && all.south_deg >= box.south_deg &&
                                     all.north_deg <= box.north_deg);
      for (const double share : {1e-6, 0.3, 0.7, 1.0 - 1e-6}) {
        const LonLat place{wrap_longitude(box.west_deg + share * width_deg(box)),
                           box.south_deg + share * (box.north_deg - box.south_deg)};
        EXPECT_TRUE(contains(all, place)) << place.lon_deg;
      }
    }
    // None is narrower: it would begin at some box's west and reach all others.
    for (const BoundingBox& first : boxes) {
      double reach_deg = 0.0;
      for (const BoundingBox& box : boxes) {
        double begins_deg = longitude_difference(first.west_deg, box.west_deg);
        if (begins_deg < 0.0) begins_deg += 360.0;
        reach_deg = std::max(reach_deg, begins_deg + width_deg(box));
      }
      EXPECT_LE(width_deg(all), std::min(reach_deg, 360.0) + 1e-9);
    }
    std::ranges::shuffle(boxes, rng);
    EXPECT_EQ(united(boxes), all);
  });
}

TEST(UnitedBoxes, SharedPartIsInBoth) {
  for_each_seed(500, [](std::mt19937_64& rng) {
    const BoundingBox a = random_box(rng);
    const BoundingBox b = random_box(rng);

    const auto part = shared(a, b);

    ASSERT_EQ(part.has_value(), intersects(a, b));
    for (int i = 0; i < 20; ++i) {
      const LonLat place{wrap_longitude(a.west_deg + uniform(rng, 0.001, 0.999) * width_deg(a)),
                         a.south_deg + uniform(rng, 0.001, 0.999) * (a.north_deg - a.south_deg)};
      EXPECT_EQ(part && contains(*part, place), contains(b, place));
    }
  });
}

TEST(UnitedBoxes, ShareHeldIsThatOfThePlacesInside) {
  constexpr int places = 60;  // a side
  for_each_seed(200, [](std::mt19937_64& rng) {
    const BoundingBox outer = random_box(rng);
    const BoundingBox inner = random_box(rng);
    int inside = 0;
    for (int i = 0; i < places; ++i) {
      for (int k = 0; k < places; ++k) {
        const double east = (i + 0.5) / places;
        const double north = (k + 0.5) / places;
        inside += contains(outer, {wrap_longitude(inner.west_deg + east * width_deg(inner)),
                                   inner.south_deg + north * (inner.north_deg - inner.south_deg)});
      }
    }
    EXPECT_NEAR(share_held(outer, inner), inside / double{places * places}, 2.0 / places);
    EXPECT_EQ(share_held(inner, inner), 1.0);
  });
  EXPECT_EQ(share_held({170.0, 50.0, -170.0, 60.0}, {-175.0, 55.0, -175.0, 55.0}), 1.0) << "a place";
  EXPECT_EQ(share_held({170.0, 50.0, -170.0, 60.0}, {-165.0, 55.0, -165.0, 55.0}), 0.0);
}

}  // namespace
}  // namespace floeplan::geo::united_boxes_test
