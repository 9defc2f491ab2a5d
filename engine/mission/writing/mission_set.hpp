#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/mission/writing/mission_file.hpp"
#include "engine/mission/writing/mission_set_options.hpp"
#include "engine/planning/problem/plan.hpp"

namespace floeplan::mission {

/// Writes all files that a vehicle needs to fly the plan: a mission, the goto lists, and argument files for
/// yo, sample, prepare_to_dive and three or five surfacings.
/// Values   Depths, altitude, pitch and pump come from vehicle and plan. Waiting times and the order of
///          behaviors come from the vendor's stock missions. All other values keep the defaults of the vehicle's
///          dictionary. No factory setting (f_...) and no calibration is ever written
/// Depth    A glider overshoots its target and aborts at its overdepth, which is 15 % below the target, at
///          most the rating. So the target lies 10 % above the rating of a shallow vehicle, and 2 % above the
///          rating of a 1000 m vehicle
/// Surface  in open water at each waypoint and every three hours (a 1000 m vehicle: six), or at the plan's
///          interval
/// Ice      A plan that passes below ice or icebergs needs `under_ice`. Its yo climbs no higher, on all legs,
///          than the deepest upper turn that they demand on any leg. No surfacings at waypoints or at
///          intervals. Further files: the list of safe places that the stock recovery mission flies
///          (goto_l98.ma); the settings for ice, in the mission and once more as `ice_NN.mi`, to be loaded
///          alone
/// Thruster If the plan uses it from start to goal, it is on for all dives and climbs, at the vehicle's input
/// power. One yo cannot run it on some legs only: then it is off, and a warning names those legs
/// Shoals   One yo is flown on the whole route. The plan is refused where the sea is too shallow for it to
///          turn above the bed by the altimeter's margin, for example a yo that keeps below ice, over a bank
///          in open water
/// Errors   every violation at once; also those of write_goto_lists
/// Threads  may be called from several threads at once
[[nodiscard]] tl::expected<MissionFiles, core::Violations> write_mission_set(
    const planning::Plan& plan, const MissionSetOptions& options);

}  // namespace floeplan::mission
