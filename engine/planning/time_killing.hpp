#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/planning/route_cost.hpp"
#include "engine/planning/sea.hpp"

namespace floeplan::planning {

/// A part of a route that is longer than it need be, only because something further on opens later: the vehicle could
/// as well stay at its beginning and then go straight to its end.
struct TimeKilled {
  std::size_t from{};  // points of the route
  std::size_t to{};
  core::Seconds time{};  // that it could have stayed
};

/// The part that kills most time, where that is ten minutes at least; empty without one, and where nothing opens later.
/// A way round something that stays closed is no such part, nor is one at whose beginning the vehicle cannot stay.
[[nodiscard]] std::optional<TimeKilled> longest_killing_of_time(const Sea& sea,
                                                                const std::vector<geo::PlanePoint>& route,
                                                                const Schedule& schedule);

/// What it means, for a pilot.
[[nodiscard]] std::string describe(const TimeKilled& killed);

}  // namespace floeplan::planning
