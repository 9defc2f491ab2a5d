#pragma once

#include <optional>
#include <tl/expected.hpp>
#include <vector>

#include "engine/motion/edge_closed.hpp"
#include "engine/planning/cost/schedule.hpp"
#include "engine/planning/cost/sea.hpp"

namespace floeplan::planning::cost {

/// The earliest schedule for a route of straight legs. Every plan is published with this cost, whatever search found
/// it. Where the request allows holds the vehicle holds before a closure that ends, no longer than needed.
[[nodiscard]] tl::expected<Schedule, RouteClosed> schedule_along(
    const Sea& sea, const std::vector<geo::PlanePoint>& route, core::Seconds depart,
    core::Seconds since_surfacing = core::Seconds{0.0});

/// The arrivals of that schedule.
[[nodiscard]] tl::expected<std::vector<core::Seconds>, RouteClosed> arrivals_along(
    const Sea& sea, const std::vector<geo::PlanePoint>& route, core::Seconds depart,
    core::Seconds since_surfacing = core::Seconds{0.0});

/// Lower bound of the arrival at the last stop: straight legs with the strongest current astern, all of them open on
/// arrival.
[[nodiscard]] core::Seconds earliest_arrival(const Sea& sea, const std::vector<geo::PlanePoint>& stops);

/// Time since the vehicle could last surface, at the end of the route. Empty if it arrives after `latest`, or if that
/// time exceeds the limit of the request on the way.
[[nodiscard]] std::optional<core::Seconds> since_surfacing_at_end(const Sea& sea,
                                                                  const std::vector<geo::PlanePoint>& route,
                                                                  core::Seconds depart,
                                                                  core::Seconds since_surfacing,
                                                                  core::Seconds latest);

}  // namespace floeplan::planning::cost
