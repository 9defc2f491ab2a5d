#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/geo/geodesic.hpp"
#include "engine/planning/problem/plan.hpp"
#include "tests/support/property.hpp"

namespace floeplan::support {

/// A plan through the places, one hour a leg.
inline planning::Plan plan_of(const std::vector<geo::LonLat>& places) {
  planning::Plan plan;
  plan.vehicle = "slocum-g3-200";
  plan.departure = core::UtcTime{core::Seconds{1.8e9}};
  plan.arrival = plan.departure;
  for (const geo::LonLat place : places) {
    planning::Waypoint waypoint;
    waypoint.place = place;
    if (!plan.waypoints.empty()) {
      plan.arrival += core::Seconds{3600.0};
      waypoint.leg_length = geo::geodesic_between(plan.waypoints.back().place, place).length;
    }
    waypoint.eta = plan.arrival;
    plan.waypoints.push_back(waypoint);
  }
  return plan;
}

/// Any place that the format allows; often at a whole degree, the equator, Greenwich or the antimeridian.
inline geo::LonLat random_place(std::mt19937_64& rng) {
  geo::LonLat place{uniform(rng, -180.0, 360.0), uniform(rng, -89.0, 89.0)};
  if (uniform_int(rng, 0, 2) == 0) place.lon_deg = 180.0 * uniform_int(rng, -1, 2);
  if (uniform_int(rng, 0, 2) == 0) place.lon_deg += uniform(rng, -1e-6, 0.0);
  if (uniform_int(rng, 0, 2) == 0) place.lat_deg = std::round(place.lat_deg) + uniform(rng, -1e-7, 0.0);
  place.lon_deg = std::max(place.lon_deg, -180.0);
  place.lat_deg = std::max(place.lat_deg, -89.0);
  return place;
}

inline std::vector<geo::LonLat> random_places(std::mt19937_64& rng, int least, int most) {
  std::vector<geo::LonLat> places(static_cast<std::size_t>(uniform_int(rng, least, most)));
  std::generate(places.begin(), places.end(), [&] { return random_place(rng); });
  return places;
}

}  // namespace floeplan::support
