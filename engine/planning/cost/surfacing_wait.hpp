#pragma once

#include <optional>

#include "engine/planning/cost/sea.hpp"

namespace floeplan::planning::cost {

/// How long ago the vehicle might have surfaced, at the end of a wait at one place; empty where that becomes longer
/// than the request allows meanwhile. Zero where nothing is known of ice, or no bound is asked for.
/// `since_surfacing`: at the beginning of the wait
/// Accuracy  the ice is looked at every quarter of an hour, and at the end
[[nodiscard]] std::optional<core::Seconds> since_surfacing_after_wait(const Sea& sea, geo::PlanePoint place,
                                                                      core::Seconds from, core::Seconds until,
                                                                      core::Seconds since_surfacing);

}  // namespace floeplan::planning::cost
