#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "engine/core/violation_list.hpp"
#include "engine/messages/fault.hpp"
#include "engine/messages/flight_fault_messages.hpp"
#include "engine/simulation/flight/flight.hpp"
#include "engine/simulation/flight/flight_path.hpp"

/// Checks of a flight before it begins.
namespace floeplan::simulation {
namespace {

/// Largest average speed of a glider over its whole route, as a multiple of its own speed. No current carries it faster.
constexpr double fastest_over_own = 2.0;

/// Whether the data end before the vehicle can reach its last waypoint, with the best possible currents and
/// the earliest end of all holds.
bool data_end_too_early(const FlightRequest& request) {
  Vector place = request.world.to_frame(request.start);
  double way_m = 0.0;
  for (const RouteStop& stop : flight_path(request.world, request.orders, request.start).stops) {
    if (stop.hold) continue;
    way_m += std::hypot(stop.place.east - place.east, stop.place.north - place.north);
    place = stop.place;
  }
  const core::Seconds least{way_m / (fastest_over_own * request.vehicle.speed_through_water.value)};
  return !request.world.covers(place, request.departure + least);
}

}  // namespace

core::Violations FlightSettings::violations() const {
  messages::Faults faults;
  faults.take(hull.violations());
  faults.take(navigation.violations());
  faults.within(first_fix.count(), 0.0, 3600.0, "/first_fix_s", "0", "3600 s");
  faults.within(longest.count(), 1.0, 366.0 * 86400.0, "/longest_s", "1 s", "366 days");
  faults.within(record_every.count(), 1.0, 86400.0, "/record_every_s", "1 s", "a day");
  faults.within(reach.value, 1.0, 1e5, "/reach_m", "1 m", "100 km");
  faults.within(hull_reach.value, 0.0, 100.0, "/hull_reach_m", "0", "100 m");
  faults.within(geo::strength(known_current).value, 0.0, 5.0, "/known_current_m_s", "0", "5 m/s");
  return faults.found();
}

core::Violations violations(const FlightRequest& request) {
  core::Violations found = request.vehicle.violations();
  std::ranges::move(request.settings.violations(), std::back_inserter(found));
  if (!std::isfinite(core::unix_seconds(request.departure)))
    found.push_back(messages::fault<"not-a-time">("/departure"));
  if (request.orders.lists.empty()) found.push_back(messages::flight_fault<"no-list-to-fly">("/files"));
  if (!geo::is_valid(request.start)) {
    found.push_back(messages::flight_fault<"wrong-start">("/start"));
    return found;
  }
  const World& world = request.world;
  const Vector start = world.to_frame(request.start);
  if (!world.covers(start, request.departure))
    found.push_back(messages::flight_fault<"start-outside-data">("/start"));
  if (const auto bed_m = world.bed_depth_m(start.east, start.north); bed_m && *bed_m <= 0.0)
    found.push_back(messages::flight_fault<"start-on-land">("/start"));
  if (world.ice_draft_m(start.east, start.north, request.departure) > 0.0)
    found.push_back(messages::flight_fault<"launch-under-ice">("/start"));
  for (std::size_t i = 0; i < request.orders.lists.size(); ++i) {
    const auto& waypoints = request.orders.lists[i].waypoints;
    for (std::size_t row = 0; row < waypoints.size() && !core::is_full(found); ++row) {
      if (!world.covers(world.to_frame(waypoints[row]), request.departure)) {
        core::note(found, messages::flight_fault<"row-outside-data">("/files/list " + std::to_string(i + 1) +
                                                                     "/row " + std::to_string(row + 1)));
      }
    }
  }
  if (found.empty() && data_end_too_early(request)) {
    found.push_back(messages::flight_fault<"currents-end-in-flight">("/departure"));
  }
  return found;
}

}  // namespace floeplan::simulation
