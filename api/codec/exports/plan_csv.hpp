#pragma once

#include <string>

#include "engine/planning/problem/plan.hpp"

namespace floeplan::codec {

/// The plan's waypoints as a table for spreadsheets (RFC 4180 without quoting, LF): a header whose names
/// carry the units, then one row a waypoint, the start first. What is not known is an empty cell.
[[nodiscard]] std::string plan_csv(const planning::Plan& plan);

}  // namespace floeplan::codec
