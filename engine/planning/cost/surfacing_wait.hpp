#pragma once

#include <optional>

#include "engine/planning/cost/sea.hpp"

namespace floeplan::planning::cost {

/// Time since the vehicle could last surface, at the end of a hold at one place. Empty if it exceeds the limit of the
/// request meanwhile. Zero if nothing is known of ice, or without a limit.
/// `since_surfacing`: at the beginning of the hold
/// Accuracy  the ice is checked every quarter of an hour, and at the end
[[nodiscard]] std::optional<core::Seconds> since_surfacing_after_wait(const Sea& sea, geo::PlanePoint place,
                                                                      core::Seconds from, core::Seconds until,
                                                                      core::Seconds since_surfacing);

}  // namespace floeplan::planning::cost
