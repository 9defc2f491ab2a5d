#include "engine/planning/search/holding/hold_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/planning/cost/held_schedule.hpp"
#include "engine/planning/cost/hold_times.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/plan_route.hpp"
#include "engine/planning/search/route_search.hpp"
#include "tests/engine/planning/drifting_bergs.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::search::hold_search_test {
namespace {

using support::uniform;

constexpr core::Seconds whenever{INFINITY};
constexpr core::Seconds at_departure{0.0};
constexpr core::Metres hold_radius = HoldRules{}.radius;
const geo::LocalProjection projection{{-53.0, 69.0}};

/// A few kilometres with drifting icebergs, a timed area, and a tide across a strait that is too strong for the
/// vehicle at its peak.
struct TidalScene {
  PlanRequest request{support::eastward_request()};
  ocean::Environment environment;
  cost::RouteGrid grid{cost::lay_grid({-4000.0, 0.0}, {4000.0, 0.0},
                                      {core::Metres{1000.0}, core::Metres{1000.0}},
                                      {.across = 0.4, .beyond = 0.1})};

  explicit TidalScene(std::mt19937_64& rng) {
    request.holds.longest = core::Seconds{100.0 * hour_s};
    request.icebergs.margin = core::Metres{300.0};
    request.icebergs.max_inflation = core::Metres{uniform(rng, 0.0, 600.0)};
    const double mean_m_s = uniform(rng, -0.1, 0.1);
    const double swing_m_s = uniform(rng, 0.3, 0.6);
    const double phase = uniform(rng, 0.0, 2.0 * std::numbers::pi);
    environment.currents = support::currents_from(
        [=](geo::LonLat place, double hour) {
          const double share = std::exp(-std::pow((place.lon_deg + 53.0) / 0.08, 2.0));
          const double tide = swing_m_s * share * std::cos(2.0 * std::numbers::pi * hour / 12.4 + phase);
          return geo::VelocityEn{{mean_m_s + tide}, {0.3 * tide}};
        },
        48);
    for (int i = support::uniform_int(rng, 1, 4); i > 0; --i) {
      const geo::PlanePoint place{uniform(rng, -3000.0, 5000.0), uniform(rng, -3000.0, 3000.0)};
      environment.icebergs.push_back(drifting_berg(projection.to_lon_lat(place), uniform(rng, 50.0, 800.0),
                                                   uniform(rng, 0.02, 0.2), uniform(rng, 0.0, 360.0)));
    }
    const double west = uniform(rng, -53.08, -52.98);
    const double east = west + 0.03;
    request.zones = {
        {.name = "area",
         .kind = ocean::ZoneKind::no_go,
         .area = {.outer = {{west, 68.5}, {east, 68.5}, {east, 69.5}, {west, 69.5}}, .holes = {}},
         .from = start + core::Seconds{uniform(rng, 0.0, 4.0) * hour_s},
         .until = start + core::Seconds{uniform(rng, 4.0, 16.0) * hour_s}}};
  }
  [[nodiscard]] cost::Sea sea() const {
    return {environment, request, projection, grid.bounds().grown(5000.0), core::Metres{500.0}};
  }
};

/// The earliest arrival if every departure of a ten-minute grid is tried at every vertex. Never earlier than the true
/// earliest arrival, perhaps later.
core::Seconds by_brute_force(const cost::Sea& sea, const OpenGrid& open) {
  constexpr core::Seconds step{600.0};
  constexpr std::size_t bins = 48 * 6;
  const std::vector<core::Seconds> never_there(open.graph.size(), whenever);
  std::vector<std::vector<core::Seconds>> earliest(bins, never_there);
  earliest[0][open.grid.start] = at_departure;
  for (std::size_t bin = 0; bin < bins; ++bin) {
    if (earliest[bin][open.grid.goal] < whenever) return earliest[bin][open.grid.goal];
    const auto reach = [&](graph::Vertex v, core::Seconds time) {
      const auto then = static_cast<std::size_t>(time / step);
      if (then < bins) earliest[then][v] = std::min(earliest[then][v], time);
    };
    for (graph::Vertex v = 0; v < open.graph.size(); ++v) {
      const core::Seconds now = earliest[bin][v];
      if (now == whenever) continue;
      open.graph.for_each_edge(v, [&](const graph::Edge& edge) {
        if (const auto time = sea.leg_time(open.grid.point(v), open.grid.point(edge.head), now))
          reach(edge.head, now + *time);
      });
      const core::Seconds next = static_cast<double>(bin + 1) * step;
      if (cost::can_stay_until(sea, open.grid.point(v), now, next) >= next) reach(v, next);
    }
  }
  return whenever;
}

/// Calls `law(scene, sea, open, expected, held)` for scenes, with the earliest arrival by brute force and the route
/// with holds. Scenes without a route only have to end the search.
template <class Law>
void for_each_scene_with_a_way(const Law& law) {
  int found = 0;
  support::for_each_seed(12, [&](std::mt19937_64& rng) {
    const TidalScene scene{rng};
    const cost::Sea sea = scene.sea();
    const OpenGrid open = open_grid(sea.domain(), scene.grid, 1, {});
    const core::Seconds expected = by_brute_force(sea, open);
    Foresight foresight{sea, open};
    const HeldWay held = search_held_way(sea, open, foresight, at_departure, whenever, {});
    EXPECT_FALSE(held.full || held.cancelled);
    if (expected == whenever) return;
    ++found;
    law(scene, sea, open, expected, held);
  });
  EXPECT_GT(found, 8);
}

TEST(HoldSearch, IsNeverLaterThanAnyWayThatBruteForceFinds) {
  int holds = 0;
  for_each_scene_with_a_way([&](const TidalScene&, const cost::Sea& sea, const OpenGrid&,
                                core::Seconds expected, const HeldWay& held) {
    ASSERT_FALSE(held.path.empty()) << expected.count() / hour_s;
    EXPECT_LE(held.arrival.count(), expected.count() + 60.0);
    const auto schedule = cost::schedule_along(sea, held.path, at_departure);
    ASSERT_TRUE(schedule);
    EXPECT_LE(schedule->arrivals.back().count(), held.arrival.count() + 1.0);
    holds += cost::longest_hold(*schedule, held.path, hold_radius).count() > 600.0 ? 1 : 0;
  });
  EXPECT_GT(holds, 3);
}

TEST(HoldSearch, IsNeededOnlyWhereTheRouteOfAVehicleThatHoldsAnywhereIsLater) {
  for_each_scene_with_a_way([](const TidalScene& scene, const cost::Sea& sea, const OpenGrid& open,
                               core::Seconds expected, const HeldWay& held) {
    const RouteSearch route =
        search_route(sea, open, scene.request, at_departure, {}, [](double) {}, whenever, at_departure);

    ASSERT_FALSE(route.path.empty()) << expected.count() / hour_s;
    EXPECT_LE(route.arrival.count(), expected.count() + 60.0);
    EXPECT_GE(route.arrival.count(), held.arrival.count() - 60.0);
    const auto schedule = cost::schedule_along(sea, route.path, at_departure);
    ASSERT_TRUE(schedule);
    EXPECT_NEAR(schedule->arrivals.back().count(), route.arrival.count(), 1.0);
  });
}

constexpr core::Seconds two_days{48.0 * hour_s};

/// A tide that turns round once in twelve hours, drifting icebergs, and a goal in an area that stays closed longer
/// than the route takes.
Scene gated_scene(std::mt19937_64& rng) {
  PlanRequest request = support::eastward_request();
  request.spacing_along = core::Metres{2500.0};
  request.refine = false;
  request.optimality_gap = false;
  request.icebergs.max_inflation = core::Metres{uniform(rng, 500.0, 3000.0)};
  const double until_h = uniform(rng, 45.0, 70.0);
  request.zones = {
      {.name = "trawlers",
       .kind = ocean::ZoneKind::no_go,
       .area = {.outer = {{-52.6, 68.9}, {-52.3, 68.9}, {-52.3, 69.1}, {-52.6, 69.1}}, .holes = {}},
       .from = std::nullopt,
       .until = start + core::Seconds{until_h * hour_s}}};
  const double speed_m_s = uniform(rng, 0.1, 0.3);
  ocean::Environment environment;
  environment.currents = support::currents_from(
      [=](geo::LonLat place, double hour) {
        const double phase = 2.0 * std::numbers::pi * (hour / 12.4 + place.lon_deg);
        return geo::VelocityEn{{speed_m_s * std::cos(phase)}, {speed_m_s * std::sin(phase)}};
      },
      240);
  for (int i = 0; i < 12; ++i) {
    const geo::LonLat place{uniform(rng, -53.4, -52.4), uniform(rng, 68.85, 69.15)};
    environment.icebergs.push_back(support::iceberg_at(place, 100.0));
  }
  return {request, environment};
}

/// Whether the vehicle can hold at the start for this long.
bool start_stays_clear(const Scene& scene, core::Seconds time) {
  const geo::LocalProjection there{scene.request.from};
  const plane::PlaneBox area{{-5000.0, -5000.0}, {5000.0, 5000.0}};
  const cost::Sea sea{scene.environment, scene.request, there, area, core::Metres{1500.0}};
  return cost::can_stay_until(sea, there.to_plane(scene.request.from), core::Seconds{0.0}, time) >= time;
}

/// A vehicle that may hold can hold at the start.
TEST(HoldSearch, IsNoLaterThanAWayThatIsBegunLater) {
  int compared = 0;
  int waits = 0;
  support::for_each_seed(3, [&](std::mt19937_64& rng) {
    Scene scene = gated_scene(rng);
    PlanRequest patient = scene.request;
    patient.holds.longest = 2.0 * two_days;
    const Result<Plan> waiting = plan_route(scene.environment, patient, {}, {});
    for (const double hours : {12.0, 36.0}) {
      const core::Seconds delay{hours * hour_s};
      if (!start_stays_clear(scene, delay)) break;
      PlanRequest later = scene.request;
      later.holds.longest = core::Seconds{0.0};
      later.depart += delay;
      const Result<Plan> moving = plan_route(scene.environment, later, {}, {});
      if (!moving) continue;
      ++compared;
      ASSERT_TRUE(waiting) << waiting.error().explanation();
      EXPECT_LE(waiting->travel_time().count(), 1.01 * (moving->arrival - start).count()) << hours;
    }
    if (!waiting) return;
    const bool is_wait = std::ranges::any_of(
        waiting->waypoints, [](const Waypoint& waypoint) { return waypoint.wait.count() > hour_s; });
    waits += is_wait ? 1 : 0;
  });
  EXPECT_GT(compared, 2);
  EXPECT_GT(waits, 1);
}

/// A goal that a disc covers for hours after the vehicle could be there.
class HoldBeforeAGoal : public testing::Test {
 protected:
  HoldBeforeAGoal() {
    environment_.icebergs = {drifting_berg(projection.to_lon_lat({12'000.0, 0.0}), 1000.0, 0.02, 0.0)};
    request_.holds.longest = core::Seconds{48.0 * hour_s};
    request_.icebergs.max_inflation = core::Metres{1000.0};
  }
  [[nodiscard]] HeldWay search() const {
    const cost::Sea sea = this->sea();
    const OpenGrid open = open_grid(sea.domain(), grid_, request_.sectors, {});
    Foresight foresight{sea, open};
    return search_held_way(sea, open, foresight, at_departure, whenever, {});
  }
  [[nodiscard]] cost::Sea sea() const {
    return {environment_, request_, projection, grid_.bounds().grown(2000.0), core::Metres{500.0}};
  }

  PlanRequest request_{support::eastward_request()};
  ocean::Environment environment_;
  cost::RouteGrid grid_{cost::lay_grid({-12'000.0, 0.0}, {12'000.0, 0.0},
                                       {core::Metres{1000.0}, core::Metres{1000.0}}, {0.5, 0.5})};
};

TEST_F(HoldBeforeAGoal, EndsWhenItOpens) {
  const std::vector<TimeSpan> closed = sea().domain().closures().closed_times(grid_.point(grid_.goal));
  ASSERT_EQ(closed.size(), 1U);

  const HeldWay held = search();

  ASSERT_FALSE(held.path.empty());
  EXPECT_GE(held.arrival, closed[0].until);
  EXPECT_NEAR(held.arrival.count(), closed[0].until.count(), 120.0);
}

TEST_F(HoldBeforeAGoal, IsBegunAtTheStartWhereThatLosesNothing) {
  const cost::Sea sea = this->sea();
  const std::vector<geo::PlanePoint> route{
      grid_.point(grid_.start), {-6000.0, 500.0}, grid_.point(grid_.goal)};
  const auto schedule = cost::schedule_along(sea, route, at_departure);
  ASSERT_TRUE(schedule);
  ASSERT_GT(schedule->waits[1].count(), 3600.0) << "the first leg is open at once";

  const cost::Schedule later = cost::departing_later(sea, route, *schedule);

  EXPECT_EQ(later.arrivals.front(), at_departure);
  EXPECT_GT(later.waits[0].count(), schedule->waits[1].count() - 600.0);
  EXPECT_LT(later.waits[1].count(), 600.0);
  EXPECT_NEAR(later.arrivals.back().count(), schedule->arrivals.back().count(), 60.0);
}

TEST_F(HoldBeforeAGoal, IsNotSpreadOverPlacesWhereItIsLongerThanAllowed) {
  const HeldWay held = search();
  ASSERT_FALSE(held.path.empty());
  const auto schedule = cost::schedule_along(sea(), held.path, at_departure);
  ASSERT_TRUE(schedule);
  const core::Seconds needed = cost::longest_hold(*schedule, held.path, hold_radius);

  request_.holds.longest = needed - core::Seconds{600.0};
  EXPECT_TRUE(search().path.empty());

  request_.holds.longest = needed + core::Seconds{1.0};
  EXPECT_FALSE(search().path.empty());
}

TEST_F(HoldBeforeAGoal, IsFoundWithoutALookAtEveryPlace) {
  const cost::Sea sea = this->sea();
  const OpenGrid open = open_grid(sea.domain(), grid_, request_.sectors, {});

  Foresight foresight{sea, open};
  const HeldWay held = search_held_way(sea, open, foresight, at_departure, whenever, {});

  EXPECT_LT(held.counters.expansions, open.vertices / 2);
}

TEST(LongestHold, CountsPlacesNearToEachOtherAsOne) {
  const std::vector<geo::PlanePoint> route{{0.0, 0.0}, {300.0, 0.0}, {2000.0, 0.0}, {4000.0, 0.0}};
  const auto seconds = [](std::initializer_list<double> values) {
    std::vector<core::Seconds> result;
    for (const double value : values) result.emplace_back(value);
    return result;
  };
  const cost::Schedule schedule{seconds({0.0, 4600.0, 13'000.0, 23'000.0}),
                                seconds({3600.0, 3600.0, 5000.0, 0.0})};

  EXPECT_EQ(cost::longest_hold(schedule, route, hold_radius).count(), 4600.0 + 3600.0);
}

TEST(SafeIntervals, LetTheVehicleStayWhereTheCurrentIsWeakAndPassWhereItIsStrong) {
  // The current is slack for five hours, then 0.5 m/s; the vehicle makes 0.35 m/s.
  const ocean::Environment environment{
      .currents = support::currents_from(
          [](geo::LonLat, double hour) { return geo::VelocityEn{{hour <= 5.0 ? 0.1 : 0.5}, {0.0}}; }, 48)};
  PlanRequest request = support::eastward_request();
  const geo::Ring around{{-53.1, 68.9}, {-52.9, 68.9}, {-52.9, 69.1}, {-53.1, 69.1}};
  request.zones = {{.name = "area",
                    .kind = ocean::ZoneKind::no_go,
                    .area = {.outer = around, .holes = {}},
                    .from = start + core::Seconds{2.0 * hour_s},
                    .until = start + core::Seconds{3.0 * hour_s}}};
  const plane::PlaneBox area{{-20'000.0, -10'000.0}, {20'000.0, 10'000.0}};
  const cost::Sea sea{environment, request, projection, area, core::Metres{500.0}};

  const TimeSpan within{core::Seconds{hour_s}, core::Seconds{20.0 * hour_s}};

  const auto safe = cost::safe_intervals(sea, {0.0, 0.0}, within);

  ASSERT_EQ(safe.size(), 3U);
  EXPECT_TRUE(safe[0].may_stay);
  EXPECT_EQ(safe[0].from_s, hour_s);
  EXPECT_NEAR(safe[0].until_s, 2.0 * hour_s, 120.0);
  EXPECT_TRUE(safe[1].may_stay);
  EXPECT_NEAR(safe[1].from_s, 3.0 * hour_s, 120.0);
  // Between the hours the current grows linearly: it reaches 0.8 x 0.35 m/s at 5.45 h.
  EXPECT_NEAR(safe[1].until_s, 5.45 * hour_s, 2.0);
  EXPECT_FALSE(safe[2].may_stay);
  EXPECT_EQ(safe[2].from_s, safe[1].until_s);
  EXPECT_EQ(safe[2].until_s, 20.0 * hour_s);
}

}  // namespace
}  // namespace floeplan::planning::search::hold_search_test
