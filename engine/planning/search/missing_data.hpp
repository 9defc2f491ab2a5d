#pragma once

#include <string>

#include "engine/geo/lon_lat.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan_request.hpp"

/// Messages about data that do not cover a place: the kind of data, their area, and where the place lies
/// relative to it. The environment holds data of the search area only, so the area named is the part of the
/// data inside it.
namespace floeplan::planning::search {

/// Why a start, a goal or a via point without a known depth cannot be used.
/// `place`    the stop in words, such as "the goal"
/// Requires   bathymetry in the environment
[[nodiscard]] messages::Message explain_missing_depth(const ocean::Environment& environment,
                                                      geo::LonLat where, const std::string& place);

/// Completes a refusal. If stops lie outside the currents, the result names all of them, with the first as its
/// place, instead of the place where the search ended. Otherwise a refusal for missing data also names the
/// data that end near the place that the search reached; and if the currents end before the route does, it
/// says that the vehicle may depart earlier, if the stored currents begin early enough.
[[nodiscard]] Infeasible with_missing_data(Infeasible why, const ocean::Environment& environment,
                                           const PlanRequest& request);

}  // namespace floeplan::planning::search
