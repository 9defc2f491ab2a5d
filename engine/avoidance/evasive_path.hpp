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

/// Result of a path search.
struct EvasivePath {
  TimedWay way{};  // empty: no path found
  std::int64_t expansions{};
  bool out_of_budget{};  // the search was ended early: a path may exist
};

/// The fastest way from the vehicle to a place on the ground, past the detected objects, in the measured
/// current. It uses the mission planner's search on a small grid along the line between both. Moving discs
/// close an edge while the vehicle would travel it. Afterwards bends are left out, as long as the vehicle
/// arrives no later.
/// Budget   `most_expansions` of the settings (at least 1024, the interval of the search's checks), and
///          `stop`, with which the vehicle's computer can limit the time
/// Memory   grows with the grid, at most 8192 vertices. Allocates, so it is not for the reactive loop
/// Source   Eichhorn 2009, section III (search and edge cost); moving obstacles as in
///          engine/motion/disc_encounter.hpp
[[nodiscard]] EvasivePath plan_evasion(const Going& going, geo::PlanePoint goal, const WaterFrame& water,
                                       std::span<const Obstacle> obstacles, const AvoidanceSettings& settings,
                                       const std::stop_token& stop);

}  // namespace floeplan::avoidance
