#pragma once

#include <cstddef>
#include <string>

#include "engine/mission/writing/mission_file.hpp"
#include "engine/planning/problem/plan.hpp"

namespace floeplan::mission {

inline constexpr std::size_t most_nmea_waypoints = 999;  // names have at most three digits

/// The plan as NMEA 0183 sentences for chart plotters: a WPL for each waypoint, the start included, and RTE
/// sentences that put them in order. The start is called S and the others by their row, as on the map. No sentence is longer than 82 characters, CR and LF included.
/// Frame    degrees and minutes with four decimals (0.19 m), hemisphere letters, WGS84
/// Source   NMEA 0183 version 4, sentences WPL and RTE, check sum by exclusive or
/// Errors   std::invalid_argument for more than 999 waypoints, which the names have no room for
[[nodiscard]] MissionFile write_nmea_route(const planning::Plan& plan, const std::string& plan_id);

}  // namespace floeplan::mission
