#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "engine/geo/lon_lat.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan.hpp"

namespace floeplan::codec {

/// The plan as API and command line show it. Positions are rounded to 1e-7 degrees (1 cm); all else keeps its
/// digits. An empty `plan_id` (a route that is not stored) becomes null.
[[nodiscard]] nlohmann::json plan_document(const planning::Plan& plan, const std::string& plan_id,
                                           const std::string& name);

/// The answer when there is no plan: where, when, why, and what would help.
[[nodiscard]] nlohmann::json infeasible_document(const planning::Infeasible& infeasible,
                                                 const ocean::Environment& environment);

/// Reads a stored plan document back, for mission files and downloads.
/// Errors  std::runtime_error when the document was not written by plan_document
[[nodiscard]] planning::Plan parse_plan_document(const nlohmann::json& document);

/// The places of a plan document's waypoints.
[[nodiscard]] std::vector<geo::LonLat> route_of(const nlohmann::json& document);

}  // namespace floeplan::codec
