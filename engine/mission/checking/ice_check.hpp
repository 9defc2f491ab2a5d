#pragma once

#include <optional>
#include <vector>

#include "engine/mission/checking/flight_route.hpp"
#include "engine/mission/checking/route_check.hpp"
#include "engine/mission/document/document.hpp"
#include "engine/planning/problem/plan.hpp"

namespace floeplan::mission {

/// A route that nothing closes, with what ice and icebergs ask for on it.
struct TimedRoute {
  const planning::Plan& plan;
  std::vector<std::optional<FlightRoute::Stop>>
      rows;  // for each waypoint of the plan; none where the vehicle starts
};

/// Judges what files that fly together make the vehicle do below ice and icebergs, and adds to their messages.
/// Yo          error where it climbs higher than what is above a leg lets it turn
/// Lists       errors where they end below ice or icebergs, or within their radius of them, for the vehicle comes up
///             there; a list that goes round for ever does not end. A warning where its error of position may bring it
///             up below ice, and where nothing is known of the ice
/// Surfacings  errors for those at waypoints below ice or as near to it, for those after a time where the way passes
///             below ice, and for want of contact where that lasts so long below ice. A warning for those that may come
///             at any time. With a mission among the files only those that it asks for
/// Targets     error where the way of a Seaglider, which comes up after every dive, passes below ice or icebergs
/// Returns     whether there is no error
[[nodiscard]] bool check_below_ice(std::vector<Document>& documents, const TimedRoute& route,
                                   const std::optional<DiveArguments>& dive);

}  // namespace floeplan::mission
