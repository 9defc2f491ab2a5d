#pragma once

#include <optional>
#include <vector>

#include "engine/planning/cost/schedule.hpp"
#include "engine/planning/cost/sea.hpp"

namespace floeplan::planning::cost {

/// A schedule for a route on which a current turns against the vehicle where it can no longer keep its place: it waits
/// where it still can, at an earlier point of the route, until the rest is open when it comes there.
/// Accuracy  of waits as of `leg_when_open`; of the points before a closed leg those are tried that lie one, two, four
///           and so on before it, and the first, with as little delay as lets it through. Empty where none does
/// Precondition  the sea does not bound the time without surfacing
[[nodiscard]] std::optional<Schedule> delayed_schedule(const Sea& sea,
                                                       const std::vector<geo::PlanePoint>& route,
                                                       core::Seconds depart);

}  // namespace floeplan::planning::cost
