#pragma once

#include <optional>
#include <tl/expected.hpp>
#include <vector>

#include "engine/motion/edge_closed.hpp"
#include "engine/planning/cost/schedule.hpp"
#include "engine/planning/cost/sea.hpp"

namespace floeplan::planning::cost {

/// The earliest schedule for a route of straight legs. Every plan is published with this cost, whichever
/// search found it. If the request allows holds, the vehicle holds until a closure ends, no longer than
/// needed.
/// `depart` counts from the departure of the request. `since_surfacing`: time from the last possible
/// surfacing until `depart`.
[[nodiscard]] tl::expected<Schedule, RouteClosed> schedule_along(
    const Sea& sea, const std::vector<geo::PlanePoint>& route, core::Seconds depart,
    core::Seconds since_surfacing = core::Seconds{0.0});

/// The arrivals of `schedule_along` at each point.
[[nodiscard]] tl::expected<std::vector<core::Seconds>, RouteClosed> arrivals_along(
    const Sea& sea, const std::vector<geo::PlanePoint>& route, core::Seconds depart,
    core::Seconds since_surfacing = core::Seconds{0.0});

/// Lower bound of the arrival at the last stop: straight legs with the strongest current from astern, all of
/// them open on arrival.
[[nodiscard]] core::Seconds earliest_arrival(const Sea& sea, const std::vector<geo::PlanePoint>& stops);

/// Time since the last possible surfacing, at the end of the route. Empty if the route arrives after
/// `latest`, or if the time without surfacing exceeds the request's limit on the way.
[[nodiscard]] std::optional<core::Seconds> since_surfacing_at_end(const Sea& sea,
                                                                  const std::vector<geo::PlanePoint>& route,
                                                                  core::Seconds depart,
                                                                  core::Seconds since_surfacing,
                                                                  core::Seconds latest);

}  // namespace floeplan::planning::cost
