#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>

#include "engine/avoidance/mission_route.hpp"
#include "engine/avoidance/obstacles.hpp"
#include "engine/avoidance/settings.hpp"
#include "engine/avoidance/timed_way.hpp"
#include "engine/avoidance/water_frame.hpp"

namespace floeplan::avoidance {

/// What a path search came to.
struct EvasivePath {
  TimedWay way{};  // empty: none found
  std::int64_t expansions{};
  bool out_of_budget{};  // the search was ended: a path may exist that was not found
};

/// The fastest way from the vehicle to a place on the ground past the detected objects in the measured current: the
/// search of the mission planner on a small grid laid along the line between both, with moving discs closing edges at
/// the times at which they are travelled; then straightened where that costs no time.
/// Budget   `most_expansions` of the settings (1024 at least, which is how often the search looks), and `stop` for a
///          limit in time that the vehicle's computer keeps
/// Memory   grows with the grid, at most 8192 vertices. Allocates: not for the reactive loop
/// Source   Eichhorn 2009, section III (search and edge cost); moving obstacles as in engine/motion/disc_encounter.hpp
[[nodiscard]] EvasivePath plan_evasion(const Going& going, geo::PlanePoint goal, const WaterFrame& water,
                                       std::span<const Obstacle> obstacles, const AvoidanceSettings& settings,
                                       const std::stop_token& stop);

}  // namespace floeplan::avoidance
