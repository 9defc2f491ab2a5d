#pragma once

#include <optional>
#include <vector>

#include "engine/mission/checking/flight_route.hpp"
#include "engine/mission/checking/route_check.hpp"
#include "engine/mission/document/document.hpp"
#include "engine/planning/problem/plan.hpp"

namespace floeplan::mission {

/// A route without closures, timed, with what ice and icebergs demand on it.
struct TimedRoute {
  const planning::Plan& plan;
  std::vector<std::optional<FlightRoute::Stop>>
      rows;  // the row of each waypoint of the plan; empty for the start
};

/// Checks files that are flown together: whether they are safe below ice and icebergs. Adds messages to the
/// files.
/// Yo          error if it climbs higher than the ice or iceberg above some leg allows
/// Lists       errors if they end below ice or icebergs, or within the waypoint radius of them, because the
///             vehicle surfaces there; a list that repeats without end has no end. A warning if the position
///             error may bring the vehicle up below ice, and if the ice is unknown
/// Surfacings  errors for surfacings at waypoints below ice or equally near to it; for surfacings after a
///             time if the route passes below ice; for surfacings for lack of contact if the time below ice
///             is as long. A warning for surfacings that may come at any time. If a mission is among the files,
///             only the surfacings that it orders count
/// Targets     error if the route of a Seaglider, which surfaces after every dive, passes below ice or
///             icebergs
/// Returns     whether there is no error
[[nodiscard]] bool check_below_ice(std::vector<Document>& documents, const TimedRoute& route,
                                   const std::optional<DiveArguments>& dive);

}  // namespace floeplan::mission
