#pragma once

#include <stop_token>

#include "engine/planning/cost/route.hpp"
#include "engine/planning/cost/sea.hpp"

namespace floeplan::planning::publish {

/// The route without legs too short to fly, where the vehicle can hold for at least half the time that it spent on them, and
/// arrives later by at most the other half. A vehicle may gain some minutes by moving to and fro against a current that is too strong to
/// hold in; no pilot flies that. Fixed points stay.
[[nodiscard]] cost::Route with_holds_for_short_legs(const cost::Sea& sea, cost::Route route,
                                                    const std::stop_token& stop);

}  // namespace floeplan::planning::publish
