#pragma once

#include <vector>

#include "engine/mission/checking/flight_route.hpp"
#include "engine/mission/checking/route_check.hpp"
#include "engine/mission/document/document.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::mission {

/// How the documents dive: the yo among them, or the one that a mission gives inline. Nothing without one.
[[nodiscard]] std::optional<DiveArguments> dive_of(const std::vector<Document>& documents);

/// Judges files that are to fly together and adds to the messages of each.
/// Together  argument files that a mission asks for and that are not among them; arguments that abort the mission
///           (a target below `overdepth`, a leg beyond `max_wpt_distance`, a list without a yo and the reverse)
/// Sea       every leg from `start` (or the first row) at the time at which the vehicle is on it: errors for what
///           endangers the vehicle, warnings for what is not known and for data that are missing, a note with the times
///           when all is clear
/// `request` departure, vehicle and margins; the depths of a yo among the files and its use of the thruster replace the
///           vehicle's
void check_flight(std::vector<Document>& documents, const ocean::Environment& environment,
                  std::optional<geo::LonLat> start, planning::PlanRequest request);

}  // namespace floeplan::mission
