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
/// `data.area`, `data.depart` and `data.dive_depth` are derived from the request.
struct PlanInputs {
  planning::PlanRequest request;
  repository::EnvironmentQuery data;
  std::string name;
  std::vector<std::string> warnings;  // warnings about the file from which the waypoints come
};

/// Inputs of process evaluate-route: a given route, as positions or by the id of its plan.
struct EvaluateInputs {
  std::vector<geo::LonLat> route;      // empty when `plan_id` is given
  std::optional<std::string> plan_id;  // the route is the waypoints of this plan
  planning::PlanRequest request;       // departure, vehicle, margin; its start and goal are the route's ends
  repository::EnvironmentQuery data;
  std::string name;
  std::vector<std::string> warnings;  // warnings about the route: lines of its file, repeated positions
};

/// Reads the `inputs` object of an execute request (or of a request file).
/// Errors   every violation at once, each with the JSON pointer of its value relative to `inputs` ("/depart")
[[nodiscard]] tl::expected<PlanInputs, core::Violations> parse_plan_inputs(const nlohmann::json& inputs);

/// Extends the area of the data to some kilometres around the route of a finished plan, which may leave the
/// area derived from the request.
void cover_way(PlanInputs& inputs, const geo::BoundingBox& way);

[[nodiscard]] tl::expected<EvaluateInputs, core::Violations> parse_evaluate_inputs(
    const nlohmann::json& inputs);

/// Reads the inputs of an evaluation without a route. The route comes from elsewhere; it has at least two
/// waypoints, and its legs may have any length.
[[nodiscard]] tl::expected<EvaluateInputs, core::Violations> parse_flight_inputs(
    const nlohmann::json& inputs, std::vector<geo::LonLat> route);

/// The area of the data for a plan: its planning area, rounded so that similar requests read the same area.
[[nodiscard]] geo::BoundingBox area_of_data(const planning::PlanRequest& request);

/// The inputs with all defaults filled in and keys in a fixed order, so that equal requests give equal texts.
[[nodiscard]] nlohmann::json to_json(const PlanInputs& inputs);
[[nodiscard]] nlohmann::json to_json(const EvaluateInputs& inputs);

/// Sets the route of an evaluation after its plan was looked up; the area and the ends are derived from it.
void set_route(EvaluateInputs& inputs, std::vector<geo::LonLat> route);

}  // namespace floeplan::codec
