#include "engine/avoidance/goal_point.hpp"

#include <algorithm>
#include <cmath>

#include "engine/avoidance/steering.hpp"

namespace floeplan::avoidance {
namespace {

constexpr double step_m = 20.0;
constexpr double detour = 1.2;     // length of the evasive way per straight distance, to estimate the arrival
constexpr double behind_m = 20.0;  // additional clearance of the rendezvous

/// Whether some obstacle covers a place on the ground at the time when the vehicle may be there.
bool is_covered(geo::PlanePoint place, const Going& going, const WaterFrame& water,
                std::span<const Obstacle> obstacles, double clearance_m) {
  const double arrival_s =
      going.time_s + detour * distance_m(place, going.place) / std::max(going.through_water_m_s, 0.1);
  const geo::PlanePoint now = water.from_local(place);
  return std::ranges::any_of(obstacles, [&](const Obstacle& obstacle) {
    const motion::MovingDisc disc = disc_of(obstacle, going.time_s, arrival_s, clearance_m);
    const double since_s = arrival_s - going.time_s;
    const geo::PlanePoint centre{
        disc.centre0.x_m + since_s * (disc.velocity.x_m_s + going.current.east.value),
        disc.centre0.y_m + since_s * (disc.velocity.y_m_s + going.current.north.value)};
    return distance_m(centre, now) <= disc.radius0_m + since_s * disc.growth_m_s;
  });
}

}  // namespace

std::optional<RoutePlace> rendezvous(const MissionRoute& route, const Going& going, const WaterFrame& water,
                                     std::span<const Obstacle> obstacles, const AvoidanceSettings& settings,
                                     double least_along_m) {
  std::optional<RoutePlace> found;
  double along_m = 0.0;
  for (; along_m <= farthest_rendezvous_m; along_m += step_m) {
    const auto place = route.place_along(going.place, along_m);
    if (!place) return std::nullopt;
    const bool covered =
        is_covered(place->place, going, water, obstacles, settings.clearance.value + behind_m);
    if (covered) {
      found.reset();
    } else if (!found && place->along_m >= least_along_m) {
      found = place;
    }
    if (place->along_m < along_m) break;  // end of the route
  }
  // Near the end of the route any clear place is accepted, first of all the last waypoint.
  if (!found) {
    const auto last = route.place_along(going.place, along_m);
    if (last && distance_m(last->place, going.place) <= farthest_rendezvous_m &&
        !is_covered(last->place, going, water, obstacles, settings.clearance.value)) {
      return last;
    }
  }
  return found;
}

}  // namespace floeplan::avoidance
