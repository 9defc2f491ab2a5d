#pragma once

#include <string>

#include "engine/geo/lon_lat.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan_request.hpp"

/// Names the data that do not cover a place: which kind, the area that they cover, and where the place lies from it.
/// The environment holds the data of the search area alone, so the area that is named is their part of it.
namespace floeplan::planning::search {

/// Why a start, a goal or a via point without a known depth cannot be used.
/// `place`    in words: "the goal"
/// Requires   bathymetry in the environment
[[nodiscard]] messages::Message explain_missing_depth(const ocean::Environment& environment,
                                                      geo::LonLat where, const std::string& place);

/// Adds to a refusal for want of data which stops lie outside the currents or, if none does, which data end at the place
/// that the search reached. Other refusals are returned as they are.
[[nodiscard]] Infeasible with_missing_data(Infeasible why, const ocean::Environment& environment,
                                           const PlanRequest& request);

}  // namespace floeplan::planning::search
