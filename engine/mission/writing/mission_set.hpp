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

/// Writes all that a vehicle needs to fly the plan: a mission, the goto lists, and an argument file each for yo,
/// sample and prepare_to_dive and for three or five surfacings.
/// Values   depths, altitude, pitch and pump come from vehicle and plan; waiting times and the order of behaviors are
///          those of the vendor's stock missions; what neither gives is left to the vehicle's dictionary. No
///          factory setting (f_...) and no calibration is ever written.
/// Depth    a glider overshoots its target and aborts at its overdepth, which lies 15 % below the target, at most at the
///          rating: the target stays 10 % above the rating of a shallow vehicle, 2 % above that of a 1000 m vehicle
/// Surface  in open water at each waypoint and every three hours (a 1000 m vehicle: six), or as the plan was asked to
/// Ice      a plan that passes below ice or icebergs needs `under_ice`, and its yo climbs no higher than the deepest
///          turn that they ask for anywhere, on all its legs. No surfacing at waypoints and none by the clock; the list of safe places that
///          the stock recovery mission flies (goto_l98.ma), the settings for ice in the mission, and once more as
///          `ice_NN.mi` to be loaded alone
/// Thruster on for all dives and climbs, at the input power of the vehicle profile, where the plan runs on it from
/// start to
///          goal; one yo cannot run it on some legs alone: then off, with a warning that names them
/// Shoals   one yo is flown on the whole way: refused where the sea on it leaves that no room to turn above the bed by
///          the altimeter's margin, as a yo that keeps below ice has none over a bank in open water
/// Errors   every violation at once; those of write_goto_lists too
/// Threads  may be called from several threads at once
[[nodiscard]] tl::expected<MissionFiles, core::Violations> write_mission_set(
    const planning::Plan& plan, const MissionSetOptions& options);

}  // namespace floeplan::mission
