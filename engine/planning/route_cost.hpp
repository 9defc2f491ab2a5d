#pragma once

#include <tl/expected.hpp>
#include <vector>

#include "engine/motion/edge_closed.hpp"
#include "engine/planning/sea.hpp"

namespace floeplan::planning {

/// Where and when a route stops being passable.
struct RouteClosed {
  motion::EdgeClosed reason{};
  geo::PlanePoint at;
  core::Seconds when{};
  bool out_of_time{false};  // the data reach on from here, but not long enough
};

/// Arrival at every point of a route of straight legs, the departure first. The one cost that every plan is
/// published with, whatever found it.
[[nodiscard]] tl::expected<std::vector<core::Seconds>, RouteClosed> arrivals_along(
    const Sea& sea, const std::vector<geo::PlanePoint>& route, core::Seconds depart,
    core::Seconds since_surfacing = core::Seconds{0.0});

}  // namespace floeplan::planning
