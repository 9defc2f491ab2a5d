#pragma once

#include <cstddef>
#include <string>

#include "engine/mission/writing/mission_file.hpp"
#include "engine/planning/problem/plan.hpp"

namespace floeplan::mission {

inline constexpr std::size_t most_nmea_waypoints = 999;  // names have at most three digits

/// The plan as NMEA 0183 sentences for chart plotters: a WPL sentence for each waypoint, start included, and
/// RTE sentences with their order. The start is called S, the others by their number, as on the map.
/// Sentences have at most 82 characters, CR and LF included.
/// Frame    degrees and minutes with four decimals (0.19 m), hemisphere letters, WGS84
/// Source   NMEA 0183 version 4, sentences WPL and RTE, check sum by exclusive or
/// Errors   std::invalid_argument for more than 999 waypoints: names have three digits
[[nodiscard]] MissionFile write_nmea_route(const planning::Plan& plan, const std::string& plan_id);

}  // namespace floeplan::mission
