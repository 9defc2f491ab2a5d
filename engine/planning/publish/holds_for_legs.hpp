#pragma once

#include <stop_token>

#include "engine/planning/cost/route.hpp"
#include "engine/planning/cost/sea.hpp"

namespace floeplan::planning::publish {

/// The route without legs that are too short to fly. Holds replace them if they last at least half the time
/// of these legs and delay the arrival by at most the other half. A search may gain some minutes by moving to
/// and fro against a current too strong to hold in; no pilot flies that. Fixed points stay.
[[nodiscard]] cost::Route with_holds_for_short_legs(const cost::Sea& sea, cost::Route route,
                                                    const std::stop_token& stop);

}  // namespace floeplan::planning::publish
