#pragma once

#include <string>

#include "engine/planning/problem/plan.hpp"

namespace floeplan::codec {

/// The plan as a GPX 1.1 route for chart plotters: every waypoint, the start included, with its time of
/// arrival. UTF-8; control characters of the name are dropped, since XML has no way to write them.
/// Frame    WGS84 degrees, seven decimals (1 cm), longitudes in [-180, 180)
/// Source   Topografix, GPX 1.1 schema
[[nodiscard]] std::string plan_gpx(const planning::Plan& plan, const std::string& plan_id,
                                   const std::string& name);

}  // namespace floeplan::codec
