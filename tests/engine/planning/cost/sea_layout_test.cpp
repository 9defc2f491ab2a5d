#include "engine/planning/cost/sea_layout.hpp"

#include <gtest/gtest.h>

#include "engine/planning/problem/isochrone_request.hpp"
#include "tests/engine/planning/drifting_bergs.hpp"
#include "tests/support/property.hpp"

namespace floeplan::planning::cost::sea_layout_test {
namespace {

constexpr core::Seconds hour{hour_s};
constexpr core::Seconds day = 24.0 * hour;

/// A route of three hours. The drift of icebergs is then followed for two days.
PlanRequest short_request() {
  PlanRequest request = support::eastward_request();
  request.to = {-53.4, 69.0};
  return request;
}

/// The distance of the berg from its place at the start.
core::Metres drifted(const PlanRequest& request, const ocean::Environment& environment, core::Seconds time) {
  const geo::LocalProjection projection{request.from};
  const ocean::Iceberg& berg = environment.icebergs.front();
  const obstacles::IcebergDiscs discs = lay_out_icebergs(environment, request, projection, {}, nullptr, {});
  return discs.nearest(projection.to_plane(berg.place), time).value().from_hull +
         core::Metres{0.5 * berg.length->value};
}

ocean::Environment random_berg(std::mt19937_64& rng, double speed_m_s) {
  return {.icebergs = {drifting_berg({-53.0, 69.0}, 100.0, speed_m_s, support::uniform(rng, 0.0, 360.0))}};
}

/// The berg of the request drifts all the time from its departure on.
void expect_drift_for(const PlanRequest& request, core::Seconds time) {
  support::for_each_seed(3, [&](std::mt19937_64& rng) {
    const double speed_m_s = support::uniform(rng, 0.02, 0.1);
    const ocean::Environment environment = random_berg(rng, speed_m_s);
    EXPECT_NEAR(drifted(request, environment, time).value, speed_m_s * time.count(),
                0.01 * speed_m_s * time.count());
  });
}

TEST(IcebergsOfASea, DriftForTheWayOfTheLastDeparture) {
  PlanRequest request = short_request();
  expect_drift_for(request, 2.0 * day);

  request.departures.until = request.depart + 6.0 * day;

  expect_drift_for(request, 8.0 * day);
}

TEST(IcebergsOfASea, DriftForTheWayOfTheLastDepartureEvenAfterTheLongestDriftFromTheFirst) {
  PlanRequest request = short_request();
  request.departures.until = request.depart + 35.0 * day;

  expect_drift_for(request, 37.0 * day);
}

TEST(IcebergsOfASea, DriftUntilAWantedArrival) {
  PlanRequest request = short_request();
  request.departures.arrive_by = request.depart + 6.0 * day;

  expect_drift_for(request, 6.0 * day);
}

TEST(IcebergsOfASea, DriftWhileTheVehicleMayWait) {
  PlanRequest request = short_request();
  request.holds.longest = 5.0 * day;

  expect_drift_for(request, 12.0 * day);
}

TEST(IcebergsOfASea, DriftAsLongAsAVehicleGoesThatReachesOut) {
  IsochroneRequest reach;
  reach.place = {-53.5, 69.0};
  reach.vehicle = *vehicle::find_profile("slocum-g3-200");
  reach.spans = {day, 5.0 * day};
  for (const auto direction : {IsochroneRequest::Direction::from, IsochroneRequest::Direction::to}) {
    reach.direction = direction;
    reach.time = direction == IsochroneRequest::Direction::from ? start : start + 5.0 * day;

    expect_drift_for(voyage_of(reach), 5.0 * day);
  }
}

}  // namespace
}  // namespace floeplan::planning::cost::sea_layout_test
