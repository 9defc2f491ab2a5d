#pragma once

#include <optional>
#include <vector>

#include "engine/planning/cost/schedule.hpp"
#include "engine/planning/cost/sea.hpp"

namespace floeplan::planning::cost {

/// The earliest schedule for a route of straight legs with holds at its points. The vehicle holds at the
/// point before a leg that is closed until later or, if the current there is too strong for a hold, at an
/// earlier point.
/// Accuracy  of holds as of `next_open_leg`
/// Returns   empty if there is none, or if it needs a longer hold than the request allows
/// Precondition  the time without surfacing is not limited
[[nodiscard]] std::optional<Schedule> held_schedule(const Sea& sea, const std::vector<geo::PlanePoint>& route,
                                                    core::Seconds depart);

/// Moves the holds of `schedule` to the start as far as the arrival does not become later. A later departure
/// costs nothing, and the start is the safest place to hold.
/// Precondition  as `held_schedule`
[[nodiscard]] Schedule departing_later(const Sea& sea, const std::vector<geo::PlanePoint>& route,
                                       Schedule schedule);

/// The longest hold of a schedule. A hold lasts from the arrival at a point until the vehicle leaves the
/// circle of this radius around the point, so holds at several nearby points count as one.
[[nodiscard]] core::Seconds longest_hold(const Schedule& schedule, const std::vector<geo::PlanePoint>& route,
                                         core::Metres radius);

}  // namespace floeplan::planning::cost
