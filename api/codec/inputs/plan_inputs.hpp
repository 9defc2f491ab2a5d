#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/geo/bounding_box.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "storage/repository/environment/environment_loader.hpp"

namespace floeplan::codec {

/// Inputs of process plan-route: what to plan, which data to use, and the user's name for the result.
/// `data.area`, `data.depart` and `data.dive_depth` follow from the request.
struct PlanInputs {
  planning::PlanRequest request;
  repository::EnvironmentQuery data;
  std::string name;
  std::vector<std::string> warnings;  // of a file that the places came from
};

/// Inputs of process evaluate-route: a given route, written out or named by the plan it belongs to.
struct EvaluateInputs {
  std::vector<geo::LonLat> route;      // empty when `plan_id` is given
  std::optional<std::string> plan_id;  // its waypoints are the route
  planning::PlanRequest request;       // departure, vehicle, margin; its places are the route's ends
  repository::EnvironmentQuery data;
  std::string name;
  std::vector<std::string> warnings;  // of the route: lines of its file, places that were given twice
};

/// Reads the `inputs` object of an execute request (or of a request file).
/// Errors   every violation at once, each with the JSON pointer of its value relative to `inputs` ("/depart")
[[nodiscard]] tl::expected<PlanInputs, core::Violations> parse_plan_inputs(const nlohmann::json& inputs);

/// Widens the data asked for to some kilometres round the way of a plan that was made, which may lead further round
/// than the request's own area reaches.
void cover_way(PlanInputs& inputs, const geo::BoundingBox& way);

[[nodiscard]] tl::expected<EvaluateInputs, core::Violations> parse_evaluate_inputs(
    const nlohmann::json& inputs);

/// What such an object says besides the route, for a route of at least two places that is known otherwise and whose
/// legs may be of any length.
[[nodiscard]] tl::expected<EvaluateInputs, core::Violations> parse_flight_inputs(
    const nlohmann::json& inputs, std::vector<geo::LonLat> route);

/// Whose data a plan for the request is made in: its planning area, so rounded that requests that differ little read
/// the same.
[[nodiscard]] geo::BoundingBox area_of_data(const planning::PlanRequest& request);

/// The inputs with every default written out and keys in a fixed order: the same request gives the same text.
[[nodiscard]] nlohmann::json to_json(const PlanInputs& inputs);
[[nodiscard]] nlohmann::json to_json(const EvaluateInputs& inputs);

/// Gives the evaluation its route, once the plan it names has been looked up; area and ends follow from it.
void set_route(EvaluateInputs& inputs, std::vector<geo::LonLat> route);

}  // namespace floeplan::codec
