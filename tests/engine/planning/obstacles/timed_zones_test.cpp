#include "engine/planning/obstacles/timed_zones.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/support/property.hpp"

namespace floeplan::planning::obstacles::timed_zones_test {
namespace {

using core::Seconds;
using ocean::Zone;
using ocean::ZoneKind;

const geo::LocalProjection projection{{-53.0, 69.0}};
const plane::PlaneBox area{{-3000.0, -4000.0}, {4000.0, 3000.0}};  // less than what is asked about
const core::UtcTime epoch = core::UtcTime{Seconds{1.7e9}};

/// A square around a middle, in metres of the plane.
geo::Polygon square(geo::PlanePoint middle, double half_side_m) {
  geo::Polygon polygon;
  for (const auto& [x, y] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
    polygon.outer.push_back(
        projection.to_lon_lat({middle.x_m + x * half_side_m, middle.y_m + y * half_side_m}));
  }
  return polygon;
}

Zone zone(ZoneKind kind, geo::Polygon outline, std::optional<double> from_s, std::optional<double> until_s) {
  Zone result{.name = "", .kind = kind, .area = std::move(outline), .from = {}, .until = {}};
  if (from_s) result.from = epoch + Seconds{*from_s};
  if (until_s) result.until = epoch + Seconds{*until_s};
  return result;
}

/// A few large zones or many small ones.
std::vector<Zone> random_zones(std::mt19937_64& rng) {
  const bool many = support::uniform_int(rng, 0, 1) == 1;
  std::uniform_real_distribution<double> coordinate{-5000.0, 5000.0};
  std::uniform_real_distribution<double> size{many ? 50.0 : 500.0, many ? 600.0 : 4000.0};
  std::uniform_real_distribution<double> begin{0.0, 8000.0};
  std::uniform_real_distribution<double> length{500.0, 6000.0};
  std::bernoulli_distribution stays_in{0.3};
  std::vector<Zone> zones;
  for (int i = 0; i < (many ? 60 : 4); ++i) {
    const double from_s = begin(rng);
    zones.push_back(zone(stays_in(rng) ? ZoneKind::stay_in : ZoneKind::no_go,
                         square({coordinate(rng), coordinate(rng)}, size(rng)), from_s,
                         from_s + length(rng)));
  }
  return zones;
}

/// Whether the zones themselves close a place at a time.
bool breaks_a_rule(const std::vector<Zone>& zones, geo::PlanePoint point, Seconds time) {
  bool confined = false;
  bool inside = false;
  for (const Zone& each : zones) {
    if (epoch + time < *each.from || epoch + time > *each.until) continue;
    const bool contained = geo::contains(each.area, projection.to_lon_lat(point));
    if (each.kind == ZoneKind::no_go && contained) return true;
    if (each.kind == ZoneKind::stay_in) {
      confined = true;
      inside = inside || contained;
    }
  }
  return confined && !inside;
}

TEST(TimedZones, ForbidEveryDriveThatBreaksARuleAtAnyMoment) {
  int forbidden = 0;
  support::for_each_seed(300, [&](std::mt19937_64& rng) {
    const std::vector<Zone> zones = random_zones(rng);
    const TimedZones timed{zones, projection, area, epoch};
    std::uniform_real_distribution<double> coordinate{-6000.0, 6000.0};
    std::uniform_real_distribution<double> when{0.0, 10'000.0};
    const geo::PlanePoint a{coordinate(rng), coordinate(rng)};
    const geo::PlanePoint b{coordinate(rng), coordinate(rng)};
    const TimeSpan during{Seconds{when(rng)}, Seconds{12'000.0}};

    bool broken = false;
    for (int i = 0; i <= 3000 && !broken; ++i) {
      const double share = i / 3000.0;
      const geo::PlanePoint here{a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m)};
      broken = breaks_a_rule(zones, here, during.from + share * (during.until - during.from));
    }
    EXPECT_TRUE(!broken || timed.forbid(a, b, during));
    forbidden += broken ? 1 : 0;
  });
  EXPECT_GT(forbidden, 50);
}

TEST(TimedZones, LetADrivePassThatKeepsEveryRuleWithRoomToSpare) {
  const std::vector<Zone> zones{zone(ZoneKind::no_go, square({0.0, 0.0}, 1000.0), 1000.0, 2000.0),
                                zone(ZoneKind::stay_in, square({0.0, 0.0}, 8000.0), 0.0, 500.0)};
  const TimedZones timed{zones, projection, area, epoch};
  const geo::PlanePoint west{-5000.0, 0.0};
  const geo::PlanePoint east{5000.0, 0.0};

  EXPECT_FALSE(timed.forbid(west, east, {Seconds{2001.0}, Seconds{9000.0}})) << "after it";
  EXPECT_FALSE(timed.forbid(west, east, {Seconds{-500.0}, Seconds{900.0}})) << "before it";
  EXPECT_FALSE(timed.forbid(west, {-2000.0, 0.0}, {Seconds{0.0}, Seconds{3000.0}}))
      << "beside it while it is in force";
  EXPECT_TRUE(timed.forbid(west, east, {Seconds{0.0}, Seconds{3000.0}})) << "through it";
}

TEST(TimedZones, AnswerTheSameForThePieceOfAnEdgeAsForAnEvenDrive) {
  support::for_each_seed(200, [](std::mt19937_64& rng) {
    const TimedZones timed{random_zones(rng), projection, area, epoch};
    std::uniform_real_distribution<double> coordinate{-6000.0, 6000.0};
    const motion::PlaneEdge edge{
        {coordinate(rng), coordinate(rng)}, {coordinate(rng), coordinate(rng)}, core::Metres{7000.0}};
    const motion::EdgePiece even{
        .t0_s = 1000.0, .way0_m = 0.0, .v0_m_s = 0.7, .t1_s = 11'000.0, .way1_m = 7000.0, .v1_m_s = 0.7};
    EXPECT_EQ(timed.forbid(edge, even),
              timed.forbid(edge.from, edge.to, {Seconds{1000.0}, Seconds{11'000.0}}));
  });
}

TEST(TimedZones, CloseAPointWheneverStandingThereBreaksARule) {
  support::for_each_seed(200, [](std::mt19937_64& rng) {
    const std::vector<Zone> zones = random_zones(rng);
    const TimedZones timed{zones, projection, area, epoch};
    std::uniform_real_distribution<double> coordinate{-6000.0, 6000.0};
    const geo::PlanePoint point{coordinate(rng), coordinate(rng)};

    const std::vector<TimeSpan> closed = timed.closed_times(point);
    EXPECT_TRUE(std::ranges::is_sorted(closed, {}, &TimeSpan::from));
    for (double t = 0.5; t < 15'000.0; t += 37.0) {
      const auto holds = [&](const TimeSpan& span) {
        return span.from.count() <= t && t <= span.until.count();
      };
      EXPECT_EQ(std::ranges::any_of(closed, holds), breaks_a_rule(zones, point, Seconds{t})) << "at " << t;
    }
  });
}

TEST(TimedZones, WithRoomLetNoDrivePassThatBreaksARuleALittleBesideEarlierOrLater) {
  constexpr Room room{core::Metres{40.0}, Seconds{300.0}};
  int passed = 0;
  int kept_off = 0;
  support::for_each_seed(2000, [&](std::mt19937_64& rng) {
    const std::vector<Zone> zones = random_zones(rng);
    const TimedZones exact{zones, projection, area, epoch};
    const TimedZones roomy{zones, projection, area, epoch, room};
    const auto coordinate = [&] { return support::uniform(rng, -6000.0, 6000.0); };
    const geo::PlanePoint a{coordinate(), coordinate()};
    const geo::PlanePoint b{a.x_m + support::uniform(rng, -900.0, 900.0),
                            a.y_m + support::uniform(rng, -900.0, 900.0)};
    const double depart_s = support::uniform(rng, 0.0, 10'000.0);
    const TimeSpan during{Seconds{depart_s}, Seconds{depart_s + 1500.0}};
    const bool forbidden = roomy.forbid(a, b, during);
    kept_off += forbidden && !exact.forbid(a, b, during) ? 1 : 0;
    if (forbidden) return;
    ++passed;
    const double length_m = geo::distance_m(a, b);
    for (int i = 0; i < 8; ++i) {
      const double aside = support::uniform(rng, -room.aside.value, room.aside.value) / length_m;
      const Seconds later{support::uniform(rng, -room.time.count(), room.time.count())};
      const auto beside = [&](geo::PlanePoint p) {
        return geo::PlanePoint{p.x_m - aside * (b.y_m - a.y_m), p.y_m + aside * (b.x_m - a.x_m)};
      };
      EXPECT_FALSE(exact.forbid(beside(a), beside(b), {during.from + later, during.until + later}));
    }
  });
  EXPECT_GT(passed, 300);
  EXPECT_GT(kept_off, 20);
}

TEST(TimedZones, WithRoomCloseAPointAlsoWhereAndWhenARuleIsNear) {
  constexpr Room room{core::Metres{40.0}, Seconds{300.0}};
  const TimedZones roomy{
      {zone(ZoneKind::no_go, square({0.0, 0.0}, 1000.0), 1000.0, 2000.0)}, projection, area, epoch, room};

  for (const geo::PlanePoint near : {geo::PlanePoint{0.0, 0.0}, {1020.0, 0.0}, {0.0, -1020.0}}) {
    const std::vector<TimeSpan> closed = roomy.closed_times(near);
    ASSERT_EQ(closed.size(), 1U);
    EXPECT_DOUBLE_EQ(closed.front().from.count(), 700.0);
    EXPECT_DOUBLE_EQ(closed.front().until.count(), 2300.0);
    EXPECT_TRUE(roomy.forbid(near, near, {Seconds{2200.0}, Seconds{2250.0}}));
    EXPECT_FALSE(roomy.forbid(near, near, {Seconds{2301.0}, Seconds{2400.0}}));
  }
  EXPECT_TRUE(roomy.closed_times({1060.0, 0.0}).empty());
}

TEST(TimedZones, FollowTheCubicOfThePieceAndNotItsChord) {
  // The vehicle stands almost still for most of the piece and has left the zone's square late.
  const TimedZones timed{
      {zone(ZoneKind::no_go, square({5000.0, 0.0}, 500.0), 0.0, 4000.0)}, projection, area, epoch};
  const motion::PlaneEdge edge{{0.0, 0.0}, {10'000.0, 0.0}, core::Metres{10'000.0}};
  const motion::EdgePiece late{
      .t0_s = 0.0, .way0_m = 0.0, .v0_m_s = 0.0, .t1_s = 8000.0, .way1_m = 10'000.0, .v1_m_s = 3.0};

  EXPECT_FALSE(timed.forbid(edge, late)) << "at 4000 s it is 2000 m along";
  EXPECT_TRUE(timed.forbid(edge.from, edge.to, {Seconds{0.0}, Seconds{8000.0}}));
}

}  // namespace
}  // namespace floeplan::planning::obstacles::timed_zones_test
