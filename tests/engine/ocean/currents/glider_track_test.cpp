#include "engine/ocean/currents/glider_track.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "tests/support/property.hpp"

namespace floeplan::ocean::glider_track_test {
namespace {

constexpr core::UtcTime start = core::from_unix_seconds(1.8e9);

TrackPoint point(double seconds, geo::LonLat place, std::optional<double> depth_m = {}) {
  return {.time = start + core::Seconds{seconds},
          .place = place,
          .depth = depth_m ? std::optional{core::Metres{*depth_m}} : std::nullopt};
}

/// A saw-tooth of dives, some depths missing.
std::vector<TrackPoint> random_dives(std::mt19937_64& rng, int count) {
  std::vector<TrackPoint> points;
  for (int i = 0; i < count; ++i) {
    points.push_back(point(10.0 * i, {0.001 * i, 60.0}, support::uniform(rng, 0.0, 900.0)));
    if (support::uniform_int(rng, 0, 9) == 0) points.back().depth.reset();
  }
  return points;
}

TEST(GliderTrack, IsAsDeepAsItsDeepestPoint) {
  EXPECT_EQ(deepest({point(0, {}), point(1, {}, 40.0), point(2, {}, 12.0)}), core::Metres{40.0});
  EXPECT_FALSE(deepest({point(0, {})}));
}

TEST(GliderTrack, HasTheMeanOfItsCurrents) {
  const std::vector<DepthAveragedCurrent> currents{{start, {}, {{0.4}, {-0.1}}},
                                                   {start, {}, {{-0.2}, {0.3}}}};

  const auto mean = mean_current(currents);

  ASSERT_TRUE(mean);
  EXPECT_NEAR(mean->east.value, 0.1, 1e-15);
  EXPECT_NEAR(mean->north.value, 0.1, 1e-15);
  EXPECT_FALSE(mean_current({}));
}

TEST(GliderTrack, ReachesAcrossTheAntimeridianTheShortWay) {
  const GliderTrack track{.glider = "g",
                          .points = {point(0, {179.5, 60.0}), point(1, {-179.5, 61.0})},
                          .currents = {{start, {-179.25, 60.5}, {}}}};

  EXPECT_EQ(bounding_box(track), (geo::BoundingBox{179.5, 60.0, -179.25, 61.0}));
}

TEST(GliderTrack, LiesBetweenItsPointsAtATimeBetweenTheirs) {
  const std::vector<TrackPoint> points{point(0, {179.0, 60.0}), point(100, {-179.0, 61.0})};

  EXPECT_EQ(place_at(points, start + core::Seconds{25.0}), (geo::LonLat{179.5, 60.25}));
  EXPECT_EQ(place_at(points, start + core::Seconds{75.0}), (geo::LonLat{-179.5, 60.75}));
  EXPECT_EQ(place_at(points, start - core::Seconds{1.0}), points.front().place);
  EXPECT_EQ(place_at(points, start + core::Seconds{101.0}), points.back().place);
  EXPECT_THROW(static_cast<void>(place_at({}, start)), std::invalid_argument);
}

TEST(GliderTrack, IsBetweenTwoDepthsInProportionToTime) {
  const std::vector<TrackPoint> points{point(0, {}), point(10, {}, 20.0), point(15, {}), point(30, {}, 60.0),
                                       point(40, {})};

  EXPECT_EQ(depths_along(points), (std::vector<double>{20.0, 20.0, 30.0, 60.0, 60.0}));
  EXPECT_TRUE(depths_along({point(0, {})}).empty());
}

TEST(GliderTrack, KeepsItsEndsItsOrderAndItsDepthWhenThinned) {
  support::for_each_seed(100, [](std::mt19937_64& rng) {
    const auto points = random_dives(rng, support::uniform_int(rng, 1, 300));
    const auto most = static_cast<std::size_t>(support::uniform_int(rng, 2, 60));

    const auto few = thinned(points, most);

    EXPECT_LE(few.size(), std::max<std::size_t>(most, 2));
    EXPECT_EQ(few.front(), points.front());
    EXPECT_EQ(few.back(), points.back());
    EXPECT_TRUE(std::ranges::is_sorted(few, {}, &TrackPoint::time));
    for (const TrackPoint& kept : few) EXPECT_NE(std::ranges::find(points, kept), points.end());
    if (most >= 4) {
      EXPECT_EQ(deepest(few), deepest(points));
    }
    if (points.size() <= most) {
      EXPECT_EQ(few, points);
    }
  });
}

}  // namespace
}  // namespace floeplan::ocean::glider_track_test
