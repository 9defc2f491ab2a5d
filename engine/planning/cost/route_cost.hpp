#pragma once

#include <optional>
#include <tl/expected.hpp>
#include <vector>

#include "engine/motion/edge_closed.hpp"
#include "engine/planning/cost/schedule.hpp"
#include "engine/planning/cost/sea.hpp"

namespace floeplan::planning::cost {

/// The earliest schedule for a route of straight legs. The one cost that every plan is published with, whatever found
/// it. Where the request allows waits the vehicle waits where that brings it through, no longer than it must.
[[nodiscard]] tl::expected<Schedule, RouteClosed> schedule_along(
    const Sea& sea, const std::vector<geo::PlanePoint>& route, core::Seconds depart,
    core::Seconds since_surfacing = core::Seconds{0.0});

/// Its arrivals alone.
[[nodiscard]] tl::expected<std::vector<core::Seconds>, RouteClosed> arrivals_along(
    const Sea& sea, const std::vector<geo::PlanePoint>& route, core::Seconds depart,
    core::Seconds since_surfacing = core::Seconds{0.0});

/// Before it nobody is at the last of the stops, each open when the vehicle is there: as if it went straight with the
/// strongest current astern.
[[nodiscard]] core::Seconds earliest_arrival(const Sea& sea, const std::vector<geo::PlanePoint>& stops);

/// How long ago the vehicle might have surfaced when it comes to the end of the route no later than at `latest`; empty
/// where it does not, or is longer without a surfacing than the request allows on the way.
[[nodiscard]] std::optional<core::Seconds> since_surfacing_at_end(const Sea& sea,
                                                                  const std::vector<geo::PlanePoint>& route,
                                                                  core::Seconds depart,
                                                                  core::Seconds since_surfacing,
                                                                  core::Seconds latest);

}  // namespace floeplan::planning::cost
