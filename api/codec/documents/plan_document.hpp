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

/// The id of a plan for these inputs: a digest of the inputs and of all that the plan tells, its data with their hashes
/// included, but for words and for how the search went. What a person is told counts by its codes, and dangers and
/// cautions by their values, too: an iceberg that was not named before makes another plan. So the same inputs
/// on the same data have the same id, whatever the program that plans, as long as the same plan comes of them. Another
/// program, or a machine that is too slow for the whole refinement, may come to another plan or find another danger in
/// it, and nobody is to be given the old one for it.
[[nodiscard]] std::string plan_identity(const nlohmann::json& inputs, const planning::Plan& plan);

/// The answer when there is no plan: where, when, why, and what would help.
[[nodiscard]] nlohmann::json infeasible_document(const planning::Infeasible& infeasible,
                                                 const ocean::Environment& environment);

/// Reads a stored plan document back, for mission files and downloads.
/// Errors  std::runtime_error when the document was not written by plan_document
[[nodiscard]] planning::Plan parse_plan_document(const nlohmann::json& document);

/// The places of a plan document's waypoints.
[[nodiscard]] std::vector<geo::LonLat> route_of(const nlohmann::json& document);

}  // namespace floeplan::codec
