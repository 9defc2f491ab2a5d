#pragma once

#include <optional>
#include <vector>

#include "engine/planning/cost/schedule.hpp"
#include "engine/planning/cost/sea.hpp"

namespace floeplan::planning::cost {

/// The earliest schedule for a route of straight legs for a vehicle that may hold at its points: in front of what is
/// closed for a while or, where the current does not let it, at an earlier point.
/// Accuracy  of waits as of `next_open_leg`
/// Returns   empty where there is none, or where it needs a hold that is longer than the request allows
/// Precondition  the sea does not bound the time without surfacing
[[nodiscard]] std::optional<Schedule> held_schedule(const Sea& sea, const std::vector<geo::PlanePoint>& route,
                                                    core::Seconds depart);

/// The schedule with its holds moved to the start as far as the vehicle is at the end no later: who departs later loses
/// nothing, and waits where it is safest.
/// Precondition  as `held_schedule`
[[nodiscard]] Schedule departing_later(const Sea& sea, const std::vector<geo::PlanePoint>& route,
                                       Schedule schedule);

/// The longest hold of a schedule. A hold lasts from the arrival at a point until the vehicle leaves the circle of
/// this radius about it, so that one that is spread over points near to each other is no shorter.
[[nodiscard]] core::Seconds longest_hold(const Schedule& schedule, const std::vector<geo::PlanePoint>& route,
                                         core::Metres radius);

}  // namespace floeplan::planning::cost
