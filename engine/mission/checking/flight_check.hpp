#pragma once

#include <vector>

#include "engine/mission/checking/flight_route.hpp"
#include "engine/mission/checking/route_check.hpp"
#include "engine/mission/document/document.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::mission {

/// The dives that the documents order: by a yo file among them, or a yo given inline in a mission. Empty
/// without a yo.
[[nodiscard]] std::optional<DiveArguments> dive_of(const std::vector<Document>& documents);

/// Checks files that are to be flown together, and adds messages to each of them.
/// Together  argument files that a mission names and that are missing; arguments that make the vehicle abort
///           (a target below `overdepth`, a leg beyond `max_wpt_distance`, a list without a yo or a yo
///           without a list)
/// Sea       every leg from `start` (or the first row), at the times at which the vehicle is on the leg
/// Messages  errors for what endangers the vehicle, warnings for unknowns and missing data; if all is clear,
///           a note with the times
/// `request` departure, vehicle and margins. If a yo is among the files, its depths and its use of the
/// thruster replace the values of the vehicle
void check_flight(std::vector<Document>& documents, const ocean::Environment& environment,
                  std::optional<geo::LonLat> start, planning::PlanRequest request);

}  // namespace floeplan::mission
