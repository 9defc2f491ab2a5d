#include "engine/avoidance/vertical_room.hpp"

#include <gtest/gtest.h>

#include <array>
#include <memory>

namespace floeplan::avoidance::vertical_room_test {
namespace {

AvoidanceSettings to_60_m() {
  AvoidanceSettings settings;
  settings.deepest = core::Metres{60.0};
  return settings;
}

OwnState own_over(double second, double depth_m, std::optional<double> bed_m = {}) {
  OwnState own;
  own.time = core::from_unix_seconds(1e9 + second);
  own.depth = core::Metres{depth_m};
  if (bed_m) own.altitude = core::Metres{*bed_m - depth_m};
  return own;
}

Echo echo(double x, double depth) { return {{x, 0.0}, depth, x, depth, depth}; }

/// Gives the same echo in several pings, and returns whether the last echo is passed.
bool passes(VerticalRoom& room, const Echo& shown, int pings = 5) {
  bool passed = false;
  for (int i = 0; i < pings; ++i) {
    room.begin_ping({&shown, 1});
    passed = room.passes(shown) != VerticalRoom::Pass::no;
  }
  return passed;
}

TEST(VerticalRoom, PassesOverWhatLiesBelowTheSawTooth) {
  const auto room = std::make_unique<VerticalRoom>(to_60_m());
  room->sound(own_over(0.0, 20.0), {});
  EXPECT_TRUE(passes(*room, echo(100.0, 71.0)));
  EXPECT_FALSE(passes(*room, echo(100.0, 69.0)));
  EXPECT_FALSE(room->deepest());
}

TEST(VerticalRoom, TellsASeaBedFromAWallByItsSlope) {
  const auto room = std::make_unique<VerticalRoom>(to_60_m());
  room->sound(own_over(0.0, 20.0, 60.0), {});
  EXPECT_TRUE(passes(*room, echo(50.0, 55.0)));
  EXPECT_FALSE(passes(*room, echo(50.0, 40.0)));
}

TEST(VerticalRoom, GoesRoundABedThatLeavesNoRoom) {
  const auto room = std::make_unique<VerticalRoom>(to_60_m());
  room->sound(own_over(0.0, 10.0, 32.0), {});
  EXPECT_TRUE(passes(*room, echo(50.0, 31.0)));
  EXPECT_FALSE(passes(*room, echo(50.0, 29.0)));  // 29 m less the margin is no 15 m below 5 m
}

TEST(VerticalRoom, HoldsTheSawToothAboveAConfirmedBed) {
  const auto room = std::make_unique<VerticalRoom>(to_60_m());
  room->sound(own_over(0.0, 20.0, 68.0), {});
  ASSERT_TRUE(room->deepest());
  EXPECT_DOUBLE_EQ(room->deepest()->value, 58.0);
  EXPECT_TRUE(passes(*room, echo(80.0, 52.0), 1));
  EXPECT_DOUBLE_EQ(room->deepest()->value, 58.0);  // one echo may be a false alarm
  EXPECT_TRUE(passes(*room, echo(80.0, 52.0), 3));
  EXPECT_DOUBLE_EQ(room->deepest()->value, 42.0);
  room->sound(own_over(300.0, 20.0), {500.0, 0.0});
  EXPECT_FALSE(room->deepest());
}

TEST(VerticalRoom, KeepsBelowTheIceOverhead) {
  const auto room = std::make_unique<VerticalRoom>(to_60_m());
  room->sound(own_over(0.0, 40.0), {});
  EXPECT_TRUE(passes(*room, echo(10.0, 15.0)));
  ASSERT_TRUE(room->shallowest());
  EXPECT_DOUBLE_EQ(room->shallowest()->value, 25.0);
  EXPECT_TRUE(passes(*room, echo(60.0, 18.0)));   // the underside goes on
  EXPECT_FALSE(passes(*room, echo(60.0, 34.0)));  // a keel that hangs from it does not
}

/// An echo above a nearer echo, or above one straight below, belongs to a wall, however steep its direction.
TEST(VerticalRoom, TakesNoWallForIceOverhead) {
  const auto room = std::make_unique<VerticalRoom>(to_60_m());
  room->sound(own_over(0.0, 40.0), {});
  const Echo above{{12.0, 0.0}, 15.0, 28.0, 9.0, 22.0};
  const Echo wall{{12.0, 1.0}, 27.0, 18.0, 22.0, 32.0};
  const Echo underside{{30.0, 1.0}, 15.0, 39.0, 7.0, 23.0};
  for (int ping = 0; ping < 5; ++ping) {
    const std::array echoes{wall, above};
    room->begin_ping(echoes);
    EXPECT_EQ(room->passes(above), VerticalRoom::Pass::no);
  }
  EXPECT_FALSE(room->shallowest());
  for (int ping = 0; ping < 5; ++ping) {
    const std::array echoes{underside, above};
    room->begin_ping(echoes);
    EXPECT_EQ(room->passes(above), VerticalRoom::Pass::below);
  }
  EXPECT_TRUE(room->shallowest());
}

TEST(VerticalRoom, KnowsABedBeyondTheAltimeterByEchoesFromSteeplyBelow) {
  const auto room = std::make_unique<VerticalRoom>(to_60_m());
  room->sound(own_over(0.0, 5.0), {});
  EXPECT_FALSE(passes(*room, echo(120.0, 60.0)));
  EXPECT_TRUE(passes(*room, echo(30.0, 65.0)));
  EXPECT_TRUE(passes(*room, echo(120.0, 60.0)));
  EXPECT_FALSE(passes(*room, echo(120.0, 30.0)));
}

TEST(VerticalRoom, TakesAnEchoForTheBedThatItsBeamReachesDownTo) {
  const auto room = std::make_unique<VerticalRoom>(to_60_m());
  room->sound(own_over(0.0, 20.0, 64.0), {});
  EXPECT_TRUE(passes(*room, {{150.0, 0.0}, 22.0, 150.0, 3.0, 41.0}));
  EXPECT_FALSE(passes(*room, {{50.0, 0.0}, 22.0, 50.0, 16.0, 28.0}));
  EXPECT_FALSE(passes(*room, echo(150.0, 22.0)));
}

TEST(VerticalRoom, GoesRoundABedThatRisesFasterThanItClimbs) {
  const auto above = std::make_unique<VerticalRoom>(to_60_m());
  above->sound(own_over(0.0, 50.0, 66.0), {});
  EXPECT_TRUE(passes(*above, echo(20.0, 59.0)));
  const auto below = std::make_unique<VerticalRoom>(to_60_m());
  below->sound(own_over(0.0, 58.0, 66.0), {});
  EXPECT_FALSE(passes(*below, echo(20.0, 59.0)));
}

/// Eastward over a bed that begins at 24 m and gets shoaler by `rise` in each metre.
std::optional<VerticalRoom::ShoalEdge> shoal_over(double rise) {
  AvoidanceSettings settings = to_60_m();
  settings.least_water = core::Metres{20.0};
  const auto room = std::make_unique<VerticalRoom>(settings);
  for (double east_m = 0.0; east_m <= 20.0; east_m += 4.0) {
    OwnState own = own_over(east_m / 0.4, 8.0, 24.0 - rise * east_m);
    own.attitude.pitch = core::Radians{-0.45};
    room->sound(own, {east_m, 0.0});
    if (const auto shoal = room->take_shoal()) return shoal;
  }
  return std::nullopt;
}

TEST(VerticalRoom, MeetsAShoalThatTheAltimeterSeesRising) {
  const auto shoal = shoal_over(0.08);

  ASSERT_TRUE(shoal);
  const Echo& middle = (*shoal)[2];
  EXPECT_NEAR(middle.place.x_m, 16.0 + 40.0, 1.0);  // as near as it may be to be turned away from
  EXPECT_NEAR(middle.place.y_m, 0.0, 1e-9);
  EXPECT_NEAR((*shoal)[0].place.y_m, -(*shoal)[4].place.y_m, 1e-9);
  EXPECT_LT(middle.deepest_m, 20.0);
}

TEST(VerticalRoom, MeetsNoShoalOverAnEvenBedOrOneThatFalls) {
  EXPECT_FALSE(shoal_over(0.0));
  EXPECT_FALSE(shoal_over(0.02));
  EXPECT_FALSE(shoal_over(-0.2));
}

TEST(VerticalRoom, TakesOutTheObjectsThatAreTheBed) {
  const AvoidanceSettings settings = to_60_m();
  const auto objects = std::make_unique<ObjectMap>(settings);
  objects->advance(1e9);
  const OwnState own = own_over(0.0, 5.0);
  for (int ping = 0; ping < 6; ++ping) {
    const std::array echoes{echo(100.0, 62.0), echo(150.0, 20.0)};
    objects->take(echoes, own, {});
  }
  ASSERT_EQ(objects->size(), 2U);
  const auto room = std::make_unique<VerticalRoom>(settings);
  room->sound(own, {});
  room->take_beds(*objects);
  EXPECT_EQ(objects->size(), 2U);  // nothing is known of a bed

  room->sound(own_over(20.0, 15.0, 66.0), {});
  room->take_beds(*objects);

  ASSERT_EQ(objects->size(), 1U);
  EXPECT_LT((*objects)[0].keel_m(), 30.0);
  ASSERT_TRUE(room->deepest());
  EXPECT_NEAR(room->deepest()->value, 52.0, 1.0);
}

TEST(VerticalRoom, UnlearnsABedWhereTheAltimeterHearsNone) {
  const auto room = std::make_unique<VerticalRoom>(to_60_m());
  room->sound(own_over(0.0, 5.0, 30.0), {});  // the foot of a berg
  EXPECT_TRUE(passes(*room, echo(20.0, 31.0)));
  for (double second = 1.0; second < 60.0; second += 1.0) {
    OwnState diving = own_over(second, 20.0);
    diving.attitude.pitch = core::Radians{-0.45};
    room->sound(diving, {10.0, 0.0});
  }
  EXPECT_FALSE(passes(*room, echo(60.0, 31.0)));
  EXPECT_FALSE(room->deepest());
}

TEST(VerticalRoom, LeavesTheLeastBandWhereIceAndBedSeemToLeaveNone) {
  const auto room = std::make_unique<VerticalRoom>(to_60_m());
  room->sound(own_over(0.0, 30.0, 49.0), {});
  EXPECT_TRUE(passes(*room, echo(8.0, 20.0)));
  ASSERT_TRUE(room->shallowest() && room->deepest());
  EXPECT_DOUBLE_EQ(room->deepest()->value - room->shallowest()->value, 15.0);
  EXPECT_DOUBLE_EQ(room->shallowest()->value, 27.0);
}

TEST(VerticalRoom, DoesNotWalkDownAWall) {
  const auto room = std::make_unique<VerticalRoom>(to_60_m());
  room->sound(own_over(0.0, 40.0), {});
  EXPECT_TRUE(passes(*room, echo(10.0, 12.0)));
  for (double depth = 14.0; depth < 32.0; depth += 2.0) (void)passes(*room, echo(14.0, depth));
  EXPECT_FALSE(passes(*room, echo(14.0, 32.0)));
}

}  // namespace
}  // namespace floeplan::avoidance::vertical_room_test
