#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "engine/planning/problem/window_plan.hpp"

namespace floeplan::codec {

/// The outcomes of a window of departures: one entry for each departure, in order.
[[nodiscard]] nlohmann::json departures_json(const std::vector<planning::DepartureOutcome>& outcomes);

}  // namespace floeplan::codec
