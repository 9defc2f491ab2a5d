#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/mission/writing/shoals.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::codec {

/// The plan as an IMC message PlanSpecification in JSON, which Neptus and its relatives read: a Goto for every place
/// but the start, each followed by the next when it is done, and a StationKeeping where the plan holds and the vehicle
/// may surface: that manoeuvre brings it up.
/// Units    latitude and longitude in radians (WGS84), z as depth in metres, speed in m/s, timeouts in seconds
/// Depth    to which the vehicle dives; above the sea bed by the vehicle's altimeter margin, at the shoalest place of
///          the leg, where that is known
/// `shoals` of each leg, as mission::shoals_along gives them; empty: not known, but for what the plan keeps at
/// waypoints
/// Timeout  twice as long as the plan takes; legs of more than 8 h are divided, as IMC's timeouts end at 65535 s
/// `hold_radius` of the circle that the vehicle keeps to
/// Source   LSTS, IMC message definitions (Goto, StationKeeping, PlanManeuver, PlanTransition, PlanSpecification; enumerations ZUnits
///          and SpeedUnits), and the plan of two Gotos in LSTS's description of how vehicles and Neptus talk
[[nodiscard]] std::string plan_imc(const planning::Plan& plan, const vehicle::GliderProfile& vehicle,
                                   const std::vector<std::optional<mission::Shoal>>& shoals,
                                   core::Metres hold_radius, const std::string& plan_id,
                                   const std::string& name, core::UtcTime generated);

}  // namespace floeplan::codec
