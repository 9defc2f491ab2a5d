#include "engine/simulation/world/iceberg_shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "tests/support/property.hpp"

namespace floeplan::simulation::iceberg_shape_test {
namespace {

using support::for_each_seed;
using support::uniform;
using enum IcebergForm;

constexpr std::array<IcebergForm, 6> forms{tabular, blocky, domed, pinnacle, wedge, drydock};
constexpr core::UtcTime now = core::from_unix_seconds(1.7e9);

Body berg_of(IcebergForm form, double length_m, double draft_m, std::mt19937_64& rng) {
  return Body{"berg", iceberg_shape(form, {length_m}, {draft_m}, rng), {.track = {{now, 0.0, 0.0}}}};
}

TEST(IcebergShape, IsAsLongAndAsDeepAsAskedForAndNoMore) {
  for_each_seed(30, [](std::mt19937_64& rng) {
    for (const IcebergForm form : forms) {
      const double length_m = uniform(rng, 10.0, 300.0);
      const double draft_m = uniform(rng, 5.0, 200.0);
      const Body berg = berg_of(form, length_m, draft_m, rng);
      const BodyPose pose = berg.pose_at(now);

      double deepest_m = 0.0;
      double farthest_m = 0.0;
      for (int i = 0; i < 4000; ++i) {
        const Vector point{uniform(rng, -length_m, length_m), uniform(rng, -length_m, length_m),
                           uniform(rng, 0.0, 1.2 * draft_m)};
        if (!berg.contains(pose, point)) continue;
        deepest_m = std::max(deepest_m, point.down);
        farthest_m = std::max(farthest_m, std::hypot(point.east, point.north));
      }

      EXPECT_LE(deepest_m, draft_m);
      EXPECT_GT(deepest_m, 0.7 * draft_m);
      EXPECT_LE(farthest_m, berg.shape().radius_m);
      EXPECT_GT(farthest_m, 0.35 * length_m);
    }
  });
}

TEST(IcebergShape, IsAsLongAtTheSurfaceButForWhatIsChipped) {
  for_each_seed(20, [](std::mt19937_64& rng) {
    for (const IcebergForm form : {tabular, blocky, domed, pinnacle, wedge}) {
      const Body berg = berg_of(form, 100.0, 80.0, rng);
      const auto hit = berg.first_hit(berg.pose_at(now), {0.0, 200.0, 0.0}, {0.0, -1.0, 0.0}, 400.0);
      ASSERT_TRUE(hit.has_value());
      EXPECT_GE(hit->range_m, 150.0 - 1e-9);
      EXPECT_LE(hit->range_m, 153.0);
    }
  });
}

TEST(IcebergShape, DrawsAPinnacleInTowardsItsKeel) {
  auto rng = std::mt19937_64{3};
  const Body berg = berg_of(pinnacle, 100.0, 80.0, rng);
  const BodyPose pose = berg.pose_at(now);

  EXPECT_TRUE(berg.contains(pose, {0.0, 35.0, 2.0}));
  EXPECT_FALSE(berg.contains(pose, {0.0, 35.0, 70.0}));
}

TEST(IcebergShape, LeavesADockBetweenTheColumnsOfADrydock) {
  auto rng = std::mt19937_64{3};
  const Body berg = berg_of(drydock, 100.0, 100.0, rng);
  const BodyPose pose = berg.pose_at(now);

  EXPECT_FALSE(berg.contains(pose, {0.0, 0.0, 10.0}));
  EXPECT_TRUE(berg.contains(pose, {0.0, 0.0, 50.0}));
  EXPECT_FALSE(berg.contains(pose, {0.0, 0.0, 90.0}));
  EXPECT_TRUE(berg.contains(pose, {24.0, 0.0, 90.0}));
}

TEST(IcebergShape, IsTheSameForTheSameSeed) {
  std::mt19937_64 a{9};
  std::mt19937_64 b{9};
  const Shape one = iceberg_shape(domed, {80.0}, {60.0}, a);
  const Shape two = iceberg_shape(domed, {80.0}, {60.0}, b);

  for (std::size_t i = 0; i < one.parts.front().faces().size(); ++i)
    EXPECT_EQ(one.parts.front().faces()[i].offset_m, two.parts.front().faces()[i].offset_m);
}

TEST(IcebergShape, RefusesABergWithoutSize) {
  std::mt19937_64 rng{1};
  EXPECT_THROW(static_cast<void>(iceberg_shape(tabular, {0.0}, {10.0}, rng)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(iceberg_shape(tabular, {10.0}, {std::nan("")}, rng)), std::invalid_argument);
}

TEST(LikelyDraft, LiesBetweenTheRelationsInUse) {
  // A length of 60 m: 33 m after C-CORE, 53 m after Barker et al.
  for_each_seed(100, [](std::mt19937_64& rng) {
    const double draft_m = likely_draft({60.0}, rng).value;
    EXPECT_GE(draft_m, 32.5);
    EXPECT_LE(draft_m, 53.5);
  });
}

TEST(IcebergForm, IsTheOneThatTheCodeNames) {
  std::mt19937_64 rng{1};
  EXPECT_EQ(iceberg_form("TAB", rng), tabular);
  EXPECT_EQ(iceberg_form("DD", rng), drydock);
  EXPECT_NO_THROW(static_cast<void>(iceberg_form("GEN", rng)));
}

}  // namespace
}  // namespace floeplan::simulation::iceberg_shape_test
