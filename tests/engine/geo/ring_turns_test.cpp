#include "engine/geo/ring_turns.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace floeplan::geo::ring_turns_test {
namespace {

using testing::HasSubstr;

Ring parallel(double lat_deg, int step_deg) {
  Ring ring;
  for (int lon_deg = -180; lon_deg < 180; lon_deg += step_deg) ring.push_back({1.0 * lon_deg, lat_deg});
  return ring;
}

TEST(RingTurns, AreCountedRoundAPole) {
  EXPECT_EQ(turn_of({{170.0, 60.0}, {-170.0, 60.0}, {-170.0, 70.0}}), 0.0);
  EXPECT_EQ(turn_of(parallel(70.0, 30)), 360.0);
}

TEST(RingTurns, LeaveDoubtWhereARingLeadsRoundAPoleOrHasVeryLongEdges) {
  const Polygon clear{.outer = {{-100.0, 60.0}, {-20.0, 60.0}, {-20.0, 80.0}, {-100.0, 80.0}}, .holes = {}};
  Polygon with_hole = clear;
  with_hole.holes = {parallel(70.0, 30)};
  const Polygon wide{.outer = {{-100.0, 60.0}, {60.0, 60.0}, {60.0, 80.0}, {-20.0, 80.0}}, .holes = {}};

  EXPECT_EQ(doubt_in_turns(clear), "");
  EXPECT_THAT(doubt_in_turns(with_hole), HasSubstr("round a pole"));
  EXPECT_THAT(doubt_in_turns(wide), HasSubstr("160 degrees"));
}

TEST(RingTurns, AreCountedOnWithoutAJump) {
  const Ring ring = counted_on({{170.0, 60.0}, {-170.0, 61.0}, {-120.0, 62.0}}, -175.0);

  EXPECT_EQ(ring, (Ring{{-190.0, 60.0}, {-170.0, 61.0}, {-120.0, 62.0}}));
}

}  // namespace
}  // namespace floeplan::geo::ring_turns_test
