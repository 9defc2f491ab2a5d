#include "engine/planning/search/waiting/waiting_way.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/planning/cost/loiter.hpp"
#include "engine/planning/plan_route.hpp"
#include "tests/engine/planning/drifting_bergs.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::search::waiting_way_test {
namespace {

constexpr core::Seconds two_days{48.0 * hour_s};

/// A tide that turns round once in twelve hours; icebergs drift about, and the goal lies in an area that is closed
/// for longer than the way takes.
Scene tidal_scene(std::mt19937_64& rng) {
  using support::uniform;
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

/// Whether the vehicle can keep its place at the start for so long.
bool start_stays_clear(const Scene& scene, core::Seconds time) {
  const geo::LocalProjection projection{scene.request.from};
  const plane::PlaneBox area{{-5000.0, -5000.0}, {5000.0, 5000.0}};
  const cost::Sea sea{scene.environment, scene.request, projection, area, core::Metres{1500.0}};
  return cost::can_stay_until(sea, projection.to_plane(scene.request.from), core::Seconds{0.0}, time) >= time;
}

/// Who may wait can wait at the start.
TEST(WaitingWay, IsNoLaterThanAWayThatIsBegunLater) {
  int compared = 0;
  int waits = 0;
  support::for_each_seed(3, [&](std::mt19937_64& rng) {
    Scene scene = tidal_scene(rng);
    PlanRequest patient = scene.request;
    patient.max_loiter = 2.0 * two_days;
    const Result<Plan> waiting = plan_route(scene.environment, patient, {}, {});
    for (const double hours : {12.0, 36.0}) {
      const core::Seconds delay{hours * hour_s};
      if (!start_stays_clear(scene, delay)) break;
      PlanRequest later = scene.request;
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

/// Who may not wait turns in circles for hours before a gate, and is through it about when it opens.
TEST(WaitingWay, TurnsInCirclesWhereTheVehicleMayNotWait) {
  PlanRequest request = support::eastward_request();
  request.zones = {
      {.name = "gate",
       .kind = ocean::ZoneKind::no_go,
       .area = {.outer = {{-53.05, 67.6}, {-52.95, 67.6}, {-52.95, 70.4}, {-53.05, 70.4}}, .holes = {}},
       .from = std::nullopt,
       .until = start + core::Seconds{20.0 * hour_s}}};
  request.refine = false;

  const Result<Plan> result = plan_route({}, request, {}, {});

  ASSERT_TRUE(result) << result.error().explanation();
  // The straight way of 39.9 km takes 31.7 h; the gate is 17.9 km, 14.2 h, from the start.
  EXPECT_NEAR(result->travel_time().count() / hour_s, 31.7 + 20.0 - 14.2, 0.5);
}

}  // namespace
}  // namespace floeplan::planning::search::waiting_way_test
