#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "engine/geo/lon_lat.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan.hpp"

namespace floeplan::codec {

/// The document of a plan for API and command line. Positions are rounded to 1e-7 degrees (1 cm); other
/// numbers are not rounded. An empty `plan_id` (a route that is not stored) becomes null.
[[nodiscard]] nlohmann::json plan_document(const planning::Plan& plan, const std::string& plan_id,
                                           const std::string& name);

/// The id of a plan: a digest of the inputs and of the plan's content, including its data with their hashes,
/// but without texts and without statistics of the search. Messages count by their codes; dangers and
/// cautions also by their values, so that an iceberg named for the first time gives a new id. The same inputs
/// on the same data thus give the same id with any version of the program, as long as they give the same
/// plan. Another version, or a slow machine that stops refinement early, may find another plan or another
/// danger; that plan must not be returned as the old one.
[[nodiscard]] std::string plan_identity(const nlohmann::json& inputs, const planning::Plan& plan);

/// The answer if there is no plan: where, when and why, and what would help.
[[nodiscard]] nlohmann::json infeasible_document(const planning::Infeasible& infeasible,
                                                 const ocean::Environment& environment);

/// Reads a stored plan document, for mission files and downloads.
/// Errors  std::runtime_error when plan_document did not write the document
[[nodiscard]] planning::Plan parse_plan_document(const nlohmann::json& document);

/// The positions of the waypoints in a plan document.
[[nodiscard]] std::vector<geo::LonLat> route_of(const nlohmann::json& document);

}  // namespace floeplan::codec
